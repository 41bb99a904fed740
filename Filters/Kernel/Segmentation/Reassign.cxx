// SPDX-License-Identifier: BSD-3-Clause
#include "Reassign.h"

#include "../Base/Text.h"
#include "../Mesh/WellComposed.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace lamina
{

namespace
{

/// Of the least voxel edge: a box that ends on voxel centres shall hold them whatever the rounding.
constexpr double Slack = 1e-6;

std::array<Id, 3> VoxelAt(const GridGeometry& grid, Id index)
{
  return { { index % grid.size[0], index / grid.size[0] % grid.size[1],
             index / (grid.size[0] * grid.size[1]) } };
}

Vec3 CentreOf(const GridGeometry& grid, Id index)
{
  const auto v = VoxelAt(grid, index);
  return grid.ToWorld(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
}

/// Gives the edits' materials to voxels and counts them. A loop's pieces write voxels of their own.
class Work
{
public:
  Work(const GridGeometry& grid, std::vector<int>& labels, std::vector<unsigned char>& decisions)
    : Grid(grid)
    , Labels(labels)
    , Decisions(decisions)
    , Tolerance(Slack * std::min({ grid.spacing.x, grid.spacing.y, grid.spacing.z }))
  {
  }
  EditReport Apply(const VoxelEdit& edit, Monitor& monitor) const;

private:
  struct Counts
  {
    Id covered = 0;
    Id decided = 0;
    Id changed = 0;
  };

  void Give(const VoxelEdit& edit, Id index, Counts& counts) const;
  std::pair<std::array<Id, 3>, std::array<Id, 3>> Range(const VoxelEdit& edit) const;
  bool Holds(const VoxelEdit& edit, const Vec3& place) const;
  template<typename Piece>
  Counts Sum(Id count, Id grain, Monitor& monitor, const Piece& piece) const;

  const GridGeometry& Grid;
  std::vector<int>& Labels;
  std::vector<unsigned char>& Decisions;
  double Tolerance;
};

void Work::Give(const VoxelEdit& edit, Id index, Counts& counts) const
{
  int& label = this->Labels[static_cast<std::size_t>(index)];
  ++counts.covered;
  if (!edit.from.empty() && std::find(edit.from.begin(), edit.from.end(), label) == edit.from.end())
  {
    return;
  }
  ++counts.decided;
  counts.changed += label != edit.to ? 1 : 0;
  label = edit.to;
  this->Decisions[static_cast<std::size_t>(index)] = Decided;
}

bool Work::Holds(const VoxelEdit& edit, const Vec3& place) const
{
  if (edit.shape == EditShape::Sphere)
  {
    return Norm(place - edit.centre) <= edit.radius + this->Tolerance;
  }
  for (int a = 0; a < 3; ++a)
  {
    if (place[a] < edit.low[a] - this->Tolerance || place[a] > edit.high[a] + this->Tolerance)
    {
      return false;
    }
  }
  return true;
}

/// First and last voxel, along i, j and k, of a block that has all voxels of the shape in it; last < first if
/// there are none.
std::pair<std::array<Id, 3>, std::array<Id, 3>> Work::Range(const VoxelEdit& edit) const
{
  const Vec3 reach{ edit.radius, edit.radius, edit.radius };
  const bool ball = edit.shape == EditShape::Sphere;
  const Vec3 corners[2] = { ball ? edit.centre - reach : edit.low, ball ? edit.centre + reach : edit.high };
  Vec3 least{ 1, 1, 1 };
  least *= std::numeric_limits<double>::infinity();
  Vec3 most = least * -1.0;
  for (int q = 0; q < 8; ++q)
  {
    const Vec3 corner{ corners[q & 1].x, corners[(q >> 1) & 1].y, corners[q >> 2].z };
    const Vec3 from = corner - this->Grid.origin;
    for (int a = 0; a < 3; ++a)
    {
      const auto& d = this->Grid.direction;
      const std::size_t column = static_cast<std::size_t>(a);
      const double index =
        (d[column] * from.x + d[3 + column] * from.y + d[6 + column] * from.z) / this->Grid.spacing[a];
      least[a] = std::min(least[a], index);
      most[a] = std::max(most[a], index);
    }
  }
  std::pair<std::array<Id, 3>, std::array<Id, 3>> range;
  for (int a = 0; a < 3; ++a)
  {
    const std::size_t axis = static_cast<std::size_t>(a);
    const double end = static_cast<double>(this->Grid.size[axis] - 1);
    // Directions are orthonormal to four digits only: a thousandth of the image wider than asked.
    const double slack = 1 + 1e-3 * end;
    range.first[axis] = static_cast<Id>(std::ceil(std::min(std::max(least[a] - slack, 0.0), end + 1)));
    range.second[axis] = static_cast<Id>(std::floor(std::max(std::min(most[a] + slack, end), -1.0)));
  }
  return range;
}

template<typename Piece>
Work::Counts Work::Sum(Id count, Id grain, Monitor& monitor, const Piece& piece) const
{
  // Sums of whole numbers do not depend on their order.
  std::atomic<Id> covered{ 0 };
  std::atomic<Id> decided{ 0 };
  std::atomic<Id> changed{ 0 };
  monitor.For(count, grain,
              [&](Id begin, Id end)
              {
                Counts counts;
                for (Id n = begin; n < end; ++n)
                {
                  piece(n, counts);
                }
                covered += counts.covered;
                decided += counts.decided;
                changed += counts.changed;
              });
  return { covered, decided, changed };
}

EditReport Work::Apply(const VoxelEdit& edit, Monitor& monitor) const
{
  Counts counts;
  if (edit.shape == EditShape::Voxels)
  {
    std::vector<Id> voxels = edit.voxels;
    std::sort(voxels.begin(), voxels.end());
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    counts =
      this->Sum(static_cast<Id>(voxels.size()), 4096, monitor,
                [&](Id n, Counts& sum) { this->Give(edit, voxels[static_cast<std::size_t>(n)], sum); });
  }
  else
  {
    const auto range = this->Range(edit);
    const Id slices = std::max<Id>(range.second[2] - range.first[2] + 1, 0);
    counts =
      this->Sum(slices, 1, monitor,
                [&](Id n, Counts& sum)
                {
                  const Id k = range.first[2] + n;
                  for (Id j = range.first[1]; j <= range.second[1]; ++j)
                  {
                    for (Id i = range.first[0]; i <= range.second[0]; ++i)
                    {
                      if (this->Holds(edit, this->Grid.ToWorld(static_cast<double>(i), static_cast<double>(j),
                                                               static_cast<double>(k))))
                      {
                        this->Give(edit, this->Grid.Index(i, j, k), sum);
                      }
                    }
                  }
                });
  }
  return { edit.name, edit.shape, edit.to, counts.covered, counts.decided, counts.changed };
}

/// A warning for an edit that changes nothing: why.
void NoteIdleEdit(const EditReport& edit, std::vector<std::string>& warnings)
{
  if (edit.changed > 0)
  {
    return;
  }
  const std::string what = Text(edit.name, " (", ShapeName(edit.shape), ", to material ", edit.to, ")");
  if (edit.covered == 0)
  {
    warnings.push_back(what + (edit.shape == EditShape::Voxels
                                 ? " has no voxels"
                                 : " covers no voxel centre: it lies outside the image or is too small"));
    return;
  }
  warnings.push_back(what + (edit.decided == 0 ? Text(" changes nothing: none of its ", edit.covered,
                                                      " voxels has a material it is restricted to")
                                               : Text(" changes nothing: its ", edit.decided,
                                                      " voxels have this material already")));
}

/// Repair around the decided voxels; only where that does not do, with them.
void Repair(LabelImage& image, const std::vector<unsigned char>& decisions, const ReassignOptions& options,
            ReassignReport& report, Monitor& monitor)
{
  RepairOptions repair;
  repair.forbidden = options.forbidden;
  repair.openAtImageBorder = options.openAtImageBorder;
  repair.frozen = &decisions;
  SubMonitor first(monitor, 0.0, 0.7);
  const RepairReport around = RepairTopology(image, repair, first);
  report.criticalEdges = around.criticalEdges;
  report.criticalCorners = around.criticalCorners;
  report.forbiddenContacts = around.forbiddenContacts;
  report.remaining = around.remaining;
  if (around.remaining > 0 && !monitor.Cancelled())
  {
    repair.frozen = nullptr;
    SubMonitor second(monitor, 0.7, 1.0);
    report.remaining = RepairTopology(image, repair, second).remaining;
  }
}

void CompareWithEdits(const std::vector<int>& edited, const LabelImage& image,
                      std::vector<unsigned char>& decisions, ReassignReport& report)
{
  for (std::size_t v = 0; v < edited.size(); ++v)
  {
    if (image.labels[v] == edited[v])
    {
      continue;
    }
    report.repaired.push_back(static_cast<Id>(v));
    if (decisions[v] == Decided)
    {
      decisions[v] = Overridden;
      ++report.overridden;
      report.overriddenAt.push_back(CentreOf(image.grid, static_cast<Id>(v)));
    }
  }
  if (report.overridden > 0)
  {
    report.warnings.push_back(Text("the repair of the topology changed ", report.overridden,
                                   " voxels that the edits had decided", DescribePlaces(report.overriddenAt),
                                   ": edit their surroundings too, or switch the repair off"));
  }
  if (report.remaining > 0)
  {
    report.warnings.push_back(
      Text("the repair of the topology left ", report.remaining, " faults: relax the forbidden contacts"));
  }
}

} // namespace

const char* ShapeName(EditShape shape)
{
  return shape == EditShape::Box ? "box" : (shape == EditShape::Sphere ? "sphere" : "voxels");
}

Result<ReassignReport> Reassign(LabelImage& image, std::vector<unsigned char>& decisions,
                                const ReassignOptions& options, Monitor& monitor)
{
  if (static_cast<Id>(image.labels.size()) != image.grid.Count())
  {
    return InvalidInput(
      Text("the image has ", image.labels.size(), " labels for ", image.grid.Count(), " voxels"));
  }
  if (const Result<bool> good = CheckEdits(image.grid, options); !good)
  {
    return good.GetError();
  }
  ReassignReport report;
  LabelImage result = image;
  std::vector<unsigned char> made(image.labels.size(), Untouched);
  const Work work(result.grid, result.labels, made);
  const double share = (options.repairTopology ? 0.5 : 1.0) / static_cast<double>(options.edits.size() + 1);
  for (std::size_t e = 0; e < options.edits.size() && !monitor.Cancelled(); ++e)
  {
    monitor.Progress(share * static_cast<double>(e), "applying edits");
    report.edits.push_back(work.Apply(options.edits[e], monitor));
    NoteIdleEdit(report.edits.back(), report.warnings);
  }
  if (options.repairTopology && !options.edits.empty() && !monitor.Cancelled())
  {
    const std::vector<int> edited = result.labels;
    SubMonitor part(monitor, 0.5, 1.0);
    part.Progress(0, "repairing the topology");
    report.mended = true;
    Repair(result, made, options, report, part);
    CompareWithEdits(edited, result, made, report);
  }
  if (monitor.Cancelled())
  {
    return Cancelled();
  }
  image = std::move(result);
  decisions = std::move(made);
  return report;
}

} // namespace lamina
