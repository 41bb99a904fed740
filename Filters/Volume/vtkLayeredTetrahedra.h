// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLayeredTetrahedra
 * @brief   fills the solid materials of a surface with layers of tetrahedra
 *
 * Input: vtkPolyData of triangles with BoundaryLabels and, on the points, MaterialFeatureSize (double, from
 * vtkFeatureSize), usually refined by vtkFeatureSizeRefinement.
 *
 * Output, port 0: vtkUnstructuredGrid of tetrahedra with MaterialIds and LayerIds (int, 1 touches a wall,
 * growing inwards, 0 core) on the cells, LayerIndex (int, 0 on a wall, -1 in a core) and InterfaceNodeIds
 * (vtkIdType, the surface point a node is, else -1) on the points. Port 1: the input surface with
 * LayersAchieved (int) and LayerFraction (double, the share of the asked thickness) on its triangles. Points
 * are doubles in the input's unit of length.
 *
 * Points are offset inwards from the walls along directions that see all faces around them, by shares of the
 * feature size, and joined by tetrahedra; what is left between opposite walls is filled by constrained
 * Delaunay (TetGen: H. Si, ACM Trans. Math. Softw. 41 (2015) 11, doi:10.1145/2629697). After A. P. Kuprat and
 * D. R. Einstein, J. Comput. Phys. 228 (2009) 619-640.
 *
 * Every triangle of a wall belongs unchanged to one tetrahedron, no point is added on it, all tetrahedra have
 * positive volume.
 *
 * @warning Where a wall folds sharply layers are thinner or fewer: see LayersAchieved on port 1.
 * @warning A material named in SolidMaterials that the surface lacks is an error.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkFeatureSizeRefinement vtkPrismLayer vtkFluidSolidMesh
 */
#ifndef vtkLayeredTetrahedra_h
#define vtkLayeredTetrahedra_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <vector> // For the list of materials

class LAMINAVOLUME_EXPORT vtkLayeredTetrahedra : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkLayeredTetrahedra* New();
  vtkTypeMacro(vtkLayeredTetrahedra, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The materials to fill. Default: none, which stands for all materials but the fluids.
   */
  void AddSolidMaterial(int material);
  void ClearSolidMaterials();
  int GetNumberOfSolidMaterials() { return static_cast<int>(this->SolidMaterials.size()); }
  int GetSolidMaterial(int index);
  ///@}

  ///@{
  /**
   * The fluids, left out while SolidMaterials is empty. Default: 2, blood.
   */
  void AddFluidMaterial(int material);
  void ClearFluidMaterials();
  int GetNumberOfFluidMaterials() { return static_cast<int>(this->FluidMaterials.size()); }
  int GetFluidMaterial(int index);
  ///@}

  ///@{
  /**
   * Layers across a wall, 1 or more. Default: 6.
   */
  vtkSetMacro(Layers, int);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /**
   * The length of an edge along the wall over the thickness of a layer, above 0. Default: 2.
   */
  vtkSetMacro(Anisotropy, double);
  vtkGetMacro(Anisotropy, double);
  ///@}

  ///@{
  /**
   * The thickness of a layer over that of the one before it, inwards, above 0. Default: 1.
   */
  vtkSetMacro(Growth, double);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * The largest ratio of circumradius to shortest edge in the core, 1.2 or more. Default: 1.4.
   */
  vtkSetMacro(RadiusEdgeRatio, double);
  vtkGetMacro(RadiusEdgeRatio, double);
  ///@}

  ///@{
  /**
   * How much longer edges of the core may be than those of the surface near them, above 0. Default: 1.3.
   */
  vtkSetMacro(SizeFactor, double);
  vtkGetMacro(SizeFactor, double);
  ///@}

  ///@{
  /**
   * The longest edge wanted in the core, a length; 0 is no limit. Default: 0.
   */
  vtkSetMacro(MaximumEdge, double);
  vtkGetMacro(MaximumEdge, double);
  ///@}

  ///@{
  /**
   * The memory that the filter may take, in GiB; it refuses what it estimates to take more. 0: what is free on
   * the machine. Default: 0.
   */
  vtkSetClampMacro(MemoryLimit, double, 0, 1e9);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkLayeredTetrahedra();
  ~vtkLayeredTetrahedra() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLayeredTetrahedra(const vtkLayeredTetrahedra&) = delete;
  void operator=(const vtkLayeredTetrahedra&) = delete;

  std::vector<int> SolidMaterials;
  std::vector<int> FluidMaterials{ 2 };
  int Layers = 6;
  double Anisotropy = 2.0;
  double Growth = 1.0;
  double RadiusEdgeRatio = 1.4;
  double SizeFactor = 1.3;
  double MaximumEdge = 0.0;
  double MemoryLimit = 0.0;
};

#endif
