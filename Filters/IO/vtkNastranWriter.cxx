// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNastranWriter.h"

#include "SaveJob.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkNastranWriter);

namespace
{

using lamina::Id;

const char* CellName(lamina::CellType type)
{
  switch (type)
  {
    case lamina::CellType::Wedge:
      return "CPENTA  ";
    case lamina::CellType::Pyramid:
      return "CPYRAM  ";
    default:
      return "CTETRA  ";
  }
}

/// SET1 of ids: eight columns a number, eight numbers a line, the first of which is the set's own.
void WriteSet(lamina::TextFile& file, int set, const std::vector<Id>& ids)
{
  file << "SET1    ";
  file.Field(Id{ set }, 8);
  int column = 1;
  for (Id id : ids)
  {
    if (column == 8)
    {
      file << "\n        ";
      column = 0;
    }
    file.Field(id + 1, 8);
    ++column;
  }
  file << "\n";
}

} // namespace

lamina::FormatLimits vtkNastranWriter::Limits() const
{
  return lamina::LimitsOf("Nastran", 99999999, 64);
}

void vtkNastranWriter::Save(lamina::SaveJob& job)
{
  const lamina::VolumeMesh& mesh = job.model.mesh;
  lamina::TextFile file(job.path);
  file << "$ " << lamina::TitleOf(job.model) << "\nBEGIN BULK\n";
  // Materials keep their ids as properties; patches follow.
  const int firstPatch = job.materials.back() + 1;
  for (int material : job.materials)
  {
    file << "$HMNAME COMP " << material << "\"" << job.name.at(material) << "\"\n";
  }
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    file << "$HMNAME COMP " << firstPatch + static_cast<int>(s) << "\"" << job.sides[s].name << "\"\n";
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    file << "GRID*   ";
    file.Field(static_cast<Id>(p) + 1, 16) << "                ";
    file.Field(mesh.points[p].x, 16);
    file.Field(mesh.points[p].y, 16) << "\n*       ";
    file.Field(mesh.points[p].z, 16) << "\n";
  }
  if (!job.GoesOn(0.4, "Writing elements"))
  {
    return;
  }
  std::array<Id, 15> nodes;
  for (Id c = 0; c < mesh.CellCount(); ++c)
  {
    const auto type = mesh.types[static_cast<std::size_t>(c)];
    const int count = lamina::OrderedNodes(job.model, c, {}, nodes);
    file << CellName(type);
    file.Field(c + 1, 8);
    file.Field(Id{ mesh.materials[static_cast<std::size_t>(c)] }, 8);
    for (int k = 0; k < count; ++k)
    {
      file.Field(nodes[static_cast<std::size_t>(k)] + 1, 8);
    }
    file << '\n';
  }
  if (!job.GoesOn(0.8, "Writing patches"))
  {
    return;
  }
  Id number = mesh.CellCount();
  std::array<Id, 8> corners;
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    const int property = firstPatch + static_cast<int>(s);
    for (const lamina::Side& side : job.sides[s].sides)
    {
      const int count = lamina::SideNodes(job.model, side, corners);
      file << (count == 3 ? "CTRIA3  " : "CQUAD4  ");
      file.Field(++number, 8);
      file.Field(Id{ property }, 8);
      for (int k = 0; k < count; ++k)
      {
        file.Field(corners[static_cast<std::size_t>(k)] + 1, 8);
      }
      file << '\n';
    }
  }
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    const auto ids = lamina::NodesOf(job.model, job.sides[s]);
    if (!ids.empty())
    {
      file << "$ nodes of " << job.sides[s].name << "\n";
      WriteSet(file, firstPatch + static_cast<int>(s), ids);
    }
  }
  file << "ENDDATA\n";
  job.Keep(file.Close());
}
