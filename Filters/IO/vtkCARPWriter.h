// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCARPWriter
 * @brief   writes a mesh as openCARP files (.elem .pts .lon .vtx .surf)
 *
 * Input: see vtkMeshModelWriter.
 *
 * Writes NAME.pts in micrometres (if the unit is known, else as it is, with a warning), NAME.elem with the
 * material as tag, NAME.lon with the fibre of each cell (Fibers; without them 1 0 0, with a warning), and for
 * each patch NAME_<patch>.vtx and .surf. Tetrahedra only. Source: openCARP documentation, file formats.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkCARPWriter_h
#define vtkCARPWriter_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkCARPWriter : public vtkMeshModelWriter
{
public:
  static vtkCARPWriter* New();
  vtkTypeMacro(vtkCARPWriter, vtkMeshModelWriter);

protected:
  vtkCARPWriter() = default;
  ~vtkCARPWriter() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkCARPWriter(const vtkCARPWriter&) = delete;
  void operator=(const vtkCARPWriter&) = delete;
};

#endif
