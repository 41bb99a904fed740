// SPDX-License-Identifier: BSD-3-Clause
#include "ExtractInterfaces.h"

#include "../Base/Text.h"
#include "../Mesh/JunctionGraph.h"
#include "../Mesh/WellComposed.h"
#include "ClusterPoints.h"
#include "CutPlacement.h"
#include "GreyCuts.h"
#include "MaskCut.h"
#include "PlanePatches.h"
#include "RepairBooks.h"
#include "VoxelFaces.h"

#include <algorithm>

namespace lamina
{

namespace
{

constexpr double shortEdge = 0.8;        ///< voxels: ends that are nearer are merged
constexpr double clusterTolerance = 0.2; ///< voxels between the surface before and after that

class Extraction
{
public:
  Extraction(const LabelImage& image, const std::vector<VoxelFace>& faces)
    : Image(image)
    , Size(image.grid.size)
    , Faces(faces)
  {
  }
  void NumberPoints(TriangleComplex& surface);
  void MakeTriangles(TriangleComplex& surface);
  const std::vector<int>& PlanesOfTriangles() const { return this->PlaneOfTriangle; }
  /// Note on the triangles what the repair of the labels owes to their materials.
  void BookClaims(const std::vector<RepairClaim>& claims, TriangleComplex& surface) const;

private:
  std::size_t Lattice(Id i, Id j, Id k) const
  {
    return static_cast<std::size_t>(i + (this->Size[0] + 1) * (j + (this->Size[1] + 1) * k));
  }

