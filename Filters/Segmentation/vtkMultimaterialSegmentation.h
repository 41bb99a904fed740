// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMultimaterialSegmentation
 * @brief   from grey values to materials, with walls around blood, without islands, well-composed
 *
 * Input, port 0: a 3-D vtkImageData with one component of any number type (the active scalars, or the only
 * array), read where it lies; NaN is background. Port 1, optional: a vtkImageData of the same grid, the
 * region of interest: where it is not 1, the material is 0.
 *
 * Output, port 0: the image with MaterialIds (int, active: 0 background, 1 tissue, 2 blood) and Disputed
 * (unsigned char, bits: 1 the material was a guess, 2 stands in a topological fault that was left, 4 changed
 * by the repair) beside the input's arrays, and the report as JSON in its field data. Port 1: a vtkTable,
 * columns Rule, Material, Components, Voxels, Tunnels, Cavities: the Betti numbers of each material after the
 * thresholds, what each rule did in the order of work, the faults found and left, the Betti numbers in the
 * end.
 *
 * The image is smoothed without crossing edges (C. Tomasi, R. Manduchi, Bilateral filtering for gray and
 * color images, ICCV 1998), as far as its noise goes. Thresholds, the resolution of disputed voxels and the
 * walls follow J. P. Carson, A. P. Kuprat, X. Jiao, F. del Pin and D. R. Einstein, An anisotropic fluid-solid
 * model of the mouse heart, Computers in Cardiology 36 (2009): groups of disputed voxels enclosed by one
 * material take it, those mostly among tissue are thin vessels. The rest are flagged and go to the likelier
 * of tissue and blood by a random walk (L. Grady, Multilabel random walker image segmentation using prior
 * models, CVPR 2005) or, left to a person, to the nearer mean. Shells that partial volume draws between two
 * materials are given to these. Then, until nothing changes: background that touches blood becomes tissue,
 * components below a size go to their neighbours, the topology is repaired.
 *
 * Afterwards no forbidden pair of materials touches over faces, edges or corners and no material, or its
 * complement, meets itself in an edge or a corner only, openings and what the mask holds fast apart; outside
 * the region of interest nothing but background is left. The same for any number of threads. Memory: at most
 * 16 bytes a voxel above the input. A material that vanishes brings a warning that names the rule.
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

#include <array>  // For pairs of materials
#include <vector> // For the thresholds

class LAMINASEGMENTATION_EXPORT vtkMultimaterialSegmentation : public vtkImageAlgorithm
{
public:
  static vtkMultimaterialSegmentation* New();
  vtkTypeMacro(vtkMultimaterialSegmentation, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Grey values between the classes, ascending, inside the image's range. Default: none,
   * which takes them from the grey values that fill places of the whole image: three where there are three or
   * more such values, one where there are two. The report tells those that served.
   */
  void AddThreshold(double threshold);
  void ClearThresholds();
  int GetNumberOfThresholds() { return static_cast<int>(this->Thresholds.size()); }
  double GetThreshold(int index);
  ///@}

  enum DisputedChoice
  {
    LIKELIER_MATERIAL = 0,
    LEFT_TO_A_PERSON = 1
  };
  enum ComponentChoice
  {
    ALL_COMPONENTS = 0,
    LARGEST_COMPONENT = 1,
    LARGEST_COMPONENTS = 2
  };
  enum RepairChoice
  {
    REPAIR = 0,
    FLAG_ONLY = 1,
    OFF = 2
  };

  ///@{
  /**
   * Sweeps of edge-preserving smoothing before the thresholds, 0 (off) to 20. How alike two voxels must be to
   * be mixed follows from the image's noise; an image without noise stays as it is. Default: 2.
   */
  vtkSetMacro(SmoothingSweeps, int);
  vtkGetMacro(SmoothingSweeps, int);
  ///@}

  ///@{
  /**
   * What becomes of disputed voxels that the rules for groups and thin vessels leave; they are flagged either
   * way: LIKELIER_MATERIAL by grey value and neighbours, or LEFT_TO_A_PERSON, the nearer mean until then.
   * Default: LIKELIER_MATERIAL.
   */
  vtkSetMacro(DisputedVoxels, int);
  vtkGetMacro(DisputedVoxels, int);
  ///@}

  ///@{
  /**
   * Whether shells of one or two voxels that partial volume draws between two materials are dissolved. A
   * voxel is one of them if a lower and a higher class stand at most three steps apart on opposite sides of
   * it, the grey values climb all the way between, and no place three voxels thick of its own class is next
   * to it. Materials whose contact is forbidden have none: with the default ones nothing happens for two and
   * three thresholds. Default: on.
   */
  vtkSetMacro(DissolveSkins, bool);
  vtkGetMacro(DissolveSkins, bool);
  vtkBooleanMacro(DissolveSkins, bool);
  ///@}

  ///@{
  /**
   * Which components of each material stay, of those above the sizes below: ALL_COMPONENTS,
   * LARGEST_COMPONENT alone, or the ComponentCount LARGEST_COMPONENTS. Default: ALL_COMPONENTS.
   */
  vtkSetMacro(KeptComponents, int);
  vtkGetMacro(KeptComponents, int);
  ///@}

  ///@{
  /**
   * How many components of each material stay with LARGEST_COMPONENTS, at least 1. Default: 1.
   */
  vtkSetMacro(ComponentCount, vtkIdType);
  vtkGetMacro(ComponentCount, vtkIdType);
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

  ///@{
  /**
   * Pairs of materials that may not touch over faces, edges or corners, openings apart. Background and blood
   * are kept apart by tissue, others by the repair of the topology. Default: background and blood (0, 2),
   * which in this form counts for two and three thresholds only; (2, 0) counts for any number.
   */
  void AddForbiddenContact(int first, int second);
  void ClearForbiddenContacts();
  int GetNumberOfForbiddenContacts() { return static_cast<int>(this->ForbiddenContacts.size()); }
  const int* GetForbiddenContact(int index) VTK_SIZEHINT(2);
  ///@}

  ///@{
  /**
   * What is done where a material meets itself in an edge or a corner only, or a forbidden one: REPAIR,
   * FLAG_ONLY (bit value 2 of Disputed), or OFF. Default: REPAIR.
   */
  vtkSetMacro(RepairTopology, int);
  vtkGetMacro(RepairTopology, int);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

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

  std::vector<double> Thresholds;
  int SmoothingSweeps = 2;
  int DisputedVoxels = LIKELIER_MATERIAL;
  bool DissolveSkins = true;
  int KeptComponents = ALL_COMPONENTS;
  vtkIdType ComponentCount = 1;
  double MinimumShare = 0.001;
  vtkIdType MinimumVoxels = 50;
  bool OpenAtImageBorder = false;
  bool OpenAtMaskBorder = false;
  int CoronaryMajority = 14;
  std::vector<std::array<int, 2>> ForbiddenContacts{ { { 0, 2 } } };
  int RepairTopology = REPAIR;
};

#endif
