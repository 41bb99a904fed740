// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFEBioWriter.h"

#include "SaveJob.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFEBioWriter);

namespace
{

using lamina::CellType;
using lamina::Id;

const char* CellName(CellType type, bool isQuadratic)
{
  switch (type)
  {
    case CellType::Wedge:
      return isQuadratic ? "penta15" : "penta6";
    case CellType::Pyramid:
      return "pyra5";
    default:
      return isQuadratic ? "tet10" : "tet4";
  }
}

const char* SideName(int nodes)
{
  switch (nodes)
  {
    case 3:
      return "tri3";
    case 4:
      return "quad4";
    case 6:
      return "tri6";
    default:
      return "quad8";
  }
}

void WriteIds(lamina::TextFile& file, const std::vector<Id>& ids)
{
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    file << (i == 0 ? "" : (i % 10 == 0 ? ",\n" : ",")) << ids[i] + 1;
  }
}

void WriteNodes(lamina::TextFile& file, const lamina::SaveJob& job)
{
  file << "    <Nodes name=\"all_nodes\">\n";
  const auto& points = job.model.mesh.points;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    file << "      <node id=\"" << p + 1 << "\">";
    file.Point(points[p], ",") << "</node>\n";
  }
  file << "    </Nodes>\n";
}

/// One Elements a material and type; the names of them a material.
std::map<int, std::vector<std::string>> WriteElements(lamina::TextFile& file, const lamina::SaveJob& job)
{
  std::map<int, std::vector<std::string>> domains;
  std::array<Id, 15> nodes;
  for (int material : job.materials)
  {
    for (CellType type : lamina::AllTypes)
    {
      const auto cells = lamina::CellsOf(job.model, material, type);
      if (cells.empty())
      {
        continue;
      }
      const std::string typeName = CellName(type, job.model.IsQuadratic());
      const std::string name = job.name.at(material) + "_" + typeName;
      domains[material].push_back(name);
      file << "    <Elements type=\"" << typeName << "\" name=\"" << name << "\">\n";
      for (Id cell : cells)
      {
        const int count = lamina::OrderedNodes(job.model, cell, lamina::EdgeNodes(type), nodes);
        file << "      <elem id=\"" << cell + 1 << "\">";
        for (int k = 0; k < count; ++k)
        {
          file << (k == 0 ? "" : ",") << nodes[static_cast<std::size_t>(k)] + 1;
        }
        file << "</elem>\n";
      }
      file << "    </Elements>\n";
    }
  }
  return domains;
}

void WriteSurface(lamina::TextFile& file, const lamina::SaveJob& job, const lamina::SideSet& set)
{
  file << "    <Surface name=\"" << set.name << "\">\n";
  std::array<Id, 8> nodes;
  Id number = 0;
  for (const lamina::Side& side : set.sides)
  {
    const int count = lamina::SideNodes(job.model, side, nodes);
    const char* name = SideName(count);
    file << "      <" << name << " id=\"" << ++number << "\">";
    for (int k = 0; k < count; ++k)
    {
      file << (k == 0 ? "" : ",") << nodes[static_cast<std::size_t>(k)] + 1;
    }
    file << "</" << name << ">\n";
  }
  file << "    </Surface>\n";
}

} // namespace

lamina::FormatLimits vtkFEBioWriter::Limits() const
{
  lamina::FormatLimits limits = lamina::LimitsOf("FEBio", lamina::LargestInt, 200);
  limits.holdsQuadratic = true;
  return limits;
}

void vtkFEBioWriter::Save(lamina::SaveJob& job)
{
  lamina::TextFile file(job.path);
  file << "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<febio_spec version=\"4.0\">\n";
  file << "  <!-- Fluid-solid mesh by Lamina"
       << (job.model.unit.empty()
             ? ""
             : ", lengths in " + lamina::FitNames(this->Limits(), { job.model.unit }, job.notes)[0])
       << " -->\n  <Module type=\"solid\"/>\n  <Mesh>\n";
  WriteNodes(file, job);
  if (!job.GoesOn(0.4, "Writing elements"))
  {
    return;
  }
  const auto domains = WriteElements(file, job);
  if (!job.GoesOn(0.8, "Writing sets"))
  {
    return;
  }
  for (const lamina::SideSet& set : job.sides)
  {
    file << "    <NodeSet name=\"" << set.name << "\">";
    WriteIds(file, lamina::NodesOf(job.model, set));
    file << "</NodeSet>\n";
  }
  for (const lamina::LayerSet& layer : job.layers)
  {
    file << "    <ElementSet name=\"" << layer.name << "\">";
    WriteIds(file, layer.cells);
    file << "</ElementSet>\n";
  }
  for (const lamina::SideSet& set : job.sides)
  {
    WriteSurface(file, job, set);
  }
  for (const auto& [material, names] : domains)
  {
    file << "    <PartList name=\"" << job.name.at(material) << "\">";
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      file << (i == 0 ? "" : ",") << names[i];
    }
    file << "</PartList>\n";
  }
  file << "  </Mesh>\n</febio_spec>\n";
  job.Keep(file.Close());
}
