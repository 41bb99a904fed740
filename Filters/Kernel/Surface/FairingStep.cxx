// SPDX-License-Identifier: BSD-3-Clause
#include "FairingStep.h"

#include "SheetFairing.h"

#include <algorithm>

namespace lamina
{

namespace
{

/// Over how much of a wavelength the moves add up to no volume.
constexpr double balancedOver = 0.5;

/// Where the surface curves more sharply than this share of a wave does, the curve is the shape, not the
/// waves on it.
constexpr double greatestTurn = 3.141592653589793; ///< radians over a wavelength

/// Unit normals averaged over the neighbours' neighbours: what is left of the staircase hardly turns them.
std::vector<Vec3> BroadNormals(const SmoothingState& state, std::vector<Vec3> normals)
{
  for (int pass = 0; pass < 2; ++pass)
  {
    const std::vector<Vec3> before = normals;
    for (std::size_t p = 0; p < before.size(); ++p)
    {
      for (Id q : Row(state.ring, static_cast<Id>(p)))
      {
        normals[p] += before[static_cast<std::size_t>(q)];
      }
    }
  }
  for (Vec3& n : normals)
  {
    n = Normalized(n);
  }
  return normals;
}

/// The points on their way along their normals.
class Step
{
public:
  Step(SmoothingState& state, const MoveGuard& guard, double wavelength)
    : State(state)
    , Guard(guard)
    , Start(state.surface.points)
    , Normals(state.surface.points.size())
    , Free(state.surface.points.size(), 0)
  {
    const TriangleComplex& surface = state.surface;
    for (std::size_t p = 0; p < this->Free.size(); ++p)
    {
      this->Free[p] = surface.junctionKind[p] == JunctionSheet && state.freedom[p].dimensions == 3 ? 1 : 0;
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const Vec3 area = AreaVector2(surface.points, surface.triangles[t]);
      for (Id p : surface.triangles[t])
      {
        this->Normals[static_cast<std::size_t>(p)] += area;
        char& free = this->Free[static_cast<std::size_t>(p)];
        free = guard.IsSharp(static_cast<Id>(t)) ? 0 : free;
      }
    }
    this->HoldThinThings(wavelength);
    for (Vec3& n : this->Normals)
    {
      n = Normalized(n);
    }
  }

  void Level(double wavelength, Monitor& monitor);
  void KeepTriangles(Monitor& monitor);
  /// One flag a point that this step must not move.
  std::vector<char> Held() const
  {
    std::vector<char> held = this->Free;
    for (char& h : held)
    {
      h = h ? 0 : 1;
    }
    return held;
  }

private:
  void HoldThinThings(double wavelength);
  Vec3 PlaceOf(std::size_t p) const { return this->Start[p] + this->Offsets[p] * this->Normals[p]; }
  /// Shorten the offsets that leave their bounds.
  void Shorten();

