// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFeatureSizeRefinement
 * @brief   remeshes a surface between materials to the edge lengths it asks for
 *
 * Input: vtkPolyData of triangles with BoundaryLabels and, on the points, TargetEdgeLength (double, from
 * vtkFeatureSize; a painted or uniform array of that name can stand in). FeatureSize, MaterialFeatureSize,
 * PatchIds and the junction arrays are used where they are there.
 *
 * Output: vtkPolyData of new triangles with the same arrays, carried to the new points; other arrays are left
 * out.
 *
 * Bisection of edges that are too long, merging of those too short, swapping and relaxation along the
 * surface, in rounds.
 *
 * The volume of each material is kept, no two triangles intersect afterwards, tested exactly, junction curves
 * and border planes are kept. The result does not depend on the number of threads.
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
   * The largest distance to the input surface, a length; 0 stands for a tenth of the local feature size.
   * Default: 0.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkFeatureSizeRefinement() = default;
  ~vtkFeatureSizeRefinement() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFeatureSizeRefinement(const vtkFeatureSizeRefinement&) = delete;
  void operator=(const vtkFeatureSizeRefinement&) = delete;

  int Iterations = 6;
  double SplitRatio = 1.4;
  double MergeRatio = 0.7;
  double Tolerance = 0.0;
};

#endif
