// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFeatureSize
 * @brief   measures how thick each material is under a surface, and derives the edge lengths to mesh it with
 *
 * Input: vtkPolyData of triangles with BoundaryLabels, or any closed surface of one orientation (material 1
 * in background).
 *
 * Output: the same surface with, on its points, MaterialFeatureSize (double, a component a material, named by
 * its id; NaN where the point does not touch it), FeatureSize (double, the governing one), TargetEdgeLength
 * (double), all lengths in the unit of the input, MaximumCurvature and MinimumCurvature (double, the
 * principal curvatures in 1/length, positive where the surface bends away from its normal) and
 * MaximumCurvatureDirection (double x3, unit). Other arrays pass through.
 *
 * Rays in a narrow cone around the normal, into the materials on both sides, measure the distance to the
 * opposite wall; sizes are limited in slope. After A. P. Kuprat and D. R. Einstein, An anisotropic
 * scale-invariant unstructured mesh generator suitable for volumetric imaging data, J. Comput. Phys. 228
 * (2009) 619-640, doi:10.1016/j.jcp.2008.09.030. Curvatures are those of quadrics fitted to each sheet, after
 * X. Jiao and H. Zha, Consistent computation of first- and second-order differential quantities for surface
 * meshes, Proc. ACM Symposium on Solid and Physical Modeling (2008) 159-170, doi:10.1145/1364901.1364924.
 *
 * MaterialFeatureSize is the measured thickness, at most the maximum, for the layers. FeatureSize is clipped
 * to the limits and shortened where a circle of the surface's curvature would get fewer edges than
 * NodesPerCircumference. TargetEdgeLength is that size of each material times its Anisotropy over its Layers,
 * at most EdgePerLayer thicknesses of a layer, and the least of the materials that meet.
 *
 * Between any two points, sizes differ by at most Gradient times their distance, edge lengths by Anisotropy
 * over Layers times that. The result does not depend on the number of threads.
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

#include <vector> // For the sizings of materials

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
   * The largest slope of the sizes, along the surface and across space, above 0. Default: 0.3.
   */
  vtkSetMacro(Gradient, double);
  vtkGetMacro(Gradient, double);
  ///@}

  ///@{
  /**
   * Half the opening angle of the cone of rays, in degrees, 0 to 60. Default: 15.
   */
  vtkSetMacro(ConeAngle, double);
  vtkGetMacro(ConeAngle, double);
  ///@}

  ///@{
  /**
   * The least number of edges around a circle of the surface's curvature, 3 or more; 0 leaves curvature out.
   * Sizes do not fall below their minimum for it. Default: 12.
   */
  vtkSetMacro(NodesPerCircumference, int);
  vtkGetMacro(NodesPerCircumference, int);
  ///@}

  ///@{
  /**
   * The longest edge over the thickness of a layer in the wall as it is, above 0: longer edges leave no room
   * for good tetrahedra in walls thinner than the least feature size. Default: 8.
   */
  vtkSetMacro(EdgePerLayer, double);
  vtkGetMacro(EdgePerLayer, double);
  ///@}

  ///@{
  /**
   * What single materials ask for: material id, Layers, Anisotropy, MinimumSize, MaximumSize, where 0 takes
   * what holds for all. Default: none.
   */
  void AddMaterialSizing(double material, double layers, double anisotropy, double minimum, double maximum);
  void ClearMaterialSizings();
  int GetNumberOfMaterialSizings() { return static_cast<int>(this->MaterialSizings.size() / 5); }
  /// The five numbers of an entry; zeros if there is no such entry.
  void GetMaterialSizing(int index, double sizing[5]);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

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
  int NodesPerCircumference = 12;
  double EdgePerLayer = 8.0;
  std::vector<double> MaterialSizings; // five numbers an entry
};

#endif
