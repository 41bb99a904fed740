// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAbaqusWriter.h"

#include "SaveJob.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkAbaqusWriter);

namespace
{

constexpr int ItemWidth = 20; ///< of a number in a data line

const char* TypeName(lamina::CellType type, bool isQuadratic)
{
  switch (type)
  {
    case lamina::CellType::Wedge:
      return isQuadratic ? "C3D15" : "C3D6";
    case lamina::CellType::Pyramid:
      return "C3D5";
    default:
      return isQuadratic ? "C3D10" : "C3D4";
  }
}

/// The number of a face in Abaqus: our faces are numbered by CellFaces.h, and our wedge stands on its other
/// triangle's order, so that its sides 0 3 4 1, 1 4 5 2, 2 5 3 0 are its edges 1-3, 3-2, 2-1.
int FaceNumber(lamina::CellType type, int face)
{
  constexpr int tet[4] = { 3, 4, 2, 1 };
  constexpr int wedge[5] = { 1, 2, 5, 4, 3 };
  constexpr int pyramid[5] = { 1, 2, 3, 4, 5 };
  switch (type)
  {
    case lamina::CellType::Wedge:
      return wedge[face];
    case lamina::CellType::Pyramid:
      return pyramid[face];
    default:
      return tet[face];
  }
}

/// Ids from 1, sixteen a line.
void WriteIds(lamina::TextFile& file, const std::vector<lamina::Id>& ids)
{
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    file << ids[i] + 1 << (i + 1 == ids.size() || i % 16 == 15 ? "\n" : ", ");
  }
}

void WriteElements(lamina::TextFile& file, const lamina::SaveJob& job)
{
  for (int material : job.materials)
  {
    for (lamina::CellType type : lamina::AllTypes)
    {
      const auto cells = lamina::CellsOf(job.model, material, type);
      if (cells.empty())
      {
        continue;
      }
      file << "*ELEMENT, TYPE=" << TypeName(type, job.model.IsQuadratic())
           << ", ELSET=" << job.name.at(material) << "\n";
      std::array<lamina::Id, 15> nodes;
      for (lamina::Id cell : cells)
      {
        const int count = lamina::OrderedNodes(job.model, cell, lamina::EdgeNodes(type), nodes);
        file << cell + 1;
        for (int k = 0; k < count; ++k)
        {
          file << (k == 10 ? ",\n" : ", ") << nodes[static_cast<std::size_t>(k)] + 1;
        }
        file << "\n";
      }
    }
  }
}

void WriteSurface(lamina::TextFile& file, const lamina::SaveJob& job, const lamina::SideSet& set)
{
  std::map<int, std::vector<lamina::Id>> cells;
  for (const lamina::Side& side : set.sides)
  {
    const auto type = job.model.mesh.types[static_cast<std::size_t>(side.cell)];
    cells[FaceNumber(type, side.face)].push_back(side.cell);
  }
  for (const auto& [face, list] : cells)
  {
    file << "*ELSET, ELSET=" << set.name << "_S" << face << "\n";
    WriteIds(file, list);
  }
  file << "*SURFACE, TYPE=ELEMENT, NAME=" << set.name << "_faces\n";
  for (const auto& entry : cells)
  {
    file << set.name << "_S" << entry.first << ", S" << entry.first << "\n";
  }
}

} // namespace

lamina::FormatLimits vtkAbaqusWriter::Limits() const
{
  // Names have 80 characters, with room for _faces.
  lamina::FormatLimits limits = lamina::LimitsOf("Abaqus", 999999999, 73);
  limits.holdsQuadratic = true;
  limits.ignoresCase = true;
  return limits;
}

void vtkAbaqusWriter::Save(lamina::SaveJob& job)
{
  lamina::TextFile file(job.path);
  file << "*HEADING\n" << lamina::TitleOf(job.model) << "\n*NODE, NSET=all_nodes\n";
  const auto& points = job.model.mesh.points;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    file << p + 1;
    for (int k = 0; k < 3; ++k)
    {
      file << ", ";
      file.Within(points[p][k], ItemWidth);
    }
    file << "\n";
  }
  if (!job.GoesOn(0.3, "Writing elements"))
  {
    return;
  }
  WriteElements(file, job);
  if (!job.GoesOn(0.8, "Writing sets"))
  {
    return;
  }
  for (const lamina::LayerSet& layer : job.layers)
  {
    file << "*ELSET, ELSET=" << layer.name << "\n";
    WriteIds(file, layer.cells);
  }
  for (const lamina::SideSet& set : job.sides)
  {
    if (set.sides.empty())
    {
      job.notes.push_back("the patch " + set.name +
                          " has no faces, and is left out: Abaqus has no empty sets");
      continue;
    }
    file << "*NSET, NSET=" << set.name << "\n";
    WriteIds(file, lamina::NodesOf(job.model, set));
    WriteSurface(file, job, set);
  }
  job.Keep(file.Close());
}
