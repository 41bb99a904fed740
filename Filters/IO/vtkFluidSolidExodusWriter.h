// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFluidSolidExodusWriter
 * @brief   writes a mesh as an Exodus II file (.exo)
 *
 * Input: see vtkMeshModelWriter.
 *
 * Writes a block a material and type, a side set and a node set a patch, all with their names, and LayerIds
 * as an attribute. VTK's own writer is not used, as it drops the names of blocks. Source: Sjaardema, Schoof,
 * Yarberry: EXODUS II, a finite element data model, SAND92-2137.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkFluidSolidExodusWriter_h
#define vtkFluidSolidExodusWriter_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkFluidSolidExodusWriter : public vtkMeshModelWriter
{
public:
  static vtkFluidSolidExodusWriter* New();
  vtkTypeMacro(vtkFluidSolidExodusWriter, vtkMeshModelWriter);

protected:
  vtkFluidSolidExodusWriter() = default;
  ~vtkFluidSolidExodusWriter() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkFluidSolidExodusWriter(const vtkFluidSolidExodusWriter&) = delete;
  void operator=(const vtkFluidSolidExodusWriter&) = delete;
};

#endif
