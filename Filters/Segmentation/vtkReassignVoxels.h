// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkReassignVoxels
 * @brief   materials given to voxels by hand: boxes, spheres, lists of voxels, selections
 *
 * Input, port 0: a 3-D vtkImageData with MaterialIds on its points (or a single array of material ids). Port
 * 1, optional: a vtkSelection of the image's points or cells; a cell stands for the eight voxels at its
 * corners.
 *
 * Output, port 0: the image with new MaterialIds (int, active), the input's other arrays, and Disputed, if
 * the input has it, cleared where an edit decided and set where the repair had to change an edit's voxel.
 * Port 1: a vtkTable with columns Step, Shape, Material, Covered, Decided, Changed: a row an edit in their
 * order, then the repair. Neither input is changed.
 *
 * An edit gives the voxels of a shape (those whose centres lie in it, in world coordinates) a material,
 * perhaps only those of some materials. Edits are applied one after the other, then the current edit, which
 * Shape chooses. An edit is one object of JSON, for instance
 *
 *     {"shape": "box", "bounds": [x0, x1, y0, y1, z0, z1], "to": 2}
 *     {"shape": "sphere", "center": [x, y, z], "radius": r, "from": [0, 1], "to": 2}
 *     {"shape": "voxels", "dimensions": [nx, ny, nz], "ids": [17, [20, 31]], "to": 0}
 *
 * so that the list is a property like any other: state files, scripts and undo hold it.
 *
 * Afterwards the topology is repaired (Latecki's well-composed images, and materials that may not meet):
 * first without touching voxels that were decided by an edit; only for faults that then remain these too,
 * with a warning.
 *
 * The same for any number of threads.
 *
 * @warning Without an edit the image passes through as it is, unrepaired.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkMultimaterialSegmentation vtkMultimaterialMarchingCubes
 */
#ifndef vtkReassignVoxels_h
#define vtkReassignVoxels_h

#include "LaminaSegmentationModule.h" // For the export macro
#include "vtkImageAlgorithm.h"
#include "vtkNew.h" // For the list that is handed out

#include <array>  // For pairs of materials
#include <string> // For the edits
#include <vector> // For lists

class vtkIdTypeArray;
class vtkSelection;
class vtkStringArray;

class LAMINASEGMENTATION_EXPORT vtkReassignVoxels : public vtkImageAlgorithm
{
public:
  static vtkReassignVoxels* New();
  vtkTypeMacro(vtkReassignVoxels, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The edits, one object of JSON each, in the order in which they are applied. Text that is none is an error
   * of the next update. Default: none.
   */
  void AddEdit(const char* json);
  void ClearEdits();
  void RemoveLastEdit();
  int GetNumberOfEdits() { return static_cast<int>(this->Edits.size()); }
  const char* GetEdit(int index);
  vtkStringArray* GetEdits();
  ///@}

  ///@{
  /**
   * Add an edit. Bounds, center and radius are in world coordinates; `from` restricts it to voxels of one
   * material, -1: of any. AddVoxels and AddSelection note the size of the input image, which has to be
   * connected; AddSelection works the selection out at once. They return whether an edit was added.
   */
  bool AddBox(const double bounds[6], int to, int from = -1);
  bool AddSphere(const double center[3], double radius, int to, int from = -1);
  bool AddVoxels(vtkIdTypeArray* ids, int to, int from = -1);
  bool AddSelection(vtkSelection* selection, int to, int from = -1);
  ///@}

  /// What the current edit covers.
  enum Shapes
  {
    None = 0,
    Selection = 1, ///< the selection on port 1, if there is one
    Box = 2,
    Sphere = 3
  };

  ///@{
  /**
   * The current edit, applied after all others: its shape (default: Selection), the box as xmin, xmax, ...
   * (default 0, 1 along each axis), the sphere's center (default 0, 0, 0) and radius (default 1), the
   * material to give (0 to 65,535, default 0) and, if any, the materials it is restricted to (default: none,
   * voxels of any).
   */
  vtkSetMacro(Shape, int);
  vtkGetMacro(Shape, int);
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  vtkSetMacro(ToMaterial, int);
  vtkGetMacro(ToMaterial, int);
  void AddFromMaterial(int material);
  void ClearFromMaterials();
  int GetNumberOfFromMaterials() { return static_cast<int>(this->FromMaterials.size()); }
  int GetFromMaterial(int index);
  ///@}

  /**
   * Make the current edit the last of the edits and set Shape to None. A selection becomes a list of voxels,
   * which no longer depends on what is selected. Returns whether an edit was added.
   */
  bool KeepEdit();

  ///@{
  /**
   * Write all edits to the file FileName, and replace the edits by those of the file. On failure an error
   * says what is wrong, with line and column where it is not JSON, and file and edits stay as they were.
   * Return success.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  bool SaveEdits();
  bool LoadEdits();
  ///@}

  ///@{
  /**
   * Whether the topology is repaired after the edits. Default: on.
   */
  vtkSetMacro(RepairTopology, bool);
  vtkGetMacro(RepairTopology, bool);
  vtkBooleanMacro(RepairTopology, bool);
  ///@}

  ///@{
  /**
   * Two materials that the repair keeps from meeting over a face, an edge or a corner, for instance
   * background and blood (0, 2). Default: no pair, as the labels may mean anything.
   */
  void AddForbiddenContact(int first, int second);
  void ClearForbiddenContacts();
  int GetNumberOfForbiddenContacts() { return static_cast<int>(this->ForbiddenContacts.size()); }
  void GetForbiddenContact(int index, int pair[2]);
  ///@}

  ///@{
  /**
   * Whether forbidden pairs may meet at the image's border, outside of which is background. Default: off.
   */
  vtkSetMacro(OpenAtImageBorder, bool);
  vtkGetMacro(OpenAtImageBorder, bool);
  vtkBooleanMacro(OpenAtImageBorder, bool);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkReassignVoxels();
  ~vtkReassignVoxels() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkReassignVoxels(const vtkReassignVoxels&) = delete;
  void operator=(const vtkReassignVoxels&) = delete;

  std::vector<std::string> Edits;
  vtkNew<vtkStringArray> EditArray;
  int Shape = Selection;
  double Bounds[6] = { 0, 1, 0, 1, 0, 1 };
  double Center[3] = { 0, 0, 0 };
  double Radius = 1;
  int ToMaterial = 0;
  std::vector<int> FromMaterials;
  char* FileName = nullptr;
  bool RepairTopology = true;
  std::vector<std::array<int, 2>> ForbiddenContacts;
  bool OpenAtImageBorder = false;
};

#endif
