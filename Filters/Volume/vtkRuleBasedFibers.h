// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRuleBasedFibers
 * @brief   gives the cells of a muscle the directions of its fibres by rule
 *
 * Input: vtkUnstructuredGrid of tetrahedra, wedges and pyramids with MaterialIds on the cells and, in the
 * field data, the patches of vtkFluidSolidMesh.
 *
 * Output: the input with, on the cells, Fibers and Sheets (double x3, of length 1; zero outside the muscle)
 * and WallDepth (double: 0 endocardium, 1 epicardium, -1 outside the muscle).
 *
 * The depth of a cell's middle is its distance from the endocardium over the sum of the distances from endo-
 * and epicardium (Potse, Dube, Richer, Vinet, Gulrajani: A comparison of monodomain and bidomain
 * reaction-diffusion models, IEEE Transactions on Biomedical Engineering 53, 2006). The fibre lies in the
 * wall, and is turned from the circumference about the axis towards the axis by an angle that is linear in
 * the depth (Streeter, Spotnitz, Patel, Ross, Sonnenblick: Fiber orientation in the canine left ventricle
 * during diastole and systole, Circulation Research 24, 1969). Sheets are orthogonal to Fibers, across the
 * wall.
 *
 * The result does not depend on the number of threads.
 *
 * @warning The rule knows no valves and no atria. Of two ventricles, the right one's endocardium is better
 * counted as epicardium, so that fibres run through the septum.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkFluidSolidMesh
 */
#ifndef vtkRuleBasedFibers_h
#define vtkRuleBasedFibers_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // For names of patches
#include <vector> // For the materials

class LAMINAVOLUME_EXPORT vtkRuleBasedFibers : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkRuleBasedFibers* New();
  vtkTypeMacro(vtkRuleBasedFibers, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The materials that have fibres. Default: 1.
   */
  void AddMuscleMaterial(int material);
  void ClearMuscleMaterials();
  int GetNumberOfMuscleMaterials() const { return static_cast<int>(this->MuscleMaterials.size()); }
  int GetMuscleMaterial(int index) const { return this->MuscleMaterials[static_cast<std::size_t>(index)]; }
  ///@}

  ///@{
  /**
   * The patches that are the endocardium, parted by semicolons. Default: "", all interfaces of the muscle.
   */
  vtkSetStdStringFromCharMacro(Endocardium);
  vtkGetCharFromStdStringMacro(Endocardium);
  ///@}

  ///@{
  /**
   * The patches that are the epicardium, parted by semicolons. Default: "", all walls of the muscle.
   */
  vtkSetStdStringFromCharMacro(Epicardium);
  vtkGetCharFromStdStringMacro(Epicardium);
  ///@}

  ///@{
  /**
   * The fibre's angle from the circumference at the endocardium, in degrees from -90 to 90. Default: 60.
   */
  vtkSetMacro(EndocardialHelixAngle, double);
  vtkGetMacro(EndocardialHelixAngle, double);
  ///@}

  ///@{
  /**
   * The fibre's angle from the circumference at the epicardium, in degrees from -90 to 90. Default: -60.
   */
  vtkSetMacro(EpicardialHelixAngle, double);
  vtkGetMacro(EpicardialHelixAngle, double);
  ///@}

  ///@{
  /**
   * The angle by which fibres lean out of the wall's tangent towards the epicardium, in degrees from -90
   * to 90. Default: 0.
   */
  vtkSetMacro(TransverseAngle, double);
  vtkGetMacro(TransverseAngle, double);
  ///@}

  ///@{
  /**
   * The heart's long axis. Default: 0 0 0, the direction in which the muscle is longest.
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkRuleBasedFibers() = default;
  ~vtkRuleBasedFibers() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRuleBasedFibers(const vtkRuleBasedFibers&) = delete;
  void operator=(const vtkRuleBasedFibers&) = delete;

  std::vector<int> MuscleMaterials{ 1 };
  std::string Endocardium;
  std::string Epicardium;
  double EndocardialHelixAngle = 60.0;
  double EpicardialHelixAngle = -60.0;
  double TransverseAngle = 0.0;
  double Axis[3] = { 0.0, 0.0, 0.0 };
};

#endif