  SmoothingState& State;
  const MoveGuard& Guard;
  const std::vector<Vec3> Start;
  std::vector<Vec3> Normals;
  std::vector<char> Free;
  std::vector<double> Offsets;
};

/// Strands, tips, rims and edges, whose radius is less than about a third of the wavelength, would be
/// levelled with the waves: their points stay.
void Step::HoldThinThings(double wavelength)
{
  const auto& points = this->State.surface.points;
  const std::vector<Vec3> normals = BroadNormals(this->State, this->Normals);
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (Id neighbour : Row(this->State.ring, static_cast<Id>(p)))
    {
      const auto q = static_cast<std::size_t>(neighbour);
      if (Norm(normals[p] - normals[q]) * wavelength > greatestTurn * Norm(points[p] - points[q]))
      {
        this->Free[p] = 0;
      }
    }
  }
}

void Step::Shorten()
{
  for (std::size_t p = 0; p < this->Offsets.size(); ++p)
  {
    double& d = this->Offsets[p];
    for (int times = 0; d != 0 && !this->Guard.StaysNear(static_cast<Id>(p), this->PlaceOf(p)); ++times)
    {
      d = times < 6 ? 0.75 * d : 0;
    }
  }
}

void Step::Level(double wavelength, Monitor& monitor)
{
  const SheetFairing fairing(this->State, monitor);
  this->Offsets = fairing.Offsets(this->Normals, this->Free, wavelength);
  this->Shorten();
  // What is held back, and what does not move at all, leaves a surplus beside it. Without it the moves add up
  // to no volume anywhere: a wall gives nothing to the strand that ends in it.
  std::vector<double> volumes(this->Offsets.size());
  for (std::size_t p = 0; p < volumes.size(); ++p)
  {
    volumes[p] = this->Offsets[p] * fairing.AreaOf(static_cast<Id>(p));
  }
  const std::vector<double> surplus = fairing.Spread(volumes, this->Free, balancedOver * wavelength);
  for (std::size_t p = 0; p < this->Offsets.size(); ++p)
  {
    this->Offsets[p] -= surplus[p];
  }
  this->Shorten();
  for (std::size_t p = 0; p < this->Offsets.size(); ++p)
  {
    this->State.surface.points[p] = this->PlaceOf(p);
  }
}

/// Points of triangles that turned or thinned too far go half as far, twice, then nowhere: at the start all
/// triangles were good.
void Step::KeepTriangles(Monitor& monitor)
{
  std::vector<char> times(this->Offsets.size(), 0);
  std::vector<char> bad(this->State.surface.triangles.size());
  for (bool again = true; again && !monitor.Cancelled();)
  {
    again = false;
    monitor.For(static_cast<Id>(bad.size()), 4096,
                [&](Id begin, Id end)
                {
                  for (Id t = begin; t < end; ++t)
                  {
                    bad[static_cast<std::size_t>(t)] = this->Guard.KeepsTriangle(t) ? 0 : 1;
                  }
                });
    std::vector<Id> points;
    for (std::size_t t = 0; t < bad.size(); ++t)
    {
      if (bad[t])
      {
        points.insert(points.end(), this->State.surface.triangles[t].begin(),
                      this->State.surface.triangles[t].end());
      }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (Id point : points)
    {
      const auto p = static_cast<std::size_t>(point);
      if (this->Offsets[p] != 0)
      {
        this->Offsets[p] = ++times[p] < 3 ? this->Offsets[p] / 2 : 0;
        this->State.surface.points[p] = this->PlaceOf(p);
        again = true;
      }
    }
  }
}

} // namespace

std::vector<char> LevelWaves(SmoothingState& state, const MoveGuard& guard, double wavelength,
                             Monitor& monitor)
{
  Step step(state, guard, wavelength);
  step.Level(wavelength, monitor);
  step.KeepTriangles(monitor);
  return step.Held();
}

void MoveSafely(SmoothingState& state, const MoveGuard& guard, std::vector<Vec3> moves,
                std::vector<char>& held, Monitor& monitor)
{
  std::vector<Vec3>& points = state.surface.points;
  const std::vector<Vec3> before = points;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    points[p] += moves[p];
  }
  std::vector<char> times(points.size(), 0);
  // Cancelling leaves loops unfinished, and an unfinished test proves nothing: then all is put back.
  for (std::vector<Id> bad = guard.Offending(before, monitor); !bad.empty() && !monitor.Cancelled();
       bad = guard.Offending(before, monitor))
  {
    for (const Id offender : bad)
    {
      const auto p = static_cast<std::size_t>(offender);
      held[p] = 1;
      moves[p] = ++times[p] < 3 ? 0.5 * moves[p] : Vec3{};
      points[p] = before[p] + moves[p];
    }
  }
  if (monitor.Cancelled())
  {
    points = before;
  }
}

void SpreadVolumes(SmoothingState& state, const MoveGuard& guard, const std::function<double(Id)>& volumeOf,
                   double distance, Monitor& monitor)
{
  const TriangleComplex& surface = state.surface;
  std::vector<Vec3> normals(surface.points.size());
  std::vector<char> free(surface.points.size(), 0);
  for (std::size_t p = 0; p < free.size(); ++p)
  {
    free[p] = surface.junctionKind[p] == JunctionSheet && state.freedom[p].dimensions == 3 ? 1 : 0;
  }
  std::vector<double> sources(surface.points.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Triangle& triangle = surface.triangles[t];
    const Vec3 area = AreaVector2(surface.points, triangle);
    double corners = 0;
    for (const Id p : triangle)
    {
      normals[static_cast<std::size_t>(p)] += area;
      corners += free[static_cast<std::size_t>(p)];
    }
    if (corners == 0)
    {
      continue;
    }
    const double volume = volumeOf(static_cast<Id>(t)) / corners;
    for (const Id p : triangle)
    {
      sources[static_cast<std::size_t>(p)] += free[static_cast<std::size_t>(p)] != 0 ? volume : 0;
    }
  }
  const std::vector<double> offsets = SheetFairing(state, monitor).Spread(sources, free, distance);
  std::vector<Vec3> moves(offsets.size());
  for (std::size_t p = 0; p < moves.size(); ++p)
  {
    moves[p] = offsets[p] * Normalized(normals[p]);
  }
  std::vector<char> held(moves.size(), 0);
  MoveSafely(state, guard, std::move(moves), held, monitor);
}

} // namespace lamina
