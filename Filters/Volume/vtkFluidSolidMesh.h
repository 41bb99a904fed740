// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFluidSolidMesh
 * @brief   joins the parts of a mesh into one conforming grid with named patches
 *
 * Input, port 0 (repeatable): vtkUnstructuredGrid of tetrahedra, wedges and pyramids with MaterialIds on the
 * cells: the first outputs of vtkLayeredTetrahedra, vtkPrismLayer and vtkCoreTetrahedra, in any order and
 * number. Port 1 (optional): the vtkPolyData that the parts were made from, whose PatchIds tell openings and
 * plane ends of the outer boundary.
 *
 * Output, port 0: one vtkUnstructuredGrid of all cells with MaterialIds and LayerIds on the cells,
 * LayerIndex, InterfaceNodeIds, GlobalNodeIds and, with doubled nodes, TwinNodeIds (vtkIdType, -1: none) on
 * the points. Points are doubles in the input's unit of length times Scale. The field data holds the patches
 * (PatchNames, PatchKinds, PatchMaterials, PatchFaces), the names of materials, LengthUnit and LengthScale.
 * Port 1: vtkPolyData, all patches: triangles and quads with PatchIds (index into PatchNames) and
 * BoundaryLabels, normals from the first material to the second, points with GlobalNodeIds.
 * Port 2: vtkTable, a row a patch: Name, Kind, MaterialA, MaterialB, Faces, Area, X, Y, Z.
 * Port 3: vtkPartitionedDataSetCollection of the materials and patches with an assembly that names them;
 * empty unless NamedParts is on.
 *
 * Points with equal coordinates, bit for bit, become one. Patches are faces of one kind and material pair
 * that are connected through edges, numbered by size and place so that another mesh size gives the same
 * names.
 *
 * No point occurs twice (but for the doubled ones), and no cell changes its shape. Reports of all inputs are
 * kept in the field data.
 *
 * @warning Parts match only if they were made from the same surface. Without the surface all outer faces are
 * walls.
 *
 * @sa vtkLayeredTetrahedra vtkPrismLayer vtkCoreTetrahedra vtkMeshAudit
 */
#ifndef vtkFluidSolidMesh_h
#define vtkFluidSolidMesh_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // For names and unit
#include <vector> // For the fluids

class LAMINAVOLUME_EXPORT vtkFluidSolidMesh : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkFluidSolidMesh* New();
  vtkTypeMacro(vtkFluidSolidMesh, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InterfaceNodesType
  {
    SHARED = 0,
    DOUBLED = 1
  };

  ///@{
  /**
   * A factor on all coordinates, above 0: 0.001 turns millimetres into metres. Default: 1.
   */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * The unit of length of the output, after Scale, as text that travels into every file. Default: "", which
   * says nothing.
   */
  vtkSetStdStringFromCharMacro(Unit);
  vtkGetCharFromStdStringMacro(Unit);
  ///@}

  ///@{
  /**
   * Names of materials and patches: "1=tissue; 2=blood; wall_tissue_1=epicardium". Default: "".
   */
  vtkSetStdStringFromCharMacro(Names);
  vtkGetCharFromStdStringMacro(Names);
  ///@}

  ///@{
  /**
   * Whether fluids and solids share the nodes of their interfaces, or have coincident ones of their own with
   * TwinNodeIds as the map. Default: SHARED.
   */
  vtkSetClampMacro(InterfaceNodes, int, SHARED, DOUBLED);
  vtkGetMacro(InterfaceNodes, int);
  ///@}

  ///@{
  /**
   * The materials that get nodes of their own where nodes are doubled. Default: 2.
   */
  void AddFluidMaterial(int material);
  void ClearFluidMaterials();
  int GetNumberOfFluidMaterials() const { return static_cast<int>(this->FluidMaterials.size()); }
  int GetFluidMaterial(int index) const { return this->FluidMaterials[static_cast<std::size_t>(index)]; }
  ///@}

  ///@{
  /**
   * Whether port 3 is filled, which takes the memory of a second mesh. Default: off.
   */
  vtkSetMacro(NamedParts, bool);
  vtkGetMacro(NamedParts, bool);
  vtkBooleanMacro(NamedParts, bool);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkFluidSolidMesh();
  ~vtkFluidSolidMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFluidSolidMesh(const vtkFluidSolidMesh&) = delete;
  void operator=(const vtkFluidSolidMesh&) = delete;

  double Scale = 1.0;
  std::string Unit;
  std::string Names;
  int InterfaceNodes = SHARED;
  std::vector<int> FluidMaterials{ 2 };
  bool NamedParts = false;
};

#endif
