// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFluidSolidMesh
 * @brief   joins the parts of a mesh into one conforming grid
 *
 * Input (repeatable): vtkUnstructuredGrid of tetrahedra, wedges and pyramids with MaterialIds on the cells:
 * the first outputs of vtkLayeredTetrahedra, vtkPrismLayer and vtkCoreTetrahedra, in any order and number.
 *
 * Output: one vtkUnstructuredGrid of all cells with MaterialIds and LayerIds on the cells, LayerIndex and
 * InterfaceNodeIds on the points. Points are doubles in the input's unit of length times Scale.
 *
 * Points with equal coordinates, bit for bit, become one.
 *
 * No point occurs twice, and no cell changes its shape. Reports of all inputs are kept in the field data.
 *
 * @warning Parts match only if they were made from the same surface.
 *
 * @sa vtkLayeredTetrahedra vtkPrismLayer vtkCoreTetrahedra vtkMeshAudit
 */
#ifndef vtkFluidSolidMesh_h
#define vtkFluidSolidMesh_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkUnstructuredGridAlgorithm.h"

class LAMINAVOLUME_EXPORT vtkFluidSolidMesh : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkFluidSolidMesh* New();
  vtkTypeMacro(vtkFluidSolidMesh, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A factor on all coordinates, above 0: 0.001 turns millimetres into metres. Default: 1.
   */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

protected:
  vtkFluidSolidMesh() = default;
  ~vtkFluidSolidMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFluidSolidMesh(const vtkFluidSolidMesh&) = delete;
  void operator=(const vtkFluidSolidMesh&) = delete;

  double Scale = 1.0;
};

#endif
