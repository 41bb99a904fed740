// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLSDynaWriter.h"

#include "SaveJob.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLSDynaWriter);

namespace
{

using lamina::Id;

/// The cell as a hexahedron with nodes that occur more than once, as the manual has it: tetrahedron
/// 1 2 3 4 4 4 4 4, pyramid 1 2 3 4 5 5 5 5, prism 1 2 3 4 5 5 6 6, whose triangles are 1 2 5 and 4 3 6.
std::array<Id, 8> Hexahedron(const lamina::VolumeMesh& mesh, Id cell)
{
  const Id* n = mesh.Cell(cell);
  switch (mesh.types[static_cast<std::size_t>(cell)])
  {
    case lamina::CellType::Wedge:
      return { { n[0], n[1], n[4], n[3], n[2], n[2], n[5], n[5] } };
    case lamina::CellType::Pyramid:
      return { { n[0], n[1], n[2], n[3], n[4], n[4], n[4], n[4] } };
    default:
      return { { n[0], n[1], n[2], n[3], n[3], n[3], n[3], n[3] } };
  }
}

/// A list with a title: eight ids of ten columns a line.
void WriteList(lamina::TextFile& file, const char* keyword, const std::string& title, Id set,
               const std::vector<Id>& ids)
{
  file << keyword << "\n" << title << "\n";
  file.Field(set, 10) << "\n";
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    file.Field(ids[i] + 1, 10);
    file << (i + 1 == ids.size() || i % 8 == 7 ? "\n" : "");
  }
}

void WriteSegments(lamina::TextFile& file, const lamina::SaveJob& job, const lamina::SideSet& set, Id number)
{
  file << "*SET_SEGMENT_TITLE\n" << set.name << "\n";
  file.Field(number, 10) << "\n";
  std::array<Id, 8> corners;
  for (const lamina::Side& side : set.sides)
  {
    const int count = lamina::SideNodes(job.model, side, corners);
    for (std::size_t k = 0; k < 4; ++k)
    {
      file.Field(corners[count == 3 && k == 3 ? 2 : k] + 1, 10);
    }
    file << "\n";
  }
}

void WriteParts(lamina::TextFile& file, const lamina::SaveJob& job)
{
  file
    << "*CONTROL_SOLID\n$    esort\n         1\n*SECTION_SOLID\n$    secid    elform\n         1         1\n";
  for (int material : job.materials)
  {
    file << "*PART\n" << job.name.at(material) << "\n";
    file.Field(Id{ material }, 10);
    file.Field(Id{ 1 }, 10);
    file.Field(Id{ material }, 10) << "\n";
  }
}

} // namespace

lamina::FormatLimits vtkLSDynaWriter::Limits() const
{
  return lamina::LimitsOf("LS-DYNA", 99999999, 70);
}

void vtkLSDynaWriter::Save(lamina::SaveJob& job)
{
  const lamina::VolumeMesh& mesh = job.model.mesh;
  lamina::TextFile file(job.path);
  file << "*KEYWORD\n*TITLE\n" << lamina::TitleOf(job.model) << "\n";
  WriteParts(file, job);
  file << "*NODE\n";
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    file.Field(static_cast<Id>(p) + 1, 8);
    file.Field(mesh.points[p].x, 16);
    file.Field(mesh.points[p].y, 16);
    file.Field(mesh.points[p].z, 16) << "\n";
  }
  if (!job.GoesOn(0.4, "Writing elements"))
  {
    return;
  }
  file << "*ELEMENT_SOLID\n";
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    file.Field(c + 1, 8);
    file.Field(Id{ mesh.materials[static_cast<std::size_t>(c)] }, 8);
    for (Id node : Hexahedron(mesh, c))
    {
      file.Field(node + 1, 8);
    }
    file << "\n";
  }
  if (!job.GoesOn(0.8, "Writing sets"))
  {
    return;
  }
  Id number = 0;
  for (const lamina::SideSet& set : job.sides)
  {
    ++number;
    if (set.sides.empty())
    {
      job.notes.push_back("the patch " + set.name +
                          " has no faces, and is left out: LS-DYNA has no empty sets");
      continue;
    }
    WriteList(file, "*SET_NODE_LIST_TITLE", set.name, number, lamina::NodesOf(job.model, set));
    WriteSegments(file, job, set, number);
  }
  number = 0;
  for (const lamina::LayerSet& layer : job.layers)
  {
    WriteList(file, "*SET_SOLID_TITLE", layer.name, ++number, layer.cells);
  }
  file << "*END\n";
  job.Keep(file.Close());
}
