// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCoreTetrahedra
 * @brief   fills closed surfaces with tetrahedra and adds no point on them
 *
 * Input: vtkPolyData of triangles with BoundaryLabels, closed around each material (port 1 of vtkPrismLayer),
 * or any closed surface of one orientation (material 1). With LayerHeight and LayerSide (double, 1 and 3
 * components) on the points, tetrahedra go well with the prisms behind the surface.
 *
 * Output, port 0: vtkUnstructuredGrid of tetrahedra with MaterialIds and LayerIds (0) on the cells,
 * LayerIndex (-1 inside) and InterfaceNodeIds on the points. Port 1: the triangles of the input that were
 * refused because they intersect; empty when all is well. Points are doubles in the input's unit of length;
 * the input's points come first.
 *
 * Constrained Delaunay tetrahedralization and refinement by TetGen, in a process of its own: H. Si, TetGen, a
 * Delaunay-based quality tetrahedral mesh generator, ACM Trans. Math. Softw. 41 (2015) 11,
 * doi:10.1145/2629697.
 *
 * Every triangle of the input is a face of one tetrahedron; all tetrahedra have positive volume.
 *
 * @warning The input must be closed and must not intersect itself: the error says where it does, port 1 shows
 * the triangles.
 * @warning TetGen falls under AGPL-3: so does a program built with it.
 *
 * @sa vtkPrismLayer vtkFluidSolidMesh
 */
#ifndef vtkCoreTetrahedra_h
#define vtkCoreTetrahedra_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkUnstructuredGridAlgorithm.h"

class LAMINAVOLUME_EXPORT vtkCoreTetrahedra : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkCoreTetrahedra* New();
  vtkTypeMacro(vtkCoreTetrahedra, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The largest ratio of circumradius to shortest edge, 1.2 or more. Default: 1.4.
   */
  vtkSetMacro(RadiusEdgeRatio, double);
  vtkGetMacro(RadiusEdgeRatio, double);
  ///@}

  ///@{
  /**
   * How much longer edges may be than those of the surface near them, above 0. Default: 1.3.
   */
  vtkSetMacro(SizeFactor, double);
  vtkGetMacro(SizeFactor, double);
  ///@}

  ///@{
  /**
   * The longest edge wanted, a length; 0 is no limit. Default: 0.
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
  vtkCoreTetrahedra();
  ~vtkCoreTetrahedra() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCoreTetrahedra(const vtkCoreTetrahedra&) = delete;
  void operator=(const vtkCoreTetrahedra&) = delete;

  double RadiusEdgeRatio = 1.4;
  double SizeFactor = 1.3;
  double MaximumEdge = 0.0;
  double MemoryLimit = 0.0;
};

#endif
