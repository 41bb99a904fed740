// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSU2Writer.h"

#include "SaveJob.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSU2Writer);

namespace
{

using lamina::Id;

/// SU2 numbers its cells as VTK does.
void WriteOne(const lamina::MeshModel& model, const std::map<std::string, std::string>& fitted,
              const std::string& path, lamina::SaveJob& job)
{
  lamina::TextFile file(path);
  file << "% " << lamina::TitleOf(model) << "\nNDIME= 3\nNELEM= " << model.mesh.CellCount() << "\n";
  std::array<Id, 15> nodes;
  for (Id c = 0; c < model.mesh.CellCount(); ++c)
  {
    const auto type = model.mesh.types[static_cast<std::size_t>(c)];
    const int count = lamina::OrderedNodes(model, c, {}, nodes);
    file << static_cast<int>(type);
    for (int k = 0; k < count; ++k)
    {
      file << ' ' << nodes[static_cast<std::size_t>(k)];
    }
    file << ' ' << c << '\n';
  }
  if (!job.GoesOn(0.5, "Writing nodes"))
  {
    return;
  }
  file << "NPOIN= " << model.mesh.points.size() << "\n";
  for (std::size_t p = 0; p < model.mesh.points.size(); ++p)
  {
    file.Point(model.mesh.points[p]) << ' ' << p << '\n';
  }
  const auto sides = lamina::SideSetsOf(model);
  std::size_t markers = 0;
  for (const lamina::SideSet& set : sides)
  {
    markers += set.sides.empty() ? 0 : 1;
  }
  file << "NMARK= " << markers << "\n";
  std::array<Id, 8> corners;
  for (const lamina::SideSet& set : sides)
  {
    if (set.sides.empty())
    {
      continue;
    }
    file << "MARKER_TAG= " << fitted.at(set.name) << "\nMARKER_ELEMS= " << set.sides.size() << "\n";
    for (const lamina::Side& side : set.sides)
    {
      const int count = lamina::SideNodes(model, side, corners);
      file << (count == 3 ? "5" : "9");
      for (int k = 0; k < count; ++k)
      {
        file << ' ' << corners[static_cast<std::size_t>(k)];
      }
      file << '\n';
    }
  }
  job.Keep(file.Close());
}

} // namespace

lamina::FormatLimits vtkSU2Writer::Limits() const
{
  return lamina::LimitsOf("SU2", 0, 100);
}

void vtkSU2Writer::Save(lamina::SaveJob& job)
{
  std::map<std::string, std::string> fitted;
  const auto own = lamina::SideSetsOf(job.model);
  for (std::size_t s = 0; s < own.size(); ++s)
  {
    fitted[own[s].name] = job.sides[s].name;
  }
  if (job.materials.size() == 1)
  {
    WriteOne(job.model, fitted, job.path, job);
    return;
  }
  const std::string stem = lamina::FolderOf(job.path) + "/" + lamina::StemOf(job.path) + "_";
  for (std::size_t m = 0; m < job.materials.size() && job.status; ++m)
  {
    std::vector<Id> nodes;
    const lamina::MeshModel part = lamina::TakeMaterial(job.model, job.materials[m], nodes);
    WriteOne(part, fitted, stem + job.name.at(job.materials[m]) + ".su2", job);
  }
  if (job.status)
  {
    job.notes.push_back("SU2 has no materials within a file: there is a file a material, " +
                        lamina::StemOf(job.path) + "_<material>.su2");
  }
}
