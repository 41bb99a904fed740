// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAbaqusWriter
 * @brief   writes a mesh as an Abaqus input file (.inp)
 *
 * Input: see vtkMeshModelWriter.
 *
 * Writes *NODE, *ELEMENT (C3D4, C3D6, C3D5; C3D10, C3D15) with an element set a material, an element set a
 * layer, and a node set and a *SURFACE of element faces a patch. Reads into Abaqus and, without pyramids,
 * into CalculiX. Source: Abaqus Keywords Reference Guide; CalculiX CrunchiX manual.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkAbaqusWriter_h
#define vtkAbaqusWriter_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkAbaqusWriter : public vtkMeshModelWriter
{
public:
  static vtkAbaqusWriter* New();
  vtkTypeMacro(vtkAbaqusWriter, vtkMeshModelWriter);

protected:
  vtkAbaqusWriter() = default;
  ~vtkAbaqusWriter() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkAbaqusWriter(const vtkAbaqusWriter&) = delete;
  void operator=(const vtkAbaqusWriter&) = delete;
};

#endif
