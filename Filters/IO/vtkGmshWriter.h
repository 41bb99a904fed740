// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGmshWriter
 * @brief   writes a mesh as a Gmsh file (.msh), of version 4.1 or 2.2
 *
 * Input: see vtkMeshModelWriter.
 *
 * Writes ASCII with a physical volume a material and a physical surface a patch, whose triangles and quads
 * are elements of their own. Source: Gmsh reference manual, chapter on the MSH file format.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkGmshWriter_h
#define vtkGmshWriter_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkGmshWriter : public vtkMeshModelWriter
{
public:
  static vtkGmshWriter* New();
  vtkTypeMacro(vtkGmshWriter, vtkMeshModelWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The version of the format: 41 (4.1) or 22 (2.2). Default: 41.
   */
  vtkSetClampMacro(Version, int, 22, 41);
  vtkGetMacro(Version, int);
  ///@}

protected:
  vtkGmshWriter() = default;
  ~vtkGmshWriter() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkGmshWriter(const vtkGmshWriter&) = delete;
  void operator=(const vtkGmshWriter&) = delete;

  int Version = 41;
};

#endif
