// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMeshModelWriter
 * @brief   base of the writers that know materials, patches, node sets and layers
 *
 * Input: vtkUnstructuredGrid of tetrahedra, wedges and pyramids, or their quadratic forms, with MaterialIds
 * on the cells (without them all cells are of material 1), as vtkFluidSolidMesh makes it. The patches of its
 * field data become sets; if there are none, or if cells were taken away since, they are found anew, without
 * openings (a warning tells). LayerIds become sets of cells where the format has such.
 *
 * Reads the grid, tests whether the format can hold it, fits the names to the format (warnings tell which
 * ones changed) and calls Save of the format. Files appear under their names when they are complete.
 *
 * Errors (GetErrorCode is then not 0): cells or ids that the format cannot hold, no permission, a full disk.
 */
#ifndef vtkMeshModelWriter_h
#define vtkMeshModelWriter_h

#include "LaminaIOModule.h" // For the export macro
#include "vtkWriter.h"

#include <memory> // For the names

namespace lamina
{
struct FormatLimits;
struct SaveJob;
} // namespace lamina
class vtkUnstructuredGrid;

class LAMINAIO_EXPORT vtkMeshModelWriter : public vtkWriter
{
public:
  vtkAbstractTypeMacro(vtkMeshModelWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write, or of a format of several files the one whose name the others derive theirs from.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkMeshModelWriter() = default;
  ~vtkMeshModelWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  /// What the format can hold.
  virtual lamina::FormatLimits Limits() const = 0;
  /// Write the files of the job; a failure goes into job.status.
  virtual void Save(lamina::SaveJob& job) = 0;

  char* FileName = nullptr;

private:
  vtkMeshModelWriter(const vtkMeshModelWriter&) = delete;
  void operator=(const vtkMeshModelWriter&) = delete;
};

#endif
