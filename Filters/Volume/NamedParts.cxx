// SPDX-License-Identifier: BSD-3-Clause
#include "NamedParts.h"

#include "Arrays.h"
#include "GridBridge.h"
#include "MeshArrayNames.h"
#include "PatchBridge.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <set>

namespace lamina
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// The cells of one material with the points they use; `nodes` gets the ids these had.
VolumeMesh TakeMaterial(const VolumeMesh& mesh, int material, std::vector<Id>& nodes)
{
  VolumeMesh part;
  std::vector<Id> numberOf(mesh.points.size(), -1);
  for (std::size_t c = 0; c < mesh.types.size(); ++c)
  {
    if (mesh.materials[c] != material)
    {
      continue;
    }
    for (Id i = mesh.offsets[c]; i < mesh.offsets[c + 1]; ++i)
    {
      const std::size_t p = Index(mesh.connectivity[Index(i)]);
      if (numberOf[p] < 0)
      {
        numberOf[p] = static_cast<Id>(nodes.size());
        nodes.push_back(static_cast<Id>(p));
        part.points.push_back(mesh.points[p]);
        part.layerIndex.push_back(mesh.layerIndex[p]);
        part.interfaceNodeIds.push_back(mesh.interfaceNodeIds[p]);
      }
      part.connectivity.push_back(numberOf[p]);
    }
    part.types.push_back(mesh.types[c]);
    part.offsets.push_back(static_cast<Id>(part.connectivity.size()));
    part.materials.push_back(material);
    part.layers.push_back(mesh.layers[c]);
  }
  return part;
}

/// Adds data sets under named nodes of the assembly.
class Collector
{
public:
  explicit Collector(vtkPartitionedDataSetCollection* output)
    : Output(output)
  {
    this->Assembly->SetRootNodeName("FluidSolidMesh");
    output->SetDataAssembly(this->Assembly);
  }
  void Add(const char* folder, const std::string& name, vtkDataSet* data)
  {
    const unsigned int index = this->Output->GetNumberOfPartitionedDataSets();
    vtkNew<vtkPartitionedDataSet> part;
    part->SetPartition(0, data);
    this->Output->SetPartitionedDataSet(index, part);
    this->Output->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name.c_str());
    const std::string path = std::string("/FluidSolidMesh/") + folder;
    int node = this->Assembly->GetFirstNodeByPath(path.c_str());
    node = node < 0 ? this->Assembly->AddNode(folder) : node;
    const int leaf = this->Assembly->AddNode(vtkDataAssembly::MakeValidNodeName(name.c_str()).c_str(), node);
    this->Assembly->SetAttribute(leaf, "label", name.c_str());
    this->Assembly->AddDataSetIndex(leaf, index);
  }

private:
  vtkPartitionedDataSetCollection* Output;
  vtkNew<vtkDataAssembly> Assembly;
};

} // namespace

void WriteNamedParts(const VolumeMesh& mesh, const MeshPatches& patches,
                     vtkPartitionedDataSetCollection* output)
{
  Collector collector(output);
  for (int material : std::set<int>(mesh.materials.begin(), mesh.materials.end()))
  {
    std::vector<Id> nodes;
    vtkNew<vtkUnstructuredGrid> grid;
    WriteGrid(TakeMaterial(mesh, material, nodes), grid);
    grid->GetPointData()->AddArray(MakeArray<vtkIdTypeArray>(names::GlobalNodeIds, nodes));
    collector.Add("Materials", MaterialName(patches.materialNames, material), grid);
  }
  const char* const folders[] = { "Interfaces", "Walls", "Borders", "Openings" };
  for (std::size_t p = 0; p < patches.patches.size(); ++p)
  {
    vtkNew<vtkPolyData> surface;
    WriteBoundary(mesh, patches, surface, static_cast<int>(p));
    collector.Add(folders[static_cast<int>(patches.patches[p].kind)], patches.patches[p].name, surface);
  }
}

} // namespace lamina
