// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMeshAudit
 * @brief   tests a mesh or a surface for everything a solver relies on
 *
 * Input, port 0: vtkUnstructuredGrid of tetrahedra, wedges and pyramids (MaterialIds on the cells; without
 * them all cells count as material 1), or vtkPolyData of triangles (BoundaryLabels, or a closed surface).
 * Port 1, optional: the vtkPolyData that a grid was made from, with which interfaces and enclosed volumes are
 * tested too. Port 2, optional: the vtkImageData with MaterialIds, with whose voxels volumes and interfaces
 * are compared; SurfaceScale holds for it too.
 *
 * Output, port 0: the input with MeshQuality (double; tetrahedra: 3 r/R, prisms: scaled aspect ratio; grids
 * only) and MeshingFlags (unsigned char: 1 inverted, 2 bad quality, 4 not conforming, 8 overlap) on its
 * cells. Port 1: vtkTable, a row a figure or finding, with the columns Name, Material (-1: all), Value and
 * Text.
 *
 * Grids: conformity of faces, orientation by exact predicates and Bernstein coefficients, overlap by random
 * sample points of a fixed seed, volumes of the isoparametric cells against those enclosed, quality, gaps and
 * hanging nodes, cells that occur twice, twins of doubled nodes (TwinNodeIds), and the patches of the field
 * data: complete, closed, in order and what their names say. Surfaces: closed, manifold orientation of each
 * material, no intersections (exact), points used once, triangles with an area.
 *
 * The result does not depend on the number of threads. An audit that finds something wrong still succeeds:
 * see GetPassed.
 *
 * @warning Overlap of cells is sampled, not proven.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkFluidSolidMesh
 */
#ifndef vtkMeshAudit_h
#define vtkMeshAudit_h

#include "LaminaMeshModule.h" // For the export macro
#include "vtkDataObjectAlgorithm.h"

#include <string> // For the report

class vtkDataSet;
class vtkImageData;
class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

class LAMINAMESH_EXPORT vtkMeshAudit : public vtkDataObjectAlgorithm
{
public:
  static vtkMeshAudit* New();
  vtkTypeMacro(vtkMeshAudit, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The quality 3 r/R below which a tetrahedron counts as bad, from 0 to 1. Default: 0.1.
   */
  vtkSetMacro(QualityGate, double);
  vtkGetMacro(QualityGate, double);
  ///@}

  ///@{
  /**
   * The relative difference allowed between cells and enclosed volume, above 0. Default: 1e-9.
   */
  vtkSetMacro(VolumeTolerance, double);
  vtkGetMacro(VolumeTolerance, double);
  ///@}

  ///@{
  /**
   * The number of random points tested for lying in exactly one cell, 0 or more. Default: 2000.
   */
  vtkSetMacro(OverlapSamples, vtkIdType);
  vtkGetMacro(OverlapSamples, vtkIdType);
  ///@}

  ///@{
  /**
   * The factor on the coordinates of the surface of port 1 to match the grid, above 0. Default: 1.
   */
  vtkSetMacro(SurfaceScale, double);
  vtkGetMacro(SurfaceScale, double);
  ///@}

  /**
   * True if the last run found nothing wrong.
   */
  vtkGetMacro(Passed, bool);

  /**
   * The last run's report as JSON.
   */
  const char* GetReportAsJSON() { return this->ReportText.c_str(); }

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkMeshAudit();
  ~vtkMeshAudit() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshAudit(const vtkMeshAudit&) = delete;
  void operator=(const vtkMeshAudit&) = delete;

  /// Run the audit of one kind of input, put the flags on `output` and keep verdict and text.
  int AuditGrid(vtkUnstructuredGrid* input, vtkPolyData* surface, vtkImageData* image, vtkDataSet* output,
                vtkTable* table);
  int AuditSurface(vtkPolyData* input, vtkDataSet* output, vtkTable* table);

  double QualityGate = 0.1;
  double VolumeTolerance = 1e-9;
  vtkIdType OverlapSamples = 2000;
  double SurfaceScale = 1.0;
  bool Passed = false;
  std::string ReportText;
};

#endif
