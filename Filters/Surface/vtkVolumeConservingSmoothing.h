// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeConservingSmoothing
 * @brief   smooths a surface between materials and keeps the volume of each material
 *
 * Input: vtkPolyData of triangles with BoundaryLabels (from vtkMultimaterialMarchingCubes), or any closed
 * surface of one orientation, which is taken as material 1 in background.
 *
 * Output: the same triangles with moved points; arrays on points and triangles pass through, but for
 * FeatureSize, MaterialFeatureSize, TargetEdgeLength, the curvatures and MissingVolume, which no longer fit.
 * Field data: IntersectingPairs, LeastClearance and LeastAngle of the result. Lengths are in the unit of the
 * input.
 *
 * Edge relaxation that conserves volume: A. Kuprat, A. Khamayseh, D. George and L. Larkey, Volume conserving
 * smoothing for piecewise linear curves, surfaces, and triple lines, J. Comput. Phys. 172 (2001) 99-118,
 * doi:10.1006/jcph.2001.6816. Relaxations pass volume between neighbours only, so long flat steps of a
 * slightly tilted plane would need hundreds of sweeps: waves up to a length are levelled by implicit fairing
 * (M. Desbrun, M. Meyer, P. Schroeder and A. H. Barr, SIGGRAPH 1999) between the sweeps, inside the same
 * bounds.
 *
 * Every connected piece of a material ends with the volume of its voxels in the image, where the surface
 * comes from vtkMultimaterialMarchingCubes, else with the one it came with: to 1e-12 of itself or of 100
 * voxels. Small pieces that would need unsafe moves miss theirs and are listed in the report. No two
 * triangles intersect afterwards, tested exactly; sheets that face each other stay a quarter voxel apart, or
 * half of their first distance; triangles at an edge do not close below 45 degrees. Points of junction curves
 * and of border planes stay on them. The result does not depend on the number of threads.
 *
 * @warning Features of one or two voxels lose their edges but keep their volume: they become rounder and
 * longer or shorter.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkMultimaterialMarchingCubes vtkFeatureSize
 */
#ifndef vtkVolumeConservingSmoothing_h
#define vtkVolumeConservingSmoothing_h

#include "LaminaSurfaceModule.h" // For the export macro
#include "vtkPolyDataAlgorithm.h"

class LAMINASURFACE_EXPORT vtkVolumeConservingSmoothing : public vtkPolyDataAlgorithm
{
public:
  static vtkVolumeConservingSmoothing* New();
  vtkTypeMacro(vtkVolumeConservingSmoothing, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Passes over all edges, 0 or more. Default: 20.
   */
  vtkSetMacro(Sweeps, int);
  vtkGetMacro(Sweeps, int);
  ///@}

  ///@{
  /**
   * The share of each move that is made, above 0 and at most 1. Default: 1.
   */
  vtkSetMacro(Relaxation, double);
  vtkGetMacro(Relaxation, double);
  ///@}

  ///@{
  /**
   * How far a point may end from its start along its first normal, in mean edge lengths; above 0. Default:
   * 0.75.
   */
  vtkSetMacro(LargestDrift, double);
  vtkGetMacro(LargestDrift, double);
  ///@}

  ///@{
  /**
   * Waves up to about this length, in mean edge lengths, are levelled between the sweeps; 0 to 100, 0: none.
   * Longer ones than the staircase's take features with them. Default: 10.
   */
  vtkSetMacro(Wavelength, double);
  vtkGetMacro(Wavelength, double);
  ///@}

  ///@{
  /**
   * How far a point may end from its start in any direction, in mean edge lengths; above 0. Default: 1.5.
   */
  vtkSetMacro(LargestDisplacement, double);
  vtkGetMacro(LargestDisplacement, double);
  ///@}

  ///@{
  /**
   * Sweeping ends before Sweeps when the points move less than this in a sweep, root mean square, in voxels
   * (0.88 mean edge lengths); 0 or more, 0: never. Default: 0.002.
   */
  vtkSetMacro(Settled, double);
  vtkGetMacro(Settled, double);
  ///@}

  ///@{
  /**
   * Whether to smooth a surface that is open, meets itself or intersects: points at such places stay, no
   * intersections are added, and volumes are held as far as they are defined. Default: off, an error that
   * tells where.
   */
  vtkSetMacro(AcceptFaults, bool);
  vtkGetMacro(AcceptFaults, bool);
  vtkBooleanMacro(AcceptFaults, bool);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkVolumeConservingSmoothing() = default;
  ~vtkVolumeConservingSmoothing() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkVolumeConservingSmoothing(const vtkVolumeConservingSmoothing&) = delete;
  void operator=(const vtkVolumeConservingSmoothing&) = delete;

  int Sweeps = 20;
  double Relaxation = 1.0;
  double LargestDrift = 0.75;
  double LargestDisplacement = 1.5;
  double Wavelength = 10;
  double Settled = 0.002;
  bool AcceptFaults = false;
};

#endif
