// SPDX-License-Identifier: BSD-3-Clause
#include "CutVessel.h"

#include "../Base/Text.h"
#include "../Mesh/Adjacency.h"
#include "../Mesh/Closedness.h"
#include "../Mesh/JunctionGraph.h"
#include "../Search/SelfIntersection.h"
#include "../Search/TriangleTree.h"
#include "PlaneEnds.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace lamina
{
namespace
{

/// How close to the plane a point may lie, in mean edge lengths; the plane gives way by as much.
constexpr double Closest = 1e-7;
/// Shares of an edge within which its ends are moved into the plane, tried in turn.
constexpr double Snaps[] = { 0.25, 0.1, 0.0 };

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// Height of each point over the plane. The plane is shifted by a hair if a point lies in it.
std::vector<double> Heights(const TriangleComplex& surface, PlaneFrame& frame)
{
  const double hair = Closest * MeanEdgeLength(surface);
  const Vec3 origin = frame.origin;
  std::vector<double> heights(surface.points.size());
  for (int n = 0;; ++n)
  {
    frame.origin = origin + frame.normal * (hair * (n % 2 == 0 ? n / 2 : -(n + 1) / 2));
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < heights.size(); ++p)
    {
      heights[p] = frame.Height(surface.points[p]);
      least = std::min(least, std::abs(heights[p]));
    }
    if (least > 0.01 * hair || n > 1000)
    {
      return heights;
    }
  }
}

/// The volume of all materials together.
double VolumeOf(const TriangleComplex& surface)
{
  double six = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (surface.materials[t].second == 0)
    {
      const Triangle& c = surface.triangles[t];
      const Vec3& o = surface.points[0];
      six += Dot(surface.points[Index(c[0])] - o,
                 Cross(surface.points[Index(c[1])] - o, surface.points[Index(c[2])] - o));
    }
  }
  return six / 6;
}

/// Marks the triangles of what is cut off: those that the plane cuts in a piece, and all above it that hang
/// together with them.
class CutRegion
{
public:
  CutRegion(const TriangleComplex& surface, const PlaneSection& section, const std::vector<double>& heights,
            const Vec3& up)
    : Surface(surface)
    , Section(section)
    , Heights(heights)
    , Up(up)
    , Star(TrianglesOfPoints(static_cast<Id>(surface.points.size()), surface.triangles))
    , Marks(surface.triangles.size(), 0)
  {
  }

  std::vector<char> Run(int piece)
  {
    this->TakePiece(piece);
    this->Flood();
    this->TakeShells();
    return std::move(this->Marks);
  }
  const std::set<int>& Pieces() const { return this->Taken; }

private:
  void Take(Id t)
  {
    if (this->Marks[Index(t)] == 0)
    {
      this->Marks[Index(t)] = 1;
      this->Work.push_back(t);
    }
  }
  void TakePiece(int piece)
  {
    if (piece >= 0 && this->Taken.insert(piece).second)
    {
      for (const Id t : this->Section.TrianglesOfPiece(piece))
      {
        this->Take(t);
      }
    }
  }
  /// Over points above the plane to all triangles at them.
  void Flood()
  {
    while (!this->Work.empty())
    {
      const Triangle corners = this->Surface.triangles[Index(this->Work.back())];
      this->Work.pop_back();
      for (const Id p : corners)
      {
        if (this->Heights[Index(p)] <= 0)
        {
          continue;
        }
        for (const Id t : Row(this->Star, p))
        {
          this->Take(t);
          this->TakePiece(this->Section.PieceOfTriangle(t));
        }
      }
    }
  }
  void TakeShells();
  bool IsAbove(Id t) const
  {
    const Triangle& c = this->Surface.triangles[Index(t)];
    return this->Heights[Index(c[0])] > 0 && this->Heights[Index(c[1])] > 0 && this->Heights[Index(c[2])] > 0;
  }

  const TriangleComplex& Surface;
  const PlaneSection& Section;
  const std::vector<double>& Heights;
  Vec3 Up;
  Lists Star;
  std::vector<char> Marks;
  std::vector<Id> Work;
  std::set<int> Taken;
};

