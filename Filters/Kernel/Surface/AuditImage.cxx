// SPDX-License-Identifier: BSD-3-Clause
#include "AuditImage.h"

#include "../Geometry/Quality.h"
#include "../Mesh/CellFaces.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace lamina
{
namespace
{

constexpr Id Grain = 512;
constexpr Id PieceVoxels = 1000; ///< smaller pieces are not compared
constexpr int Farthest = 8;      ///< voxels that are searched for a border

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

template<std::size_t N>
std::array<Vec3, N> Nodes(const VolumeMesh& mesh, Id cell)
{
  std::array<Vec3, N> nodes;
  for (std::size_t k = 0; k < N; ++k)
  {
    nodes[k] = mesh.points[Index(mesh.Cell(cell)[k])];
  }
  return nodes;
}

double VolumeOf(const VolumeMesh& mesh, Id cell)
{
  switch (mesh.types[Index(cell)])
  {
    case CellType::Wedge:
      return WedgeVolume(Nodes<6>(mesh, cell));
    case CellType::Pyramid:
      return PyramidVolume(Nodes<5>(mesh, cell));
    default:
    {
      const auto n = Nodes<4>(mesh, cell);
      return TetVolume(n[0], n[1], n[2], n[3]);
    }
  }
}

/// The image in the mesh's lengths.
class Voxels
{
public:
  Voxels(const LabelImage& image, double scale)
    : Image(image)
    , Scale(scale)
  {
  }
  /// Position in voxels: whole numbers are the middles.
  Vec3 Locate(const Vec3& world) const
  {
    const Vec3 p = world * (1 / this->Scale) - this->Image.grid.origin;
    const auto& d = this->Image.grid.direction;
    const Vec3& s = this->Image.grid.spacing;
    return { (d[0] * p.x + d[3] * p.y + d[6] * p.z) / s.x, (d[1] * p.x + d[4] * p.y + d[7] * p.z) / s.y,
             (d[2] * p.x + d[5] * p.y + d[8] * p.z) / s.z };
  }
  bool Has(const std::array<Id, 3>& v) const
  {
    const auto& n = this->Image.grid.size;
    return v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < n[0] && v[1] < n[1] && v[2] < n[2];
  }
  /// Background outside the image.
  int Label(const std::array<Id, 3>& v) const
  {
    return this->Has(v) ? this->Image.labels[Index(this->Image.grid.Index(v[0], v[1], v[2]))] : 0;
  }
  double Volume() const { return this->Image.grid.VoxelVolume() * this->Scale * this->Scale * this->Scale; }
  double Edge() const { return std::cbrt(this->Image.grid.VoxelVolume()); }

  /// Distance to the nearest face between voxels of the two materials, in the image's lengths.
  double ToBorder(const Vec3& world, const MaterialPair& pair) const
  {
    const Vec3 at = this->Locate(world);
    const std::array<Id, 3> home{ { std::llround(at.x), std::llround(at.y), std::llround(at.z) } };
    const Vec3& s = this->Image.grid.spacing;
    const double step = std::min({ s.x, s.y, s.z });
    double best = std::numeric_limits<double>::infinity();
    for (int reach = 1; reach <= Farthest && !(best <= (reach - 1.5) * step); ++reach)
    {
      best = this->NearestFace(at, home, reach, pair);
    }
    return std::min(best, Farthest * step);
  }

private:
  double NearestFace(const Vec3& at, const std::array<Id, 3>& home, int reach, const MaterialPair& pair) const
  {
    double best2 = std::numeric_limits<double>::infinity();
    for (Id k = home[2] - reach; k <= home[2] + reach; ++k)
    {
      for (Id j = home[1] - reach; j <= home[1] + reach; ++j)
      {
        for (Id i = home[0] - reach; i <= home[0] + reach; ++i)
        {
          const int here = this->Label({ { i, j, k } });
          if (here != pair.first && here != pair.second)
          {
            continue;
          }
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            std::array<Id, 3> next{ { i, j, k } };
            ++next[axis];
            const int there = this->Label(next);
            if (here != there && (there == pair.first || there == pair.second))
            {
              best2 = std::min(best2, this->ToFace2(at, { { i, j, k } }, axis));
            }
          }
        }
      }
    }
    return std::sqrt(best2);
  }

  /// To the square between a voxel and the next one along the axis.
  double ToFace2(const Vec3& at, const std::array<Id, 3>& voxel, std::size_t axis) const
  {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double away = at[static_cast<int>(k)] - static_cast<double>(voxel[k]);
      const double d = k == axis ? away - 0.5 : std::max(0.0, std::abs(away) - 0.5);
      sum += std::pow(d * this->Image.grid.spacing[static_cast<int>(k)], 2);
    }
    return sum;
  }

  const LabelImage& Image;
  double Scale;
};

