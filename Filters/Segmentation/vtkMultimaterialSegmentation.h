// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMultimaterialSegmentation
 * @brief   from grey values to materials, with walls around blood and without islands
 *
 * Input, port 0: a 3-D vtkImageData with one component of any number type (the active scalars, or the only
 * array); NaN is background. Port 1, optional: a vtkImageData of the same size, the region of interest: where
 * it is not 1, the material is 0.
 *
 * Output, port 0: the image with MaterialIds (int, active: 0 background, 1 tissue, 2 blood) and Disputed
 * (unsigned char, 1 where the material was a guess) beside the input's arrays. Port 1: a vtkTable with what
 * each rule did, columns Rule, Material, Components, Voxels, in the order of work, then the totals of each
 * material.
 *
 * Thresholds, the resolution of disputed voxels and the walls follow J. P. Carson, A. P. Kuprat, X. Jiao, F.
 * del Pin and D. R. Einstein, An anisotropic fluid-solid model of the mouse heart, Computers in Cardiology 36
 * (2009): groups of disputed voxels enclosed by one material take it, those mostly among tissue are thin
 * vessels; the rest go to the likelier of tissue and blood by grey value and neighbours and are flagged.
 * Background that touches blood becomes tissue, components below a size go to their neighbours, until nothing
 * changes.
 *
 * Blood has a wall of at least one tissue voxel against background (over faces, edges and corners), openings
 * apart; outside the region of interest nothing but background is left. The same for any number of threads.
 *
 * @warning Three thresholds make a disputed class, two none; with any other number the classes are numbered
 * in order and have no walls.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkHeartPhantomSource vtkMultimaterialMarchingCubes
 */
#ifndef vtkMultimaterialSegmentation_h
#define vtkMultimaterialSegmentation_h

#include "LaminaSegmentationModule.h" // For the export macro
#include "vtkImageAlgorithm.h"

#include <vector> // For the thresholds

class LAMINASEGMENTATION_EXPORT vtkMultimaterialSegmentation : public vtkImageAlgorithm
{
public:
  static vtkMultimaterialSegmentation* New();
  vtkTypeMacro(vtkMultimaterialSegmentation, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Grey values between the classes, ascending, inside the image's range. Default: 50, 110, 150.
   */
  void AddThreshold(double threshold);
  void ClearThresholds();
  int GetNumberOfThresholds() { return static_cast<int>(this->Thresholds.size()); }
  double GetThreshold(int index);
  ///@}

  ///@{
  /**
   * Whether the largest component of each material is kept alone. Default: off.
   */
  vtkSetMacro(LargestOnly, bool);
  vtkGetMacro(LargestOnly, bool);
  vtkBooleanMacro(LargestOnly, bool);
  ///@}

  ///@{
  /**
   * Components smaller than this share of their material go to a neighbour, 0 to 1. Default: 0.001.
   */
  vtkSetMacro(MinimumShare, double);
  vtkGetMacro(MinimumShare, double);
  ///@}

  ///@{
  /**
   * Components of fewer voxels than this go to a neighbour, at least 0. Default: 50.
   */
  vtkSetMacro(MinimumVoxels, vtkIdType);
  vtkGetMacro(MinimumVoxels, vtkIdType);
  ///@}

  ///@{
  /**
   * Whether blood may reach the image's border without tissue made over it. Default: off.
   */
  vtkSetMacro(OpenAtImageBorder, bool);
  vtkGetMacro(OpenAtImageBorder, bool);
  vtkBooleanMacro(OpenAtImageBorder, bool);
  ///@}

  ///@{
  /**
   * Whether blood may reach the edge of the region of interest without tissue made over it. Default: off.
   */
  vtkSetMacro(OpenAtMaskBorder, bool);
  vtkGetMacro(OpenAtMaskBorder, bool);
  vtkBooleanMacro(OpenAtMaskBorder, bool);
  ///@}

  ///@{
  /**
   * A disputed voxel with at least this many tissue voxels among its 26 neighbours becomes blood, 1 to 27,
   * where 27 switches the rule off. Default: 14.
   */
  vtkSetMacro(CoronaryMajority, int);
  vtkGetMacro(CoronaryMajority, int);
  ///@}

protected:
  vtkMultimaterialSegmentation();
  ~vtkMultimaterialSegmentation() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMultimaterialSegmentation(const vtkMultimaterialSegmentation&) = delete;
  void operator=(const vtkMultimaterialSegmentation&) = delete;

  std::vector<double> Thresholds{ 50, 110, 150 };
  bool LargestOnly = false;
  double MinimumShare = 0.001;
  vtkIdType MinimumVoxels = 50;
  bool OpenAtImageBorder = false;
  bool OpenAtMaskBorder = false;
  int CoronaryMajority = 14;
};

#endif
