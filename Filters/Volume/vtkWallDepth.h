// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWallDepth
 * @brief   tells how deep cells lie in a wall, and the direction across it
 *
 * Input: vtkUnstructuredGrid of tetrahedra, wedges and pyramids with MaterialIds on the cells and, in the
 * field data, the patches of vtkFluidSolidMesh.
 *
 * Output: the input with WallDepth (double, on points and cells: 0 on the inner wall, 1 on the outer, -1
 * outside the materials and where there is no second wall) and LayerNormals (double x3, on cells: of length
 * 1, from the inner to the outer wall; zero where the depth is -1).
 *
 * The depth solves Laplace's equation on the cells of the materials, by linear finite elements and conjugate
 * gradients. Boundaries that are neither inner nor outer wall (vessels in the wall, ends) let nothing
 * through. As a measure of thickness: S. E. Jones, B. R. Buchbinder, I. Aharon: Three-dimensional mapping of
 * cortical thickness using Laplace's equation, Human Brain Mapping 11 (2000) 12-32.
 *
 * The result does not depend on the number of threads.
 *
 * @warning Where inner and outer wall meet, the depth jumps; points on both get one half.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkFluidSolidMesh vtkRuleBasedFibers
 */
#ifndef vtkWallDepth_h
#define vtkWallDepth_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // For names of patches
#include <vector> // For the materials

class LAMINAVOLUME_EXPORT vtkWallDepth : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkWallDepth* New();
  vtkTypeMacro(vtkWallDepth, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The materials that make up the wall. Default: 1.
   */
  void AddWallMaterial(int material);
  void ClearWallMaterials();
  int GetNumberOfWallMaterials() const { return static_cast<int>(this->WallMaterials.size()); }
  int GetWallMaterial(int index) const { return this->WallMaterials[static_cast<std::size_t>(index)]; }
  ///@}

  ///@{
  /**
   * Where the depth is 0: names of patches or pairs of materials such as 1-2 (0 is the outside), parted by
   * semicolons. Default: "", all interfaces of the materials.
   */
  vtkSetStdStringFromCharMacro(InnerWalls);
  vtkGetCharFromStdStringMacro(InnerWalls);
  ///@}

  ///@{
  /**
   * Where the depth is 1, named the same way. Default: "", all outer walls of the materials.
   */
  vtkSetStdStringFromCharMacro(OuterWalls);
  vtkGetCharFromStdStringMacro(OuterWalls);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkWallDepth() = default;
  ~vtkWallDepth() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkWallDepth(const vtkWallDepth&) = delete;
  void operator=(const vtkWallDepth&) = delete;

  std::vector<int> WallMaterials{ 1 };
  std::string InnerWalls;
  std::string OuterWalls;
};

#endif
