// SPDX-License-Identifier: BSD-3-Clause
#include "AuditCells.h"

#include "../Geometry/Predicates.h"
#include "../Geometry/Quality.h"
#include "Findings.h"

#include <algorithm>
#include <limits>
#include <map>

namespace lamina
{
namespace
{

constexpr Id Grain = 8192;
constexpr Id AskEvery = 1 << 16; ///< cells, whether to stop

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

struct CellMeasure
{
  bool isValid = false;
  double quality = 0;
  double volume = 0;
};

CellMeasure Measure(const VolumeMesh& mesh, Id cell)
{
  switch (mesh.types[Index(cell)])
  {
    case CellType::Wedge:
    {
      const auto n = PlacesOf<6>(mesh, cell);
      return { WedgeIsValid(n), WedgeQuality(n), WedgeVolume(n) };
    }
    case CellType::Pyramid:
    {
      const auto n = PlacesOf<5>(mesh, cell);
      return { PyramidIsValid(n), PyramidQuality(n), PyramidVolume(n) };
    }
    default:
    {
      const auto n = PlacesOf<4>(mesh, cell);
      return { Orientation(n[0], n[1], n[2], n[3]) > 0, TetQuality(n[0], n[1], n[2], n[3]),
               TetVolume(n[0], n[1], n[2], n[3]) };
    }
  }
}

QualityAudit Summarize(CellType type, std::vector<double>& values)
{
  QualityAudit audit;
  audit.type = type;
  audit.count = static_cast<Id>(values.size());
  for (double q : values)
  {
    const double step = std::clamp(20 * q, 0.0, 19.0);
    ++audit.histogram[static_cast<std::size_t>(step)];
  }
  const std::array<double, 5> shares{ { 0.01, 0.05, 0.25, 0.5, 0.95 } };
  for (std::size_t k = 0; k < shares.size(); ++k)
  {
    const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(shares[k] * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    audit.percentiles[k] = *place;
  }
  audit.least = *std::min_element(values.begin(), values.end());
  return audit;
}

Vec3 MiddleOf(const VolumeMesh& mesh, Id cell)
{
  const int n = NodeCount(mesh.types[Index(cell)]);
  Vec3 sum;
  for (int k = 0; k < n; ++k)
  {
    sum += mesh.points[Index(mesh.Cell(cell)[k])];
  }
  return sum * (1.0 / n);
}

/// The ten cells of the least quality of each type; equal ones in the order of their ids.
std::vector<WorstCell> FindWorst(const VolumeMesh& mesh, const std::vector<double>& quality, Monitor& monitor)
{
  constexpr std::size_t most = 10;
  std::map<CellType, std::vector<std::pair<double, Id>>> worst;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    if (c % AskEvery == 0 && monitor.Cancelled())
    {
      break;
    }
    auto& heap = worst[mesh.types[Index(c)]]; // its largest first
    const std::pair<double, Id> entry(quality[Index(c)], c);
    if (heap.size() < most || entry < heap.front())
    {
      heap.push_back(entry);
      std::push_heap(heap.begin(), heap.end());
      if (heap.size() > most)
      {
        std::pop_heap(heap.begin(), heap.end());
        heap.pop_back();
      }
    }
  }
  std::vector<WorstCell> cells;
  for (auto& [type, heap] : worst)
  {
    std::sort_heap(heap.begin(), heap.end());
    for (const auto& [q, c] : heap)
    {
      cells.push_back({ c, type, mesh.materials[Index(c)], q, MiddleOf(mesh, c) });
    }
  }
  return cells;
}

/// What is gathered of one material before it becomes its MaterialAudit.
struct Gathered
{
  MaterialAudit audit;
  long double volume = 0;
  std::vector<double> tets;
  std::vector<double> wedges;
  std::vector<double> pyramids;
};

MaterialAudit Close(Gathered& g, double gate, Monitor& monitor)
{
  MaterialAudit& a = g.audit;
  a.meshVolume = static_cast<double>(g.volume);
  a.surfaceVolume = std::numeric_limits<double>::quiet_NaN();
  const auto above = std::count_if(g.tets.begin(), g.tets.end(), [&](double q) { return q > gate; });
  a.tetAboveGate = g.tets.empty() ? 1 : static_cast<double>(above) / static_cast<double>(g.tets.size());
  const std::pair<CellType, std::vector<double>*> all[] = { { CellType::Tetrahedron, &g.tets },
                                                            { CellType::Wedge, &g.wedges },
                                                            { CellType::Pyramid, &g.pyramids } };
  for (const auto& [type, values] : all)
  {
    if (!values->empty() && !monitor.Cancelled())
    {
      a.qualities.push_back(Summarize(type, *values));
    }
  }
  const auto take = [&](CellType type, double& least, double& first, double& median)
  {
    const auto found = std::find_if(a.qualities.begin(), a.qualities.end(),
                                    [&](const QualityAudit& q) { return q.type == type; });
    const bool isThere = found != a.qualities.end();
    least = isThere ? found->least : 1;
    first = isThere ? found->percentiles[0] : 1;
    median = isThere ? found->percentiles[3] : 1;
  };
  take(CellType::Tetrahedron, a.tetQualityMin, a.tetQualityP1, a.tetQualityP50);
  take(CellType::Wedge, a.wedgeQualityMin, a.wedgeQualityP1, a.wedgeQualityP50);
  return a;
}

} // namespace

void AuditCells(const VolumeMesh& mesh, const AuditOptions& options, AuditReport& report, AuditMarks& marks,
                Monitor& monitor)
{
  std::vector<double> volumes(mesh.types.size());
  monitor.For(mesh.CellCount(), Grain,
              [&](Id begin, Id end)
              {
                for (Id c = begin; c < end; ++c)
                {
                  const CellMeasure measure = Measure(mesh, c);
                  const bool isBadTet =
                    mesh.types[Index(c)] == CellType::Tetrahedron && !(measure.quality > options.qualityGate);
                  marks.quality[Index(c)] = measure.quality;
                  marks.flags[Index(c)] = static_cast<unsigned char>((measure.isValid ? 0 : FlagInverted) |
                                                                     (isBadTet ? FlagBadQuality : 0));
                  volumes[Index(c)] = measure.volume;
                }
              });
  std::map<int, Gathered> gathered;
  Places inverted;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    if (c % AskEvery == 0 && monitor.Cancelled())
    {
      return;
    }
    Gathered& g = gathered[mesh.materials[Index(c)]];
    const CellType type = mesh.types[Index(c)];
    g.volume += volumes[Index(c)];
    g.audit.material = mesh.materials[Index(c)];
    g.audit.tets += type == CellType::Tetrahedron;
    g.audit.wedges += type == CellType::Wedge;
    g.audit.pyramids += type == CellType::Pyramid;
    if (type == CellType::Tetrahedron)
    {
      g.tets.push_back(marks.quality[Index(c)]);
    }
    else if (type == CellType::Wedge)
    {
      g.wedges.push_back(marks.quality[Index(c)]);
    }
    else
    {
      g.pyramids.push_back(marks.quality[Index(c)]);
    }
    ++g.audit.cellsOfLayer[mesh.layers.empty() ? 0 : mesh.layers[Index(c)]];
    if ((marks.flags[Index(c)] & FlagInverted) != 0)
    {
      inverted.Add(mesh.points[Index(mesh.Cell(c)[0])]);
    }
  }
  for (auto& entry : gathered)
  {
    report.materials.push_back(Close(entry.second, options.qualityGate, monitor));
  }
  report.worst = FindWorst(mesh, marks.quality, monitor);
  report.invertedCells = inverted.GetCount();
  inverted.Tell("cells are inverted or without volume somewhere", report.findings);
}

} // namespace lamina