/// Cavities and inclusions above the plane, whose own surface has no link to the rest: what they lie in takes
/// them along. The next wall above the highest point of each tells what that is; the plane is never in
/// between.
void CutRegion::TakeShells()
{
  const std::size_t count = this->Marks.size();
  std::vector<Id> shellOf(count, -1);
  std::vector<Id> highest;
  for (std::size_t t = 0; t < count; ++t)
  {
    if (this->Marks[t] != 0 || shellOf[t] >= 0 || !this->IsAbove(static_cast<Id>(t)))
    {
      continue;
    }
    const Id shell = static_cast<Id>(highest.size());
    highest.push_back(this->Surface.triangles[t][0]);
    std::vector<Id> work{ static_cast<Id>(t) };
    shellOf[t] = shell;
    while (!work.empty())
    {
      const Id at = work.back();
      work.pop_back();
      for (const Id p : this->Surface.triangles[Index(at)])
      {
        Id& top = highest[Index(shell)];
        top = this->Heights[Index(p)] > this->Heights[Index(top)] ? p : top;
        for (const Id next : Row(this->Star, p))
        {
          if (shellOf[Index(next)] < 0 && this->Marks[Index(next)] == 0)
          {
            shellOf[Index(next)] = shell;
            work.push_back(next);
          }
        }
      }
    }
  }
  if (highest.empty())
  {
    return;
  }
  const TriangleTree tree(this->Surface.points, this->Surface.triangles);
  // The triangle that each shell sees, if there is material in between.
  std::vector<Id> seen(highest.size(), -1);
  for (std::size_t s = 0; s < highest.size(); ++s)
  {
    const auto hit = tree.FirstHit(this->Surface.points[Index(highest[s])], this->Up, 0,
                                   std::numeric_limits<double>::infinity(),
                                   [&](Id t) { return shellOf[Index(t)] != static_cast<Id>(s); });
    if (hit.triangle >= 0)
    {
      const Vec3 normal = AreaVector2(this->Surface.points, this->Surface.triangles[Index(hit.triangle)]);
      const MaterialPair& pair = this->Surface.materials[Index(hit.triangle)];
      seen[s] = (Dot(normal, this->Up) > 0 ? pair.first : pair.second) != 0 ? hit.triangle : -1;
    }
  }
  for (bool again = true; again;)
  {
    again = false;
    for (std::size_t t = 0; t < count; ++t)
    {
      const Id shell = this->Marks[t] == 0 ? shellOf[t] : -1;
      if (shell >= 0 && seen[Index(shell)] >= 0 && this->Marks[Index(seen[Index(shell)])] != 0)
      {
        this->Marks[t] = 1;
        again = true;
      }
    }
  }
}

/// Drop points that no triangle has.
void DropUnusedPoints(TriangleComplex& surface)
{
  std::vector<Id> numberOf(surface.points.size(), -1);
  for (const Triangle& triangle : surface.triangles)
  {
    for (const Id p : triangle)
    {
      numberOf[Index(p)] = 0;
    }
  }
  Id count = 0;
  for (std::size_t p = 0; p < numberOf.size(); ++p)
  {
    if (numberOf[p] == 0)
    {
      surface.points[Index(count)] = surface.points[p];
      numberOf[p] = count++;
    }
  }
  surface.points.resize(Index(count));
  for (Triangle& triangle : surface.triangles)
  {
    for (Id& p : triangle)
    {
      p = numberOf[Index(p)];
    }
  }
}

/// "<kind>_<own>", or with the first number that makes it free.
std::string FreeName(const std::vector<std::string>& names, const std::string& kind, const std::string& own)
{
  const auto isFree = [&](const std::string& name)
  { return std::find(names.begin(), names.end(), name) == names.end(); };
  const std::string stem = kind + (own.empty() ? "" : "_" + own);
  if (!own.empty() && isFree(stem))
  {
    return stem;
  }
  int number = own.empty() ? 1 : 2;
  while (!isFree(stem + "_" + std::to_string(number)))
  {
    ++number;
  }
  return stem + "_" + std::to_string(number);
}

