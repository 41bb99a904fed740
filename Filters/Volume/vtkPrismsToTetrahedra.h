// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPrismsToTetrahedra
 * @brief   cuts wedges and pyramids into tetrahedra that match across every face
 *
 * Input: vtkUnstructuredGrid of tetrahedra, wedges and pyramids (MaterialIds on the cells; without them all
 * cells count as material 1), as vtkFluidSolidMesh makes it.
 *
 * Output: vtkUnstructuredGrid of tetrahedra with MaterialIds, LayerIds, LayerIndex, InterfaceNodeIds and
 * GlobalNodeIds; the patches of the field data are carried over. Points keep their order; points in the
 * middle of cells, where there are any, stand last.
 *
 * Each quad is cut by the diagonal through its node of the smallest id, so that the cells on both sides agree
 * (Dompierre, Labbe, Vallet, Camarero: How to subdivide pyramids, prisms, and hexahedra into tetrahedra, 8th
 * International Meshing Roundtable, 1999). A cell that would not be positive so gets a point in its middle,
 * or one of its quads the other diagonal.
 *
 * Every tetrahedron is positive, by exact predicates; a conforming grid stays conforming; volumes of
 * materials change only by the warp of outer quads.
 *
 * @warning Inverted or flat prisms are an error: run vtkMeshAudit to find them.
 *
 * @sa vtkFluidSolidMesh vtkQuadraticCells
 */
#ifndef vtkPrismsToTetrahedra_h
#define vtkPrismsToTetrahedra_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkUnstructuredGridAlgorithm.h"

class LAMINAVOLUME_EXPORT vtkPrismsToTetrahedra : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkPrismsToTetrahedra* New();
  vtkTypeMacro(vtkPrismsToTetrahedra, vtkUnstructuredGridAlgorithm);

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkPrismsToTetrahedra() = default;
  ~vtkPrismsToTetrahedra() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPrismsToTetrahedra(const vtkPrismsToTetrahedra&) = delete;
  void operator=(const vtkPrismsToTetrahedra&) = delete;
};

#endif
