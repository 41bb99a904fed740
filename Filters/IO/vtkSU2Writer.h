// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSU2Writer
 * @brief   writes a mesh as SU2 files (.su2)
 *
 * Input: see vtkMeshModelWriter.
 *
 * Writes a marker a patch. SU2 has no materials within a file: with several of them there is a file a
 * material, NAME_<material>.su2, and both sides of an interface have a marker of its name. Source: SU2
 * documentation, Mesh File.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkSU2Writer_h
#define vtkSU2Writer_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkSU2Writer : public vtkMeshModelWriter
{
public:
  static vtkSU2Writer* New();
  vtkTypeMacro(vtkSU2Writer, vtkMeshModelWriter);

protected:
  vtkSU2Writer() = default;
  ~vtkSU2Writer() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkSU2Writer(const vtkSU2Writer&) = delete;
  void operator=(const vtkSU2Writer&) = delete;
};

#endif