  const LabelImage& Image;
  std::array<Id, 3> Size;
  const std::vector<VoxelFace>& Faces;
  std::vector<int> PointOfLattice;
  std::vector<int> PlaneOfTriangle; ///< VoxelFace::plane, negative for openings
};

void Extraction::NumberPoints(TriangleComplex& surface)
{
  this->PointOfLattice.assign(this->Lattice(this->Size[0], this->Size[1], this->Size[2]) + 1, -1);
  for (const VoxelFace& face : this->Faces)
  {
    for (const auto& c : face.Corners())
    {
      this->PointOfLattice[this->Lattice(c[0], c[1], c[2])] = 0;
    }
  }
  std::size_t at = 0;
  for (Id k = 0; k <= this->Size[2]; ++k)
  {
    for (Id j = 0; j <= this->Size[1]; ++j)
    {
      for (Id i = 0; i <= this->Size[0]; ++i, ++at)
      {
        if (this->PointOfLattice[at] == 0)
        {
          this->PointOfLattice[at] = static_cast<int>(surface.points.size());
          surface.points.push_back(this->Image.grid.ToWorld(
            static_cast<double>(i) - 0.5, static_cast<double>(j) - 0.5, static_cast<double>(k) - 0.5));
        }
      }
    }
  }
}

void Extraction::MakeTriangles(TriangleComplex& surface)
{
  const bool mirrored = this->Image.grid.IsMirrored();
  for (const VoxelFace& face : this->Faces)
  {
    const bool lowFirst = face.high == 0 || (face.low != 0 && face.low < face.high);
    const MaterialPair pair =
      lowFirst ? MaterialPair{ face.low, face.high } : MaterialPair{ face.high, face.low };
    const auto corners = face.Corners();
    std::array<Id, 4> q;
    for (std::size_t n = 0; n < 4; ++n)
    {
      q[n] = this->PointOfLattice[this->Lattice(corners[n][0], corners[n][1], corners[n][2])];
    }
    if (lowFirst == mirrored)
    {
      std::swap(q[1], q[3]);
    }
    // Diagonals alternate like the fields of a chess board, so that no direction is preferred.
    const bool even = (face.corner[0] + face.corner[1] + face.corner[2]) % 2 == 0;
    const Triangle s = even ? Triangle{ q[0], q[1], q[2] } : Triangle{ q[0], q[1], q[3] };
    const Triangle t = even ? Triangle{ q[0], q[2], q[3] } : Triangle{ q[1], q[2], q[3] };
    for (const Triangle& triangle : { s, t })
    {
      surface.triangles.push_back(triangle);
      surface.materials.push_back(pair);
      // An opening inside the image (at the mask's edge) lies in a plane of its own: its axis and position.
      int plane = face.plane;
      if (face.open)
      {
        plane = -(1 + face.axis + 3 * static_cast<int>(face.corner[static_cast<std::size_t>(face.axis)]));
      }
      this->PlaneOfTriangle.push_back(plane);
    }
  }
}

void Extraction::BookClaims(const std::vector<RepairClaim>& claims, TriangleComplex& surface) const
{
  if (claims.empty())
  {
    return;
  }
  surface.missing.resize(surface.triangles.size(), { { 0, 0 } });
  const auto before = [](const VoxelFace& face, const RepairClaim& claim)
  {
    const auto& a = face.corner;
    const auto& b = claim.corner;
    return std::array<Id, 4>{ a[2], a[1], a[0], face.axis } <
           std::array<Id, 4>{ b[2], b[1], b[0], claim.axis };
  };
  for (const RepairClaim& claim : claims)
  {
    const auto face = std::lower_bound(this->Faces.begin(), this->Faces.end(), claim, before);
    for (std::size_t half = 0; half < 2; ++half)
    {
      const std::size_t t = 2 * static_cast<std::size_t>(face - this->Faces.begin()) + half;
      const double area = 0.5 * Norm(AreaVector2(surface.points, surface.triangles[t]));
      surface.missing[t][surface.materials[t].first == claim.material ? 0 : 1] +=
        0.5 * claim.voxels * this->Image.grid.VoxelVolume() / (area * std::sqrt(area));
    }
  }
}

Result<ExtractInterfacesReport> CheckImage(const LabelImage& image, const ExtractInterfacesOptions& options)
{
  const auto& size = image.grid.size;
  if (size[0] < 2 || size[1] < 2 || size[2] < 2)
  {
    return InvalidInput("the label image is not three-dimensional (" + SizeText(size) +
                        " voxels): give an image with at least 2 voxels along each axis");
  }
  if (static_cast<Id>(image.labels.size()) != image.grid.Count())
  {
    return InvalidInput("the label image has " + std::to_string(image.labels.size()) + " values for " +
                        std::to_string(image.grid.Count()) + " voxels");
  }
  const auto range = std::minmax_element(image.labels.begin(), image.labels.end());
  if (*range.first < 0 || *range.second > LargestMaterial)
  {
    return InvalidInput("material ids must lie between 0 and 65535, but the image holds " +
                        std::to_string(*range.first) + " to " + std::to_string(*range.second));
  }
  if (*range.second == 0)
  {
    return InvalidInput(
      "every voxel is background (0): there is no material to extract; check the thresholds or the labels");
  }
  if (options.mask != nullptr && options.mask->grid.size != size)
  {
    return InvalidInput("the mask is not of the same size as the label image");
  }
  if (options.grey != nullptr &&
      (options.grey->grid.size != size || options.grey->Count() != image.grid.Count()))
  {
    return InvalidInput("the grey image is not of the same size as the label image");
  }
  return ExtractInterfacesReport{};
}

std::vector<double> ImageVolumes(const LabelImage& image, const std::vector<int>& materials)
{
  std::vector<Id> voxels(65536, 0);
  for (const int label : image.labels)
  {
    ++voxels[static_cast<std::size_t>(label)];
  }
  std::vector<double> volumes;
  for (const int material : materials)
  {
    volumes.push_back(static_cast<double>(voxels[static_cast<std::size_t>(material)]) *
                      image.grid.VoxelVolume());
  }
  return volumes;
}

void NoteRepair(const GridGeometry& grid, const std::vector<Id>& repaired, ExtractInterfacesReport& report)
{
  constexpr std::size_t mostPlaces = 100;
  report.repairedVoxels = static_cast<Id>(repaired.size());
  for (std::size_t n = 0; n < repaired.size() && n < mostPlaces; ++n)
  {
    const Id i = repaired[n] % grid.size[0];
    const Id j = repaired[n] / grid.size[0] % grid.size[1];
    const Id k = repaired[n] / grid.size[0] / grid.size[1];
    report.repairedPlaces.push_back(
      grid.ToWorld(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
  }
}

/// What lies between the voxel faces and the cuts belongs to the materials that gain it: on each triangle so
/// much for its first, and against its second.
void AddPartialVolumes(const TriangleComplex& surface, const std::vector<double>& growth,
                       ExtractInterfacesReport& report)
{
  const auto add = [&](int material, double volume)
  {
    const auto m = std::lower_bound(report.materials.begin(), report.materials.end(), material);
    if (m != report.materials.end() && *m == material)
    {
      report.imageVolumes[static_cast<std::size_t>(m - report.materials.begin())] += volume;
    }
  };
  for (std::size_t t = 0; t < growth.size(); ++t)
  {
    add(surface.materials[t].first, growth[t]);
    add(surface.materials[t].second, -growth[t]);
  }
}

} // namespace

Result<ExtractInterfacesReport> ExtractInterfaces(const LabelImage& image, TriangleComplex& surface,
                                                  const ExtractInterfacesOptions& options, Monitor& monitor)
{
  Result<ExtractInterfacesReport> checked = CheckImage(image, options);
  if (!checked)
  {
    return checked.GetError();
  }
  ExtractInterfacesReport report = *checked;
  monitor.Progress(0, "repairing contacts");
  LabelImage labels = image;
  std::vector<char> cut;
  if (options.openAtMaskBorder && options.mask != nullptr)
  {
    cut = CutMaterialsAtMask(labels, *options.mask, options.openMaterials);
  }
  const LabelImage beforeRepair = cut.empty() ? LabelImage{} : labels;
  const LabelImage& first = cut.empty() ? image : beforeRepair;
  SubMonitor early(monitor, 0, 0.4);
  const std::vector<Id> repaired = RepairTopology(labels, RepairOptions(), early).changed;
  NoteRepair(labels.grid, repaired, report);
  monitor.Progress(0.4, "extracting interfaces");
  surface = TriangleComplex{};
  auto faces = CollectVoxelFaces(labels, options, cut, monitor);
  if (!faces)
  {
    return Cancelled();
  }
  Extraction extraction(labels, *faces);
  extraction.NumberPoints(surface);
  monitor.Progress(0.6, "extracting interfaces");
  extraction.MakeTriangles(surface);
  GreyCutsReport cuts;
  if (options.grey != nullptr)
  {
    cuts =
      PlaceAtGreyCuts(labels.grid, *faces, FindGreyCuts(*faces, *options.grey, monitor), surface, monitor);
    report.movedPoints = cuts.movedPoints;
    report.heldPoints = cuts.heldPoints;
  }
  report.materials = MaterialsOf(surface);
  report.imageVolumes = ImageVolumes(first, report.materials);
  AddPartialVolumes(surface, cuts.growth, report);
  const RepairBooks books = BookRepair(first, labels, repaired);
  extraction.BookClaims(books.claims, surface);
  report.lostVoxels = books.lostVoxels;
  report.openings = NamePlanePatches(extraction.PlanesOfTriangles(), surface);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  if (options.clusterPoints)
  {
    const Vec3& spacing = labels.grid.spacing;
    const double voxel = std::min({ spacing.x, spacing.y, spacing.z });
    report.clusteredPoints = ClusterPoints(surface, shortEdge * voxel, clusterTolerance * voxel, monitor);
  }
  monitor.Progress(0.8, "classifying junctions");
  ClassifyJunctions(surface);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  report.points = static_cast<Id>(surface.points.size());
  report.triangles = static_cast<Id>(surface.triangles.size());
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    report.junctionCurveEdges += table.triangles.Count(static_cast<Id>(e)) != 2 ? 1 : 0;
  }
  monitor.Progress(1, "interfaces extracted");
  return report;
}

} // namespace lamina
