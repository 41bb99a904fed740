// SPDX-License-Identifier: BSD-3-Clause
#include "ExtractInterfaces.h"

#include "../Base/Text.h"
#include "../Mesh/JunctionGraph.h"
#include "../Mesh/WellComposed.h"
#include "MaskCut.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace lamina
{

namespace
{

/// A voxel face between two materials: the lattice point of its lower corner, its axis, and what lies on
/// either side.
struct Face
{
  std::array<Id, 3> corner;
  int axis;
  int low;   ///< label on the low side of the face
  int high;  ///< label on the high side
  int plane; ///< 0 inside the image, else 1 + 2 * axis + (1 at the high border)
  bool open;
};

class Extraction
{
public:
  Extraction(const LabelImage& image, const ExtractInterfacesOptions& options, const std::vector<char>& cut)
    : Image(image)
    , Options(options)
    , Cut(cut)
    , Size(image.grid.size)
  {
  }
  bool CollectFaces(Monitor& monitor);
  void NumberPoints(TriangleComplex& surface);
  void MakeTriangles(TriangleComplex& surface);
  Id NamePatches(TriangleComplex& surface);

private:
  int Label(const std::array<Id, 3>& v, bool& outside) const
  {
    outside = v[0] < 0 || v[1] < 0 || v[2] < 0 || v[0] >= this->Size[0] || v[1] >= this->Size[1] ||
              v[2] >= this->Size[2];
    return outside ? 0
                   : this->Image.labels[static_cast<std::size_t>(this->Image.grid.Index(v[0], v[1], v[2]))];
  }
  bool WasCut(const std::array<Id, 3>& v) const
  {
    return !this->Cut.empty() &&
           this->Cut[static_cast<std::size_t>(this->Image.grid.Index(v[0], v[1], v[2]))];
  }
  bool IsOpen(const Face& face, const std::array<Id, 3>& low, const std::array<Id, 3>& high) const;
  void CollectSlice(Id k, std::vector<Face>& faces) const;
  std::size_t Lattice(Id i, Id j, Id k) const
  {
    return static_cast<std::size_t>(i + (this->Size[0] + 1) * (j + (this->Size[1] + 1) * k));
  }
  std::array<std::array<Id, 3>, 4> Corners(const Face& face) const;

  const LabelImage& Image;
  const ExtractInterfacesOptions& Options;
  const std::vector<char>& Cut; ///< voxels that a plane end at the mask's edge took
  std::array<Id, 3> Size;
  std::vector<Face> Faces;
  std::vector<int> PointOfLattice;
  std::vector<int> PlaneOfTriangle; ///< Face::plane, negative for openings
};

bool Extraction::IsOpen(const Face& face, const std::array<Id, 3>& low, const std::array<Id, 3>& high) const
{
  const int material = face.low == 0 ? face.high : face.low;
  const auto& open = this->Options.openMaterials;
  if ((face.low != 0 && face.high != 0) || std::find(open.begin(), open.end(), material) == open.end())
  {
    return false;
  }
  if (face.plane != 0)
  {
    return this->Options.openAtImageBorder;
  }
  return this->WasCut(face.low == 0 ? low : high);
}

void Extraction::CollectSlice(Id k, std::vector<Face>& faces) const
{
  for (Id j = 0; j <= this->Size[1]; ++j)
  {
    for (Id i = 0; i <= this->Size[0]; ++i)
    {
      const std::array<Id, 3> high{ i, j, k };
      bool outsideHigh = false;
      const int labelHigh = this->Label(high, outsideHigh);
      for (int axis = 0; axis < 3; ++axis)
      {
        std::array<Id, 3> low = high;
        --low[static_cast<std::size_t>(axis)];
        bool outsideLow = false;
        const int labelLow = this->Label(low, outsideLow);
        if (labelLow == labelHigh)
        {
          continue;
        }
        Face face{ high, axis, labelLow, labelHigh, 0, false };
        face.plane = outsideLow ? 1 + 2 * axis : (outsideHigh ? 2 + 2 * axis : 0);
        face.open = this->IsOpen(face, low, high);
        faces.push_back(face);
      }
    }
  }
}

bool Extraction::CollectFaces(Monitor& monitor)
{
  std::vector<std::vector<Face>> slices(static_cast<std::size_t>(this->Size[2] + 1));
  monitor.For(this->Size[2] + 1, 2,
              [&](Id begin, Id end)
              {
                for (Id k = begin; k < end; ++k)
                {
                  this->CollectSlice(k, slices[static_cast<std::size_t>(k)]);
                }
              });
  for (const auto& slice : slices)
  {
    this->Faces.insert(this->Faces.end(), slice.begin(), slice.end());
  }
  return !monitor.Cancelled();
}

/// The four lattice corners, counter-clockwise seen from the high side.
std::array<std::array<Id, 3>, 4> Extraction::Corners(const Face& face) const
{
  const auto u = static_cast<std::size_t>((face.axis + 1) % 3);
  const auto v = static_cast<std::size_t>((face.axis + 2) % 3);
  std::array<std::array<Id, 3>, 4> corners{ { face.corner, face.corner, face.corner, face.corner } };
  ++corners[1][u];
  ++corners[2][u];
  ++corners[2][v];
  ++corners[3][v];
  return corners;
}

void Extraction::NumberPoints(TriangleComplex& surface)
{
  this->PointOfLattice.assign(this->Lattice(this->Size[0], this->Size[1], this->Size[2]) + 1, -1);
  for (const Face& face : this->Faces)
  {
    for (const auto& c : this->Corners(face))
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
  for (const Face& face : this->Faces)
  {
    const bool lowFirst = face.high == 0 || (face.low != 0 && face.low < face.high);
    const MaterialPair pair =
      lowFirst ? MaterialPair{ face.low, face.high } : MaterialPair{ face.high, face.low };
    const auto corners = this->Corners(face);
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

Id Extraction::NamePatches(TriangleComplex& surface)
{
  if (std::all_of(this->PlaneOfTriangle.begin(), this->PlaneOfTriangle.end(), [](int p) { return p == 0; }))
  {
    return 0;
  }
  const std::size_t count = surface.triangles.size();
  std::vector<std::size_t> root(count);
  std::iota(root.begin(), root.end(), std::size_t{ 0 });
  const auto find = [&](std::size_t t)
  {
    while (root[t] != t)
    {
      t = root[t] = root[root[t]];
    }
    return t;
  };
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    for (Id s : Row(table.triangles, static_cast<Id>(e)))
    {
      for (Id t : Row(table.triangles, static_cast<Id>(e)))
      {
        const auto a = static_cast<std::size_t>(s);
        const auto b = static_cast<std::size_t>(t);
        if (a < b && this->PlaneOfTriangle[a] < 0 && this->PlaneOfTriangle[a] == this->PlaneOfTriangle[b] &&
            surface.materials[a] == surface.materials[b])
        {
          const std::size_t ra = find(a);
          const std::size_t rb = find(b);
          root[std::max(ra, rb)] = std::min(ra, rb);
        }
      }
    }
  }
  // Openings are numbered in the order of their first triangle, then come the borders.
  surface.patches.assign(count, 0);
  surface.patchNames = { "wall" };
  std::map<std::size_t, int> openings;
  for (std::size_t t = 0; t < count; ++t)
  {
    if (this->PlaneOfTriangle[t] < 0)
    {
      const auto entry = openings.insert({ find(t), static_cast<int>(surface.patchNames.size()) });
      if (entry.second)
      {
        surface.patchNames.push_back("opening_" + std::to_string(openings.size()));
      }
      surface.patches[t] = entry.first->second;
    }
  }
  std::map<int, int> borders;
  for (std::size_t t = 0; t < count; ++t)
  {
    if (this->PlaneOfTriangle[t] > 0)
    {
      const int plane = this->PlaneOfTriangle[t];
      const auto entry = borders.insert({ plane, static_cast<int>(surface.patchNames.size()) });
      if (entry.second)
      {
        surface.patchNames.push_back("border_" + std::to_string(plane));
      }
      surface.patches[t] = entry.first->second;
    }
  }
  return static_cast<Id>(openings.size());
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
  return ExtractInterfacesReport{};
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
  SubMonitor early(monitor, 0, 0.4);
  const std::vector<Id> repaired = RepairTopology(labels, RepairOptions(), early).changed;
  report.repairedVoxels = static_cast<Id>(repaired.size());
  for (std::size_t n = 0; n < repaired.size() && n < 100; ++n)
  {
    const Id i = repaired[n] % labels.grid.size[0];
    const Id j = repaired[n] / labels.grid.size[0] % labels.grid.size[1];
    const Id k = repaired[n] / labels.grid.size[0] / labels.grid.size[1];
    report.repairedPlaces.push_back(
      labels.grid.ToWorld(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)));
  }
  monitor.Progress(0.4, "extracting interfaces");
  surface = TriangleComplex{};
  Extraction extraction(labels, options, cut);
  if (!extraction.CollectFaces(monitor))
  {
    return Cancelled();
  }
  extraction.NumberPoints(surface);
  monitor.Progress(0.6, "extracting interfaces");
  extraction.MakeTriangles(surface);
  report.openings = extraction.NamePatches(surface);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  monitor.Progress(0.8, "classifying junctions");
  ClassifyJunctions(surface);
  report.points = static_cast<Id>(surface.points.size());
  report.triangles = static_cast<Id>(surface.triangles.size());
  report.materials = MaterialsOf(surface);
  const EdgeTable table = MakeEdgeTable(surface.triangles);
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    report.junctionCurveEdges += table.triangles.Count(static_cast<Id>(e)) != 2 ? 1 : 0;
  }
  monitor.Progress(1, "interfaces extracted");
  return report;
}

} // namespace lamina
