// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFEBioWriter
 * @brief   writes a mesh as an FEBio file (.feb), version 4.0
 *
 * Input: see vtkMeshModelWriter.
 *
 * Writes Nodes, Elements (tet4, penta6, pyra5, tet10, penta15) a material and type, a Surface and a NodeSet a
 * patch, an ElementSet a layer and a PartList a material. Material laws are the user's. Source: FEBio User's
 * Manual, section Mesh.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkFEBioWriter_h
#define vtkFEBioWriter_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkFEBioWriter : public vtkMeshModelWriter
{
public:
  static vtkFEBioWriter* New();
  vtkTypeMacro(vtkFEBioWriter, vtkMeshModelWriter);

protected:
  vtkFEBioWriter() = default;
  ~vtkFEBioWriter() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkFEBioWriter(const vtkFEBioWriter&) = delete;
  void operator=(const vtkFEBioWriter&) = delete;
};

#endif
