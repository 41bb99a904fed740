// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMaskPropagation
 * @brief   a region of interest drawn on a few slices, carried to all
 *
 * Input, port 0: a 3-D vtkImageData with one component of any number type (the active scalars, or the only
 * array); NaN counts as the least grey value. Port 1: a vtkImageData of the same size and place, the mask:
 * any number type, 0 outside, a whole number up to 65,535 inside, on a few slices. Each value is a region of
 * its own.
 *
 * Output, port 0: the image with Mask (unsigned short, active) beside the input's arrays: the regions on all
 * slices. It serves as the mask of vtkMultimaterialSegmentation. Port 1: a vtkTable, a row for each slice
 * that was not drawn, columns Slice, From, To (the drawn slices it comes from), Voxels, Residual (mean
 * absolute grey difference around the mask from what was carried there). Slices are numbered as in the
 * image's extent.
 *
 * Adjacent slices are registered elastically from coarse to fine, after P. J. Kostelec, J. B. Weaver and D.
 * M. Healy, Multiresolution elastic image registration, Medical Physics 25 (1998); the displacements are
 * chained up to the drawn slices on both sides, and the signed distances of the drawn regions carried along
 * and blended by nearness. Then patches of like grey values correct the border, after P. Coupe et al.,
 * Patch-based segmentation using expert priors, NeuroImage 54 (2011). Drawn slices are foretold from their
 * neighbours by this, by registration alone, and by shape interpolation alone; what foretells best is used.
 *
 * Drawn slices are kept exactly. The same for any number of threads.
 *
 * @warning Where the image is constant around the mask the shape alone is interpolated, with a warning.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkMultimaterialSegmentation
 */
#ifndef vtkMaskPropagation_h
#define vtkMaskPropagation_h

#include "LaminaSegmentationModule.h" // For the export macro
#include "vtkImageAlgorithm.h"

#include <vector> // For the drawn slices

class LAMINASEGMENTATION_EXPORT vtkMaskPropagation : public vtkImageAlgorithm
{
public:
  static vtkMaskPropagation* New();
  vtkTypeMacro(vtkMaskPropagation, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SliceAxes
  {
    AXIS_I = 0,
    AXIS_J = 1,
    AXIS_K = 2,
    AXIS_AUTOMATIC = 3
  };

  enum Methods
  {
    METHOD_AUTOMATIC = 0,
    METHOD_SHAPE = 1,
    METHOD_REGISTRATION = 2,
    METHOD_GREY_VALUES = 3
  };

  ///@{
  /**
   * Across which axis the mask was drawn: 0 i, 1 j, 2 k, 3 the one along which drawn slices are sparse.
   * Default: 3.
   */
  vtkSetMacro(SliceAxis, int);
  vtkGetMacro(SliceAxis, int);
  ///@}

  ///@{
  /**
   * The slices that were drawn, numbered as in the image's extent; also empty ones, where the mask ends.
   * Other slices of the mask are not looked at. Default: none, which stands for all slices with a voxel of
   * the mask.
   */
  void AddDrawnSlice(int slice);
  void ClearDrawnSlices();
  int GetNumberOfDrawnSlices() { return static_cast<int>(this->DrawnSlices.size()); }
  int GetDrawnSlice(int index);
  ///@}

  ///@{
  /**
   * The value of the mask that is carried, 0 to 65,535; 0 stands for each value as a region of its own.
   * Default: 0.
   */
  vtkSetMacro(MaskValue, int);
  vtkGetMacro(MaskValue, int);
  ///@}

  ///@{
  /**
   * How many slices beyond the first and the last drawn one the mask is carried, -1 or more. -1: the mask
   * ends before the slice that would have been drawn next, at the distance of the last two; from a single
   * drawn slice it is carried to all. Default: -1.
   */
  vtkSetMacro(MaximumSlices, int);
  vtkGetMacro(MaximumSlices, int);
  ///@}

  ///@{
  /**
   * 0 what foretells drawn slices best from their neighbours, of: 1 shape interpolation, 2 registration, 3
   * registration corrected by grey values. Default: 0.
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Levels of the registration, each half as fine as the one before, 1 to 8. Default: 4.
   */
  vtkSetMacro(Levels, int);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * Reach over which displacements are evened out, in pixels of each level, 0.5 to 20. Default: 1.5.
   */
  vtkSetMacro(Smoothness, double);
  vtkGetMacro(Smoothness, double);
  ///@}

  ///@{
  /**
   * Greatest displacement from one slice to the next, in pixels (of the shorter edge), above 0. Default: 16.
   */
  vtkSetMacro(SearchRange, double);
  vtkGetMacro(SearchRange, double);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkMaskPropagation();
  ~vtkMaskPropagation() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMaskPropagation(const vtkMaskPropagation&) = delete;
  void operator=(const vtkMaskPropagation&) = delete;

  int SliceAxis = AXIS_AUTOMATIC;
  std::vector<int> DrawnSlices;
  int MaskValue = 0;
  int MaximumSlices = -1;
  int Method = METHOD_AUTOMATIC;
  int Levels = 4;
  double Smoothness = 1.5;
  double SearchRange = 16;
};

#endif