/// Pieces of equal label that hang together through faces: a number a voxel, -1 in the background.
std::vector<Id> FindImagePieces(const LabelImage& image, std::vector<PieceVolume>& pieces)
{
  std::vector<Id> pieceOf(image.labels.size(), -1);
  const auto& n = image.grid.size;
  const std::array<Id, 3> steps{ { 1, n[0], n[0] * n[1] } };
  std::vector<Id> stack;
  for (Id seed = 0; seed < image.grid.Count(); ++seed)
  {
    const int label = image.labels[Index(seed)];
    if (label == 0 || pieceOf[Index(seed)] >= 0)
    {
      continue;
    }
    const Id piece = static_cast<Id>(pieces.size());
    pieces.push_back({ label, 0, 0, 0 });
    pieceOf[Index(seed)] = piece;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const Id v = stack.back();
      stack.pop_back();
      ++pieces.back().voxels;
      const std::array<Id, 3> at{ { v % n[0], v / n[0] % n[1], v / n[0] / n[1] } };
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (int way = -1; way <= 1; way += 2)
        {
          const Id next = v + way * steps[axis];
          const bool isInside = at[axis] + way >= 0 && at[axis] + way < n[axis];
          if (isInside && image.labels[Index(next)] == label && pieceOf[Index(next)] < 0)
          {
            pieceOf[Index(next)] = piece;
            stack.push_back(next);
          }
        }
      }
    }
  }
  return pieceOf;
}

/// The piece of the mesh that each cell is in: cells of one material that share nodes.
std::vector<Id> FindMeshPieces(const VolumeMesh& mesh)
{
  std::map<int, std::vector<Id>> cellsOf;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    cellsOf[mesh.materials[Index(c)]].push_back(c);
  }
  std::vector<Id> pieceOf(mesh.types.size());
  std::vector<Id> parent(mesh.points.size());
  for (const auto& entry : cellsOf)
  {
    std::iota(parent.begin(), parent.end(), Id{ 0 });
    const auto root = [&](Id p)
    {
      while (parent[Index(p)] != p)
      {
        p = parent[Index(p)] = parent[Index(parent[Index(p)])];
      }
      return p;
    };
    for (Id c : entry.second)
    {
      for (int k = 1; k < NodeCount(mesh.types[Index(c)]); ++k)
      {
        const Id a = root(mesh.Cell(c)[0]);
        const Id b = root(mesh.Cell(c)[k]);
        parent[Index(std::max(a, b))] = std::min(a, b);
      }
    }
    for (Id c : entry.second)
    {
      pieceOf[Index(c)] = root(mesh.Cell(c)[0]);
    }
  }
  return pieceOf;
}

void CompareVolumes(const VolumeMesh& mesh, const LabelImage& image, const Voxels& voxels, ImageAudit& audit)
{
  std::vector<PieceVolume> pieces;
  const std::vector<Id> imagePiece = FindImagePieces(image, pieces);
  const std::vector<Id> meshPiece = FindMeshPieces(mesh);
  std::map<int, PieceVolume> materials;
  std::map<std::pair<int, Id>, double> volumes;             // of the mesh's pieces
  std::map<std::pair<int, Id>, std::map<Id, double>> votes; // for the image's
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const int material = mesh.materials[Index(c)];
    const double volume = VolumeOf(mesh, c);
    materials[material].meshVolume += volume;
    const std::pair<int, Id> key(material, meshPiece[Index(c)]);
    volumes[key] += volume;
    Vec3 middle;
    const int n = NodeCount(mesh.types[Index(c)]);
    for (int k = 0; k < n; ++k)
    {
      middle += mesh.points[Index(mesh.Cell(c)[k])] * (1.0 / n);
    }
    const Vec3 at = voxels.Locate(middle);
    const std::array<Id, 3> v{ { std::llround(at.x), std::llround(at.y), std::llround(at.z) } };
    if (voxels.Label(v) == material)
    {
      votes[key][imagePiece[Index(image.grid.Index(v[0], v[1], v[2]))]] += volume;
    }
  }
  for (const auto& [key, volume] : volumes)
  {
    const auto& list = votes[key];
    const auto best = std::max_element(list.begin(), list.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (best != list.end())
    {
      pieces[Index(best->first)].meshVolume += volume;
    }
  }
  const auto error = [](const PieceVolume& p) { return std::abs(p.meshVolume / p.voxelVolume - 1); };
  for (PieceVolume& piece : pieces)
  {
    piece.voxelVolume = static_cast<double>(piece.voxels) * voxels.Volume();
    const auto material = materials.find(piece.material);
    if (material == materials.end())
    {
      continue; // not meshed
    }
    material->second.material = piece.material;
    material->second.voxels += piece.voxels;
    material->second.voxelVolume += piece.voxelVolume;
    if (piece.voxels >= PieceVoxels)
    {
      audit.pieces.push_back(piece);
      audit.largestPieceError = std::max(audit.largestPieceError, error(piece));
    }
  }
  std::stable_sort(audit.pieces.begin(), audit.pieces.end(),
                   [](const PieceVolume& a, const PieceVolume& b)
                   { return a.material != b.material ? a.material < b.material : a.voxels > b.voxels; });
  for (const auto& entry : materials)
  {
    if (entry.second.voxels > 0)
    {
      audit.materials.push_back(entry.second);
      audit.largestMaterialError = std::max(audit.largestMaterialError, error(entry.second));
    }
  }
}

