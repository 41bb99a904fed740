// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenRun.h"

#ifdef LAMINA_WITH_TETGEN

#include <tetgen.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <mutex>
#include <new>

namespace lamina
{
namespace
{

/// TetGen frees these arrays with delete[].
double* Flat(const std::vector<Vec3>& points)
{
  double* flat = new double[std::max<std::size_t>(1, 3 * points.size())];
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      flat[3 * i + static_cast<std::size_t>(k)] = points[i][k];
    }
  }
  return flat;
}

void FillFacets(const std::vector<Triangle>& triangles, tetgenio& in)
{
  in.numberoffacets = static_cast<int>(triangles.size());
  in.facetlist = new tetgenio::facet[triangles.size()];
  // Each its own marker: TetGen may join flat neighbours of one marker and flip the edge between them.
  in.facetmarkerlist = new int[triangles.size()];
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    tetgenio::facet& facet = in.facetlist[i];
    tetgenio::init(&facet);
    facet.polygonlist = new tetgenio::polygon[1];
    facet.numberofpolygons = 1;
    facet.polygonlist->vertexlist = new int[3];
    facet.polygonlist->numberofvertices = 3;
    for (std::size_t k = 0; k < 3; ++k)
    {
      facet.polygonlist->vertexlist[k] = static_cast<int>(triangles[i][k]);
    }
    in.facetmarkerlist[i] = static_cast<int>(i) + 1;
  }
}

/// Interior points are isolated points of the input and so part of the first, spatially sorted Delaunay
/// tetrahedralization. (TetGen's -i would insert them after the cavities are carved, where its walk to a
/// point often ends at a wall and falls back to a search through all tets: measured, two thirds of the whole
/// time.)
void Fill(const TetGenTask& task, tetgenio& in)
{
  std::vector<Vec3> points = task.points;
  points.insert(points.end(), task.inserted.begin(), task.inserted.end());
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(points.size());
  in.pointlist = Flat(points);
  if (!task.sizes.empty())
  {
    in.numberofpointmtrs = 1;
    in.pointmtrlist = new double[points.size()];
    std::copy(task.sizes.begin(), task.sizes.end(), in.pointmtrlist);
    std::fill(in.pointmtrlist + task.sizes.size(), in.pointmtrlist + points.size(),
              *std::max_element(task.sizes.begin(), task.sizes.end()));
  }
  FillFacets(task.facets, in);
  in.numberofholes = static_cast<int>(task.holes.size());
  in.holelist = task.holes.empty() ? nullptr : Flat(task.holes);
}

const char* Meaning(int code)
{
  switch (code)
  {
    case 1:
      return "out of memory";
    case 3:
      return "the surface intersects itself";
    case 4:
      return "points lie too close together";
    case 5:
      return "two facets lie too close together";
    case 10:
      return "the input is not valid";
    default:
      return "an internal error of TetGen";
  }
}

/// The groups of whole numbers in brackets or parentheses, as TetGen prints the corners of what it complains
/// about.
std::vector<std::vector<Id>> NumberGroups(const std::string& text)
{
  std::vector<std::vector<Id>> groups;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] != '[' && text[i] != '(')
    {
      continue;
    }
    std::vector<Id> group;
    for (++i; i < text.size() &&
              (std::isdigit(static_cast<unsigned char>(text[i])) || text[i] == ',' || text[i] == ' ');)
    {
      std::size_t digits = 0;
      while (i + digits < text.size() && std::isdigit(static_cast<unsigned char>(text[i + digits])))
      {
        ++digits;
      }
      if (digits > 0 && digits < 12)
      {
        group.push_back(std::stoll(text.substr(i, digits)));
      }
      i += std::max<std::size_t>(1, digits);
    }
    groups.push_back(group);
  }
  return groups;
}

/// The facets whose corners or edges the complaint names.
std::vector<Id> NamedFacets(const std::string& complaint, const std::vector<Triangle>& facets)
{
  std::vector<Id> named;
  for (const auto& group : NumberGroups(complaint))
  {
    for (std::size_t f = 0; f < facets.size() && (group.size() == 2 || group.size() == 3); ++f)
    {
      const bool hasAll = std::all_of(
        group.begin(), group.end(),
        [&](Id p) { return std::find(facets[f].begin(), facets[f].end(), p) != facets[f].end(); });
      if (hasAll)
      {
        named.push_back(static_cast<Id>(f));
      }
    }
  }
  std::sort(named.begin(), named.end());
  named.erase(std::unique(named.begin(), named.end()), named.end());
  return named;
}

void Collect(const tetgenio& out, TetGenAnswer& answer)
{
  answer.points.resize(static_cast<std::size_t>(out.numberofpoints));
  for (std::size_t i = 0; i < answer.points.size(); ++i)
  {
    answer.points[i] = { out.pointlist[3 * i], out.pointlist[3 * i + 1], out.pointlist[3 * i + 2] };
  }
  answer.tets.resize(static_cast<std::size_t>(out.numberoftetrahedra));
  const std::size_t corners = static_cast<std::size_t>(out.numberofcorners);
  for (std::size_t i = 0; i < answer.tets.size(); ++i)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      answer.tets[i][k] = out.tetrahedronlist[i * corners + k];
    }
  }
}

void Run(const TetGenTask& task, TetGenAnswer& answer)
{
  tetgenio in;
  tetgenio out;
  Fill(task, in);
  std::string switches = "pQMJ" + task.switches;
  switches += task.sizes.empty() ? "" : "m";
  tetgenbehavior behaviour;
  if (!behaviour.parse_commandline(switches.data()))
  {
    answer.code = -1;
    answer.message = "TetGen does not know the switches \"" + switches + "\"";
    return;
  }
  tetrahedralize(&behaviour, &in, &out, nullptr, nullptr);
  Collect(out, answer);
}

} // namespace

TetGenAnswer RunTetGen(const TetGenTask& task, std::string (*transcript)())
{
  static std::mutex one;
  const std::lock_guard<std::mutex> lock(one);
  TetGenAnswer answer;
  constexpr std::size_t most = std::numeric_limits<int>::max() / 4;
  if (task.points.size() > most || task.facets.size() > most || task.inserted.size() > most)
  {
    answer.code = -1;
    answer.message = "TetGen counts with 32 bits: the surface is too large for it";
    return answer;
  }
  try
  {
    Run(task, answer);
  }
  catch (const std::bad_alloc&)
  {
    answer.code = 1;
  }
  catch (int code)
  {
    answer.code = code == 0 ? 2 : code;
  }
  if (answer.code > 0)
  {
    const std::string complaint = transcript != nullptr ? transcript() : std::string();
    answer.message = std::string(Meaning(answer.code)) + (complaint.empty() ? "" : " (" + complaint + ")");
    answer.facets = NamedFacets(complaint, task.facets);
  }
  return answer;
}

} // namespace lamina

#else

namespace lamina
{

TetGenAnswer RunTetGen(const TetGenTask&, std::string (*)())
{
  TetGenAnswer answer;
  answer.code = -1;
  answer.message = "built without TetGen (LAMINA_WITH_TETGEN is off)";
  return answer;
}

} // namespace lamina

#endif
