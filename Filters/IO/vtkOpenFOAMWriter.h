// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenFOAMWriter
 * @brief   writes a mesh as an OpenFOAM case (polyMesh)
 *
 * Input: see vtkMeshModelWriter.
 *
 * FileName is CASE/NAME.foam; the mesh goes to CASE/constant/polyMesh: points, faces, owner, neighbour,
 * boundary, cellZones (a zone a material), faceZones (interfaces of shared nodes) and, in CASE/system, what
 * checkMesh needs if it is not there. Walls and borders are of type wall, openings of type patch. Source:
 * OpenFOAM user guide, chapter on the mesh.
 *
 * @sa vtkMeshModelWriter vtkFluidSolidMesh vtkPrismsToTetrahedra
 */
#ifndef vtkOpenFOAMWriter_h
#define vtkOpenFOAMWriter_h

#include "vtkMeshModelWriter.h"

class LAMINAIO_EXPORT vtkOpenFOAMWriter : public vtkMeshModelWriter
{
public:
  static vtkOpenFOAMWriter* New();
  vtkTypeMacro(vtkOpenFOAMWriter, vtkMeshModelWriter);

protected:
  vtkOpenFOAMWriter() = default;
  ~vtkOpenFOAMWriter() override = default;

  lamina::FormatLimits Limits() const override;
  void Save(lamina::SaveJob& job) override;

private:
  vtkOpenFOAMWriter(const vtkOpenFOAMWriter&) = delete;
  void operator=(const vtkOpenFOAMWriter&) = delete;
};

#endif