/// Area-weighted figures of distances.
InterfaceDistance Summarize(const MaterialPair& pair, std::vector<std::pair<double, double>>& samples)
{
  std::sort(samples.begin(), samples.end());
  InterfaceDistance d;
  d.pair = pair;
  double total = 0;
  for (const auto& sample : samples)
  {
    total += sample.second;
  }
  const auto at = [&](double share)
  {
    double sum = 0;
    for (const auto& sample : samples)
    {
      sum += sample.second;
      if (sum >= share * total)
      {
        return sample.first;
      }
    }
    return samples.back().first;
  };
  d.median = at(0.5);
  d.p95 = at(0.95);
  d.largest = samples.back().first;
  double within = 0;
  for (const auto& sample : samples)
  {
    within += sample.first <= 0.5 ? sample.second : 0;
  }
  d.within = within / total;
  return d;
}

void MeasureDistances(const VolumeMesh& mesh, const MeshPatches& patches, const Voxels& voxels,
                      ImageAudit& audit, Monitor& monitor)
{
  std::vector<std::pair<double, double>> all(patches.faces.size());
  monitor.For(static_cast<Id>(patches.faces.size()), Grain,
              [&](Id begin, Id end)
              {
                for (Id f = begin; f < end; ++f)
                {
                  const PatchFace& face = patches.faces[Index(f)];
                  const MeshPatch& patch = patches.patches[Index(face.patch)];
                  const CellFace corners = FaceOf(mesh, face.cell, face.face);
                  const auto at = [&](std::size_t k) { return mesh.points[Index(corners.corners[k])]; };
                  const Vec3 middle = (at(0) + at(1) + at(2)) * (1.0 / 3);
                  all[Index(f)] = { voxels.ToBorder(middle, patch.pair) / voxels.Edge(),
                                    0.5 * Norm(Cross(at(1) - at(0), at(2) - at(0))) };
                }
              });
  std::map<MaterialPair, std::vector<std::pair<double, double>>> samples;
  for (std::size_t f = 0; f < all.size(); ++f)
  {
    const MeshPatch& patch = patches.patches[Index(patches.faces[f].patch)];
    if (patch.kind == PatchKind::Interface || patch.kind == PatchKind::Wall)
    {
      samples[patch.pair].push_back(all[f]);
    }
  }
  for (auto& [pair, list] : samples)
  {
    audit.interfaces.push_back(Summarize(pair, list));
  }
}

} // namespace

Result<ImageAudit> AuditAgainstImage(const VolumeMesh& mesh, const MeshPatches& patches,
                                     const LabelImage& image, double scale, Monitor& monitor)
{
  if (!(scale > 0 && std::isfinite(scale)))
  {
    return InvalidOption("scale must be above 0");
  }
  if (static_cast<Id>(image.labels.size()) != image.grid.Count())
  {
    return InvalidInput("the image has " + std::to_string(image.labels.size()) + " labels for " +
                        std::to_string(image.grid.Count()) + " voxels");
  }
  ImageAudit audit;
  const Voxels voxels(image, scale);
  monitor.Progress(0, "Comparing with the voxels");
  CompareVolumes(mesh, image, voxels, audit);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.3, "Measuring distances to the voxels' border");
  MeasureDistances(mesh, patches, voxels, audit, monitor);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  return audit;
}

} // namespace lamina
