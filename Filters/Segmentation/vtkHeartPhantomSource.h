// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeartPhantomSource
 * @brief   a made-up image of a heart, with the truth beside it
 *
 * No input.
 *
 * Output, port 0: vtkImageData with Intensity (unsigned char) on its points, the active scalars: blood about
 * 190, tissue about 85, anything else about 20, with partial volume at borders, blur, a bias field and noise.
 * Port 1: vtkImageData of the same grid with MaterialIds (int): 0 background, 1 tissue, 2 blood, the truth,
 * and Parts (unsigned char): 0 outside, 1 wall, 2 leaflet, 3 strand (papillary muscle, chorda, tendon), 4
 * chamber or great vessel, 5 coronary. Its field data has MaterialComponents (vtkIdType x1): the number of
 * components of each material, counted over voxel faces, by id. Origin 0, equal spacings, in units of Length.
 *
 * The heart is made of signed distances: two ventricles, two atria, a thin septum, two valves with leaflets,
 * papillary muscles and chordae, a tendon across each ventricle, coronary arteries that branch and taper, and
 * stumps of the great vessels. The finest of it are two to three voxels thick at any resolution; what an
 * image of fewer voxels could not show is left out (below 64: valves, strands and coronaries, below 36 atria
 * and vessels, below 26 the right ventricle).
 *
 * Blood never touches background, no material meets itself in an edge or a corner only, and the number of
 * components is the designed one: blood has four (left heart, right heart, two coronary trees). The same
 * properties give the same image for any number of threads.
 *
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkMultimaterialSegmentation
 */
#ifndef vtkHeartPhantomSource_h
#define vtkHeartPhantomSource_h

#include "LaminaSegmentationModule.h" // For the export macro
#include "vtkImageAlgorithm.h"

class LAMINASEGMENTATION_EXPORT vtkHeartPhantomSource : public vtkImageAlgorithm
{
public:
  static vtkHeartPhantomSource* New();
  vtkTypeMacro(vtkHeartPhantomSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Voxels along the longest axis, 16 to 512. Default: 120.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Length of the image's longest axis in the world. Default: 120.
   */
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /**
   * Standard deviation of the noise in grey levels, 0 to 255. Default: 12.
   */
  vtkSetMacro(Noise, double);
  vtkGetMacro(Noise, double);
  ///@}

  ///@{
  /**
   * Full width at half maximum of the blur in voxels, 0 to 8. Default: 1.
   */
  vtkSetMacro(Blur, double);
  vtkGetMacro(Blur, double);
  ///@}

  ///@{
  /**
   * Greatest relative change of brightness over the image, 0 to 1. Default: 0.05.
   */
  vtkSetMacro(Bias, double);
  vtkGetMacro(Bias, double);
  ///@}

  ///@{
  /**
   * Seed of the noise. Default: 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Whether the great vessels leave through the image's upper border instead of ending inside. Default: off.
   */
  vtkSetMacro(OpenVessels, bool);
  vtkGetMacro(OpenVessels, bool);
  vtkBooleanMacro(OpenVessels, bool);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkHeartPhantomSource();
  ~vtkHeartPhantomSource() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeartPhantomSource(const vtkHeartPhantomSource&) = delete;
  void operator=(const vtkHeartPhantomSource&) = delete;

  int Resolution = 120;
  double Length = 120;
  double Noise = 12;
  double Blur = 1;
  double Bias = 0.05;
  int Seed = 1;
  bool OpenVessels = false;
};

#endif
