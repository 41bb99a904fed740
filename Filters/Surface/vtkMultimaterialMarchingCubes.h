// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMultimaterialMarchingCubes
 * @brief   the interface surface of an image of materials, shared by the materials it parts
 *
 * Input, port 0: a 3-D vtkImageData with MaterialIds on its points (or one array of whole numbers from 0 to
 * 65,535). Origin, spacing and direction are honoured; what lies outside the image is background (0). Port 1,
 * optional: a vtkImageData of the same size, the region of interest (not 0 inside), which OpenAtMaskBorder
 * refers to. Port 2, optional: a vtkImageData of the same size with grey values of any number type in one
 * array (or in Intensity), NaN where nothing is known. With it the surface cuts between two voxels where the
 * grey values, linear between them, pass from one material to the other (the value that parts most of their
 * faces) instead of midway, and materials have their partial volumes.
 *
 * Output: vtkPolyData of triangles with BoundaryLabels (int x2: the normal points from component 0 to
 * component 1, background is component 1, else ascending) and PatchIds (int, 0 a wall, else an opening; names
 * in the field data PatchNames) on the triangles, JunctionOrder and JunctionKind (unsigned char) on the
 * points. MissingVolume (double x2) on the triangles, where labels were repaired: the volume that the first
 * and the second material have in the image and lack there, in cubes of the square root of the triangle's
 * area; vtkVolumeConservingSmoothing gives it back. ImageVolumes in the field data: material ids and the
 * volumes of their voxels (partial volumes with grey values). Points are doubles in world coordinates, in the
 * image's unit of length.
 *
 * Marching cubes for any number of materials in the manner of S. Wu and J. M. Sullivan, Multiple material
 * marching cubes algorithm, Int. J. Numer. Meth. Eng. 58 (2003) 189-207, doi:10.1002/nme.775: points are
 * shared along junction curves.
 *
 * The boundary of each material is closed and 2-manifold, and oriented by BoundaryLabels. Voxels that no
 * manifold surface could part are given to a neighbour first; the report in the field data tells how many and
 * where.
 *
 * @warning A material that no voxel has cannot be opened: naming it in OpenMaterials is an error once a
 * border is open.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkMultimaterialSegmentation vtkVolumeConservingSmoothing
 */
#ifndef vtkMultimaterialMarchingCubes_h
#define vtkMultimaterialMarchingCubes_h

#include "LaminaSurfaceModule.h" // For the export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // For the list of materials

class LAMINASURFACE_EXPORT vtkMultimaterialMarchingCubes : public vtkPolyDataAlgorithm
{
public:
  static vtkMultimaterialMarchingCubes* New();
  vtkTypeMacro(vtkMultimaterialMarchingCubes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Materials that stay open where a border is open. Default: 2, blood.
   */
  void AddOpenMaterial(int material);
  void ClearOpenMaterials();
  int GetNumberOfOpenMaterials() { return static_cast<int>(this->OpenMaterials.size()); }
  int GetOpenMaterial(int index);
  ///@}

  ///@{
  /**
   * Whether open materials end in a plane opening, a patch of its own, where they reach the image's border.
   * Default: off.
   */
  vtkSetMacro(OpenAtImageBorder, bool);
  vtkGetMacro(OpenAtImageBorder, bool);
  vtkBooleanMacro(OpenAtImageBorder, bool);
  ///@}

  ///@{
  /**
   * The same where they reach the border of the region of interest of port 1. Default: off.
   */
  vtkSetMacro(OpenAtMaskBorder, bool);
  vtkGetMacro(OpenAtMaskBorder, bool);
  vtkBooleanMacro(OpenAtMaskBorder, bool);
  ///@}

  ///@{
  /**
   * Whether points closer together than 0.8 voxels are merged, for fewer and better triangles; topology,
   * junction curves and planes stay, and what changes in volume is noted as MissingVolume. Voxel faces have
   * no such points, the cuts of grey values have. Default: on.
   */
  vtkSetMacro(ClusterPoints, bool);
  vtkGetMacro(ClusterPoints, bool);
  vtkBooleanMacro(ClusterPoints, bool);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkMultimaterialMarchingCubes();
  ~vtkMultimaterialMarchingCubes() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMultimaterialMarchingCubes(const vtkMultimaterialMarchingCubes&) = delete;
  void operator=(const vtkMultimaterialMarchingCubes&) = delete;

  std::vector<int> OpenMaterials{ 2 };
  bool OpenAtImageBorder = false;
  bool OpenAtMaskBorder = false;
  bool ClusterPoints = true;
};

#endif
