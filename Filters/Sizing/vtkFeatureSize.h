// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFeatureSize
 * @brief   measures how thick each material is under a surface, and derives the edge lengths to mesh it with
 *
 * Input: vtkPolyData of triangles with BoundaryLabels, or any closed surface of one orientation (material 1
 * in background).
 *
 * Output: the same surface with, on its points, MaterialFeatureSize (double, a component a material, named by
 * its id; NaN where the point does not touch it), FeatureSize (double, the governing one) and
 * TargetEdgeLength (double). All are lengths in the unit of the input. Other arrays pass through.
 *
 * Rays in a narrow cone around the normal, into the materials on both sides, measure the distance to the
 * opposite wall; sizes are cut to the range asked for and limited in slope along the surface. After A. P.
 * Kuprat and D. R. Einstein, An anisotropic scale-invariant unstructured mesh generator suitable for
 * volumetric imaging data, J. Comput. Phys. 228 (2009) 619-640, doi:10.1016/j.jcp.2008.09.030.
 *
 * TargetEdgeLength is FeatureSize times Anisotropy over Layers. Along each edge, sizes differ by at most
 * Gradient times its length. The result does not depend on the number of threads.
 *
 * @warning The surface must not intersect itself: rays would stop short. Run vtkMeshAudit on surfaces from
 * elsewhere.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkVolumeConservingSmoothing vtkFeatureSizeRefinement
 */
#ifndef vtkFeatureSize_h
#define vtkFeatureSize_h

#include "LaminaSizingModule.h" // For the export macro
#include "vtkPolyDataAlgorithm.h"

class LAMINASIZING_EXPORT vtkFeatureSize : public vtkPolyDataAlgorithm
{
public:
  static vtkFeatureSize* New();
  vtkTypeMacro(vtkFeatureSize, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Layers asked for across a feature, 1 or more. Default: 6.
   */
  vtkSetMacro(Layers, int);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /**
   * The length of an edge along the wall over the thickness of a layer, above 0. Default: 2.
   */
  vtkSetMacro(Anisotropy, double);
  vtkGetMacro(Anisotropy, double);
  ///@}

  ///@{
  /**
   * The least feature size, a length; 0 stands for 2.6 mean edge lengths of the input. Default: 0.
   */
  vtkSetMacro(MinimumSize, double);
  vtkGetMacro(MinimumSize, double);
  ///@}

  ///@{
  /**
   * The largest feature size, a length; 0 stands for 20 mean edge lengths of the input. Default: 0.
   */
  vtkSetMacro(MaximumSize, double);
  vtkGetMacro(MaximumSize, double);
  ///@}

  ///@{
  /**
   * The largest slope of the sizes along the surface, above 0. Default: 0.3.
   */
  vtkSetMacro(Gradient, double);
  vtkGetMacro(Gradient, double);
  ///@}

  ///@{
  /**
   * Half the opening angle of the cone of rays, in degrees, from 0 to below 90. Default: 15.
   */
  vtkSetMacro(ConeAngle, double);
  vtkGetMacro(ConeAngle, double);
  ///@}

protected:
  vtkFeatureSize() = default;
  ~vtkFeatureSize() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFeatureSize(const vtkFeatureSize&) = delete;
  void operator=(const vtkFeatureSize&) = delete;

  int Layers = 6;
  double Anisotropy = 2.0;
  double MinimumSize = 0.0;
  double MaximumSize = 0.0;
  double Gradient = 0.3;
  double ConeAngle = 15.0;
};

#endif
