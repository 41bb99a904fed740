// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLSDynaWriter
 * @brief   writes a mesh as an LS-DYNA keyword file (.k)
 *
 * Input: see vtkMeshModelWriter.
 *
 * Writes *NODE, *ELEMENT_SOLID with a *PART a material, *SET_NODE_LIST_TITLE and *SET_SEGMENT_TITLE a patch
 * and *SET_SOLID_TITLE a layer. Tetrahedra, pyramids and prisms are written as the degenerate hexahedra of
 * the manual; *CONTROL_SOLID has them sorted to their formulations. Materials (*MAT) are the user's. Source:
 * LS-DYNA Keyword User's Manual, Volume I.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkLSDynaWriter_h
#define vtkLSDynaWriter_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkLSDynaWriter : public vtkMeshModelWriter
{
public:
  static vtkLSDynaWriter* New();
  vtkTypeMacro(vtkLSDynaWriter, vtkMeshModelWriter);

protected:
  vtkLSDynaWriter() = default;
  ~vtkLSDynaWriter() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkLSDynaWriter(const vtkLSDynaWriter&) = delete;
  void operator=(const vtkLSDynaWriter&) = delete;
};

#endif
