// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPrismLayer
 * @brief   grows layers of prisms from the walls of the fluid materials of a surface
 *
 * Input: vtkPolyData of triangles with BoundaryLabels and, on the points, MaterialFeatureSize (double, from
 * vtkFeatureSize), the same surface that vtkLayeredTetrahedra gets.
 *
 * Output, port 0: vtkUnstructuredGrid of wedges (tetrahedra and pyramids where columns had to stop: at
 * openings and at nodes that no direction sees) with MaterialIds and LayerIds (int, 1 touches the wall) on
 * the cells, LayerIndex (int, 0 on the wall) and InterfaceNodeIds (vtkIdType, the surface point a node is,
 * else -1) on the points. Port 1: vtkPolyData, the closed surfaces that bound what is left, with
 * BoundaryLabels (fluid, 0; both fluids where columns on both sides stopped), and LayerHeight and LayerSide
 * (double, 1 and 3 components: of the last layer) on the points. Port 2: the input surface with
 * LayersAchieved (int) and LayerFraction (double, the share of the asked thickness) on its triangles.
 *
 * Points are marched inwards along directions that see all faces around them, each layer thicker than the one
 * before by GrowthRatio, and no farther than the room in front of them allows; then the front is smoothed.
 * R. Loehner, J. Cebral, Generation of non-isotropic unstructured grids via directional enrichment, IJNME 49
 * (2000); V. Dyedov and others, Variational generation of prismatic boundary-layer meshes, IJNME 79 (2009).
 *
 * Every triangle of a fluid's wall belongs unchanged to one cell; the Jacobian of every cell is positive
 * everywhere; the inner surface does not intersect itself, tested exactly.
 *
 * @warning Layers are thinner or fewer where there is little room: LayersAchieved, LayerFraction on port 2.
 * @warning A material of FluidMaterials that the surface lacks is an error; of the default list, a warning.
 * @warning This class has been threaded with vtkSMPTools.
 *
 * @sa vtkFeatureSizeRefinement vtkCoreTetrahedra vtkFluidSolidMesh
 */
#ifndef vtkPrismLayer_h
#define vtkPrismLayer_h

#include "LaminaVolumeModule.h" // For the export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <vector> // For the list of materials

class LAMINAVOLUME_EXPORT vtkPrismLayer : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkPrismLayer* New();
  vtkTypeMacro(vtkPrismLayer, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The fluids, whose walls carry prisms. Default: 2, blood.
   */
  void AddFluidMaterial(int material);
  void ClearFluidMaterials();
  int GetNumberOfFluidMaterials() { return static_cast<int>(this->FluidMaterials.size()); }
  int GetFluidMaterial(int index);
  ///@}

  ///@{
  /**
   * Prisms on every triangle of a wall, 1 or more. Default: 5.
   */
  vtkSetMacro(Layers, int);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /**
   * The height of a layer over that of the one below it, from 1 to 3. Default: 1.2.
   */
  vtkSetMacro(GrowthRatio, double);
  vtkGetMacro(GrowthRatio, double);
  ///@}

  ///@{
  /**
   * The height of all layers together over the local feature size, above 0, at most 0.45. Default: 0.25.
   */
  vtkSetMacro(Thickness, double);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * The height of all layers together, or of the first one, a length, instead of the share; 0: by the share.
   * Where it asks for more than 0.45 of the local feature size, layers are thinner. Default: 0.
   */
  vtkSetMacro(TotalThickness, double);
  vtkGetMacro(TotalThickness, double);
  vtkSetMacro(FirstHeight, double);
  vtkGetMacro(FirstHeight, double);
  ///@}

  ///@{
  /**
   * Prisms have a scaled aspect ratio above this, in [0, 1): where the wall does not allow it, columns end in
   * pyramids and tetrahedra; but not at points that Surface Refinement flags as hidden, nor at triangles with
   * 2r/R below 0.3. 0: only valid ones are asked for. Default: 0.2.
   */
  vtkSetMacro(LeastQuality, double);
  vtkGetMacro(LeastQuality, double);
  ///@}

  ///@{
  /**
   * Columns end in pyramids and tetrahedra where no layers can stand; off: that is an error with the places.
   * Default: on.
   */
  vtkSetMacro(EndColumns, bool);
  vtkGetMacro(EndColumns, bool);
  vtkBooleanMacro(EndColumns, bool);
  ///@}

  ///@{
  /**
   * The materials on whose walls prisms grow (0 is the outside), and the patches of the surface on which they
   * do (PatchIds; 0 for walls of no other; never on openings). Default: none, which stands for all.
   */
  void AddNeighbourMaterial(int material);
  void ClearNeighbourMaterials();
  int GetNumberOfNeighbourMaterials() { return static_cast<int>(this->NeighbourMaterials.size()); }
  int GetNeighbourMaterial(int index);
  void AddWallPatchId(int patch);
  void ClearWallPatchIds();
  int GetNumberOfWallPatchIds() { return static_cast<int>(this->WallPatchIds.size()); }
  int GetWallPatchId(int index);
  ///@}

  ///@{
  /**
   * The memory that the filter may take, in GiB; it refuses what it estimates to take more. 0: what is free on
   * the machine. Default: 0.
   */
  vtkSetClampMacro(MemoryLimit, double, 0, 1e9);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  /**
   * What came out, in a line, for people: its words may change. Empty before the first run.
   */
  const char* GetSummary();

protected:
  vtkPrismLayer();
  ~vtkPrismLayer() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPrismLayer(const vtkPrismLayer&) = delete;
  void operator=(const vtkPrismLayer&) = delete;

  std::vector<int> FluidMaterials{ 2 };
  int Layers = 5;
  double GrowthRatio = 1.2;
  double Thickness = 0.25;
  double TotalThickness = 0.0;
  double FirstHeight = 0.0;
  double LeastQuality = 0.2;
  bool EndColumns = true;
  std::vector<int> NeighbourMaterials;
  std::vector<int> WallPatchIds;
  double MemoryLimit = 0.0;
};

#endif