void NameEnds(CutSurface& cut, const CutVesselOptions& options, CutVesselReport& report)
{
  TriangleComplex& surface = cut.surface;
  if (surface.patchNames.empty())
  {
    surface.patchNames = { "wall" };
  }
  const auto add = [&](const char* kind)
  {
    surface.patchNames.push_back(FreeName(surface.patchNames, kind, options.name));
    report.patches.push_back(surface.patchNames.back());
    return static_cast<int>(surface.patchNames.size()) - 1;
  };
  int border = 0;
  for (const PlaneEnd& end : cut.ends)
  {
    const bool isOpen = std::find(options.openMaterials.begin(), options.openMaterials.end(), end.material) !=
                        options.openMaterials.end();
    border = isOpen || border != 0 ? border : add("border");
    const int patch = isOpen ? add("opening") : border;
    std::fill_n(surface.patches.begin() + static_cast<std::ptrdiff_t>(end.firstTriangle), end.triangles,
                patch);
    report.endTriangles += end.triangles;
  }
}

Result<CutVesselReport> Check(const TriangleComplex& surface, const CutVesselOptions& options,
                              Monitor& monitor)
{
  if (!IsFinite(options.origin) || !IsFinite(options.normal) || !(Norm(options.normal) > 0))
  {
    return InvalidOption("the plane needs a finite origin and a normal that is not zero");
  }
  const bool isPlain =
    std::all_of(options.name.begin(), options.name.end(),
                [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
  if (!isPlain)
  {
    return InvalidOption("the name '" + options.name + "' may have letters, digits, _ and - only");
  }
  if (const auto error = CheckClosed(surface, false, monitor))
  {
    return *error;
  }
  return CutVesselReport{};
}

/// The piece of the section that is meant; a failure if the plane misses.
Result<int> ChoosePiece(const PlaneSection& section, const PlaneFrame& frame, const Vec3& origin)
{
  if (section.IsEmpty())
  {
    return InvalidOption("the plane through " + ToString(origin) + " with normal " + ToString(frame.normal) +
                         " misses the surface: move it so that it cuts the vessel");
  }
  const PlaneSection::Nearest nearest = section.Find(frame.ToPlane(origin));
  const double reach = 0.5 * std::sqrt(section.AreaOfPiece(nearest.piece));
  if (nearest.distance > reach)
  {
    return InvalidOption(
      Text("the plane misses the vessel: its origin ", ToString(origin), " lies ", nearest.distance,
           " beside the nearest material in the plane: place the origin inside the vessel"));
  }
  return nearest.piece;
}

} // namespace

Result<CutVesselReport> CutVessel(TriangleComplex& surface, const CutVesselOptions& options, Monitor& monitor)
{
  monitor.Progress(0, "Finding what the plane cuts");
  Result<CutVesselReport> checked = Check(surface, options, monitor);
  if (!checked)
  {
    return checked;
  }
  CutVesselReport report = *checked;
  PlaneFrame frame(options.origin, options.normal);
  const std::vector<double> heights = Heights(surface, frame);
  const PlaneSection section(surface, frame, heights);
  const Result<int> piece = ChoosePiece(section, frame, options.origin);
  if (!piece)
  {
    return piece.GetError();
  }
  CutRegion finder(surface, section, heights, frame.normal);
  const std::vector<char> region = finder.Run(*piece);
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  for (const int cut : finder.Pieces())
  {
    report.area += section.AreaOfPiece(cut);
  }
  report.sections = static_cast<Id>(finder.Pieces().size());
  monitor.Progress(0.3, "Cutting");
  Error failure =
    Unreachable("the plane ends could not be closed: shift or turn the plane a little", { options.origin });
  for (const double snap : Snaps)
  {
    auto cut = CutAlongPlane(surface, frame, heights, region, snap);
    if (!cut)
    {
      continue;
    }
    DropUnusedPoints(cut->surface);
    SubMonitor testing(monitor, 0.5, 0.9);
    auto error = CheckEmbedded(cut->surface.points, cut->surface.triangles, "the cut surface", testing);
    error = error ? error : CheckClosed(cut->surface, false, testing);
    if (error)
    {
      failure = *error;
      if (error->kind == Failure::Cancelled)
      {
        break;
      }
      continue;
    }
    NameEnds(*cut, options, report);
    ClassifyJunctions(cut->surface);
    report.cutTriangles = static_cast<Id>(surface.triangles.size()) -
                          (static_cast<Id>(cut->surface.triangles.size()) - report.endTriangles);
    report.cutShare = 1 - VolumeOf(cut->surface) / VolumeOf(surface);
    surface = std::move(cut->surface);
    monitor.Progress(1, "Vessel cut");
    return report;
  }
  return failure;
}

} // namespace lamina
