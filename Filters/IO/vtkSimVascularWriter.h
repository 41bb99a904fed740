// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSimVascularWriter
 * @brief   writes a mesh as SimVascular's folder mesh-complete
 *
 * Input: see vtkMeshModelWriter.
 *
 * FileName is FOLDER/NAME.sv (or NAME.mesh.vtu): FOLDER gets NAME.mesh.vtu, NAME.exterior.vtp,
 * walls_combined.vtp and mesh-surfaces/<patch>.vtp with GlobalNodeID, GlobalElementID, ModelFaceID,
 * ModelRegionID. With several materials there is such a folder a material within FOLDER. Tetrahedra only.
 * Source: SimVascular documentation, meshing and svFSI guides.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkSimVascularWriter_h
#define vtkSimVascularWriter_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkSimVascularWriter : public vtkMeshModelWriter
{
public:
  static vtkSimVascularWriter* New();
  vtkTypeMacro(vtkSimVascularWriter, vtkMeshModelWriter);

protected:
  vtkSimVascularWriter() = default;
  ~vtkSimVascularWriter() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkSimVascularWriter(const vtkSimVascularWriter&) = delete;
  void operator=(const vtkSimVascularWriter&) = delete;
};

#endif
