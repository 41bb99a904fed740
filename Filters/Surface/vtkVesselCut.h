// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVesselCut
 * @brief   cuts a vessel off by a plane and closes it with plane ends
 *
 * Input: vtkPolyData of triangles with BoundaryLabels, at best from vtkVolumeConservingSmoothing, or any
 * closed surface of one orientation, which is taken as material 1 in background.
 *
 * Output: the surface without what lies beyond the plane, with BoundaryLabels and PatchIds on the triangles,
 * JunctionOrder and JunctionKind on the points, PatchNames in the field data. Sizes and other arrays do not
 * come along. Lengths are in the unit of the input.
 *
 * The plane cuts materials that hang together: the piece in which Origin lies is meant, or the nearest one,
 * if it is nearer than half the root of its area. What is beyond it and linked to it goes; what else the
 * plane meets stays. Each connected end of an open material becomes an opening, the ends of all other
 * materials become one border. The triangles at the plane are cut, ears and Delaunay flips fill the ends.
 *
 * The surface stays closed, and no two triangles intersect, tested exactly. Points of the ends lie in the
 * plane to rounding; the plane gives way by up to 1e-7 mean edge lengths where a point lies in it.
 *
 * @warning Points within a quarter of an edge of the plane are moved into it. A body in a cavity of
 * background is not linked to what is around it.
 *
 * @sa vtkVolumeConservingSmoothing vtkMultimaterialMarchingCubes vtkFluidSolidMesh
 */
#ifndef vtkVesselCut_h
#define vtkVesselCut_h

#include "LaminaSurfaceModule.h" // For the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For the name
#include <vector> // For the list of materials

class LAMINASURFACE_EXPORT vtkVesselCut : public vtkPolyDataAlgorithm
{
public:
  static vtkVesselCut* New();
  vtkTypeMacro(vtkVesselCut, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A place in the plane, inside the vessel or beside it. Default: 0, 0, 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Towards what is cut off; of any length but 0. Default: 0, 0, 1.
   */
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * What the ends are called: opening_<Name> and border_<Name>. Letters, digits, _ and -. Default: "", which
   * numbers them.
   */
  vtkSetStdStringFromCharMacro(Name);
  vtkGetCharFromStdStringMacro(Name);
  ///@}

  ///@{
  /**
   * Materials whose ends are openings. Default: 2, blood.
   */
  void AddOpenMaterial(int material);
  void ClearOpenMaterials();
  int GetNumberOfOpenMaterials() const { return static_cast<int>(this->OpenMaterials.size()); }
  int GetOpenMaterial(int index) const;
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkVesselCut() = default;
  ~vtkVesselCut() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkVesselCut(const vtkVesselCut&) = delete;
  void operator=(const vtkVesselCut&) = delete;

  double Origin[3] = { 0, 0, 0 };
  double Normal[3] = { 0, 0, 1 };
  std::string Name;
  std::vector<int> OpenMaterials{ 2 };
};

#endif
