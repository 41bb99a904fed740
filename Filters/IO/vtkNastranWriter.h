// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNastranWriter
 * @brief   writes a mesh as Nastran bulk data (.bdf)
 *
 * Input: see vtkMeshModelWriter.
 *
 * Writes GRID* of 16 columns a number, CTETRA, CPENTA, CPYRAM with a property a material, the patches as
 * CTRIA3 and CQUAD4 with a property each (names in $HMNAME comments), and SET1 of the nodes of each patch.
 * Properties and materials themselves are the user's. Source: MSC Nastran Quick Reference Guide, bulk data
 * entries.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkNastranWriter_h
#define vtkNastranWriter_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkNastranWriter : public vtkMeshModelWriter
{
public:
  static vtkNastranWriter* New();
  vtkTypeMacro(vtkNastranWriter, vtkMeshModelWriter);

protected:
  vtkNastranWriter() = default;
  ~vtkNastranWriter() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkNastranWriter(const vtkNastranWriter&) = delete;
  void operator=(const vtkNastranWriter&) = delete;
};

#endif
