// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMeshEstimate
 * @brief   tells how many cells a surface will become, and the memory that takes
 *
 * Input: vtkPolyData of triangles with BoundaryLabels and TargetEdgeLength, from vtkFeatureSize; a refined
 * surface will do as well.
 *
 * Output: vtkTable with a row for each stage that is still to come, from Surface Refinement to Mesh Audit,
 * and one for all: Stage (text), Cells (vtkIdType) and Memory (double, MB, at the stage's peak beside what
 * those before it have left; for all: the largest sum).
 *
 * Cells are told from the area of the triangles and their target edges, by ratios measured on phantoms and
 * scans: within a quarter of the truth on these. Nothing is meshed.
 *
 * @warning Where the memory is more than what is free, this is a warning of the filter.
 *
 * @sa vtkFeatureSize vtkLayeredTetrahedra vtkPrismLayer
 */
#ifndef vtkMeshEstimate_h
#define vtkMeshEstimate_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkTableAlgorithm.h"

#include <vector> // For the list of materials

class LAMINAVOLUME_EXPORT vtkMeshEstimate : public vtkTableAlgorithm
{
public:
  static vtkMeshEstimate* New();
  vtkTypeMacro(vtkMeshEstimate, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The materials that become prisms and core tetrahedra; all others become layered tetrahedra. Those that
   * the surface lacks do not count. Default: 2, blood.
   */
  void AddFluidMaterial(int material);
  void ClearFluidMaterials();
  int GetNumberOfFluidMaterials() { return static_cast<int>(this->FluidMaterials.size()); }
  int GetFluidMaterial(int index);
  ///@}

  ///@{
  /**
   * Layers of tetrahedra across a solid's wall, 1 or more. Default: 6.
   */
  vtkSetClampMacro(Layers, int, 1, 100);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /**
   * Layers of prisms on a fluid's walls, 0 or more. Default: 5.
   */
  vtkSetClampMacro(PrismLayers, int, 0, VTK_INT_MAX);
  vtkGetMacro(PrismLayers, int);
  ///@}

  ///@{
  /**
   * The memory there is, in GiB; 0: what is free on the machine. Default: 0.
   */
  vtkSetClampMacro(MemoryLimit, double, 0, 1e9);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkMeshEstimate() = default;
  ~vtkMeshEstimate() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshEstimate(const vtkMeshEstimate&) = delete;
  void operator=(const vtkMeshEstimate&) = delete;

  std::vector<int> FluidMaterials{ 2 };
  int Layers = 6;
  int PrismLayers = 5;
  double MemoryLimit = 0.0;
};

#endif
