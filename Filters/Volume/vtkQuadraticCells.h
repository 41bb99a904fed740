// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkQuadraticCells
 * @brief   gives every edge a node in its middle, on the smoothed surface where the cells stay valid
 *
 * Input, port 0: vtkUnstructuredGrid of tetrahedra, wedges and pyramids, as vtkFluidSolidMesh makes it. Port
 * 1 (optional): vtkPolyData, the surface the nodes go to, such as the output of vtkVolumeConservingSmoothing.
 *
 * Output: vtkUnstructuredGrid of quadratic tetrahedra (10 nodes), wedges (15) and pyramids (13) with the
 * input's cells in their order, its arrays on cells, its field data (the patches among it), and on points
 * LayerIndex, InterfaceNodeIds, GlobalNodeIds; added points stand last.
 *
 * Nodes of edges on one interface or wall patch go to the closest point of the surface, at most LargestOffset
 * edge lengths away; edges on rims, plane ends and of pyramids stay straight. A cell of which a Bernstein
 * coefficient of the Jacobian is not positive gets straight edges again (Johnen, Remacle, Geuzaine:
 * Geometrical validity of curvilinear finite elements, Journal of Computational Physics 233, 2013).
 *
 * Every cell's Jacobian is positive everywhere if the input's are.
 *
 * @sa vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkQuadraticCells_h
#define vtkQuadraticCells_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkUnstructuredGridAlgorithm.h"

class LAMINAVOLUME_EXPORT vtkQuadraticCells : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkQuadraticCells* New();
  vtkTypeMacro(vtkQuadraticCells, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The factor on the coordinates of the surface to match the grid, above 0. Default: 1.
   */
  vtkSetMacro(SurfaceScale, double);
  vtkGetMacro(SurfaceScale, double);
  ///@}

  ///@{
  /**
   * The farthest that a node goes from its edge's middle, in edge lengths, from 0 to 0.5. Default: 0.25.
   */
  vtkSetMacro(LargestOffset, double);
  vtkGetMacro(LargestOffset, double);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkQuadraticCells();
  ~vtkQuadraticCells() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkQuadraticCells(const vtkQuadraticCells&) = delete;
  void operator=(const vtkQuadraticCells&) = delete;

  double SurfaceScale = 1.0;
  double LargestOffset = 0.25;
};

#endif
