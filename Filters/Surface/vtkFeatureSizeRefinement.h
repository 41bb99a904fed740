// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFeatureSizeRefinement
 * @brief   remeshes a surface between materials to the edge lengths it asks for
 *
 * Input: vtkPolyData of triangles with BoundaryLabels (without them a closed surface of material 1) and, on
 * the points, TargetEdgeLength (double, from vtkFeatureSize; another array can stand in, see TargetArray, or
 * one length for all, see EdgeLength). FeatureSize, MaterialFeatureSize, PatchIds and the junction arrays are
 * used where they are there.
 *
 * Output: vtkPolyData of new triangles with the same arrays, carried to the new points; other arrays are left
 * out. MeshingFlags (unsigned char) on the points is 16 where no direction into a material sees all its faces
 * around the point with a cosine of 0.4 or more (no good layer can stand there), else 0.
 *
 * Bisection of edges that are too long (along the longest edges: M.-C. Rivara, 1984), merging of those too
 * short, swapping and relaxation along the surface, in rounds; each edit is tested before it is made. With
 * TangentialAnisotropy lengths and shapes are those of a metric that shortens the direction of least
 * curvature by up to that factor: by as much as an edge may be longer there and rise no more over the surface
 * than one across.
 *
 * The volume of each material is kept, no two triangles intersect afterwards, tested exactly, junction curves
 * and border planes are kept, and neither surface is farther from the other than Tolerance, at the middles of
 * triangles and at five places of each edge. The result does not depend on the number of threads.
 *
 * @warning A TargetEdgeLength far below the input's edges makes very many triangles: their number grows with
 * its square.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkFeatureSize vtkLayeredTetrahedra vtkPrismLayer
 */
#ifndef vtkFeatureSizeRefinement_h
#define vtkFeatureSizeRefinement_h

#include "LaminaSurfaceModule.h" // For the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For the name of an array

class LAMINASURFACE_EXPORT vtkFeatureSizeRefinement : public vtkPolyDataAlgorithm
{
public:
  static vtkFeatureSizeRefinement* New();
  vtkTypeMacro(vtkFeatureSizeRefinement, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Rounds of bisection, merging, swapping and relaxation, 1 or more. Default: 6.
   */
  vtkSetMacro(Iterations, int);
  vtkGetMacro(Iterations, int);
  ///@}

  ///@{
  /**
   * One target for all edges, a length; 0: TargetArray says. Default: 0.
   */
  vtkSetMacro(EdgeLength, double);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /**
   * The array of target lengths on the points (one component, positive). Default: TargetEdgeLength.
   */
  vtkSetStdStringFromCharMacro(TargetArray);
  vtkGetCharFromStdStringMacro(TargetArray);
  ///@}

  ///@{
  /**
   * An edge longer than this times its target is bisected; above 1. Default: 1.4.
   */
  vtkSetMacro(SplitRatio, double);
  vtkGetMacro(SplitRatio, double);
  ///@}

  ///@{
  /**
   * An edge shorter than this times its target is merged; above 0 and below 1. Default: 0.7.
   */
  vtkSetMacro(MergeRatio, double);
  vtkGetMacro(MergeRatio, double);
  ///@}

  ///@{
  /**
   * The largest distance between input and output, looked at both ways, a length. 0 stands for the smaller of
   * a tenth of the local FeatureSize (a fifth of TargetEdgeLength where there is none) and half a mean edge
   * of the input, which on a surface from an image is less than half a voxel. Default: 0.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * How many times longer than TargetEdgeLength edges may be along the direction of least curvature, 1 to 4;
   * above 1 the input needs MaximumCurvature, MinimumCurvature and MaximumCurvatureDirection from
   * vtkFeatureSize. Default: 1.
   */
  vtkSetMacro(TangentialAnisotropy, double);
  vtkGetMacro(TangentialAnisotropy, double);
  ///@}

  ///@{
  /**
   * The memory that the filter may take, in GiB; it refuses what it estimates to take more. 0: what is free on
   * the machine. Default: 0.
   */
  vtkSetClampMacro(MemoryLimit, double, 0, 1e9);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkFeatureSizeRefinement();
  ~vtkFeatureSizeRefinement() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFeatureSizeRefinement(const vtkFeatureSizeRefinement&) = delete;
  void operator=(const vtkFeatureSizeRefinement&) = delete;

  int Iterations = 6;
  double EdgeLength = 0.0;
  std::string TargetArray;
  double SplitRatio = 1.4;
  double MergeRatio = 0.7;
  double Tolerance = 0.0;
  double TangentialAnisotropy = 1.0;
  double MemoryLimit = 0.0;
};

#endif
