// SPDX-License-Identifier: BSD-3-Clause
#include "ImageVoxels.h"

#include "../Geometry/Quality.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace lamina
{
namespace
{

constexpr Id PieceVoxels = 1000; ///< smaller pieces are not compared

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

double VolumeOf(const VolumeMesh& mesh, Id cell)
{
  switch (mesh.types[Index(cell)])
  {
    case CellType::Wedge:
      return WedgeVolume(PlacesOf<6>(mesh, cell));
    case CellType::Pyramid:
      return PyramidVolume(PlacesOf<5>(mesh, cell));
    default:
    {
      const auto n = PlacesOf<4>(mesh, cell);
      return TetVolume(n[0], n[1], n[2], n[3]);
    }
  }
}

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

} // namespace

void CompareVolumes(const VolumeMesh& mesh, const ImageVoxels& voxels, ImageAudit& audit)
{
  const LabelImage& image = voxels.Labels();
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

} // namespace lamina
