// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCARPWriter.h"

#include "SaveJob.h"

#include "vtkObjectFactory.h"

#include <optional>

vtkStandardNewMacro(vtkCARPWriter);

namespace
{

using lamina::Id;

/// Micrometres a unit of length.
std::optional<double> Micrometres(const std::string& unit)
{
  const std::map<std::string, double> known = { { "m", 1e6 }, { "cm", 1e4 }, { "mm", 1e3 }, { "um", 1 } };
  const auto found = known.find(unit);
  return found == known.end() ? std::nullopt : std::optional<double>(found->second);
}

lamina::Status WritePoints(const lamina::MeshModel& model, const std::string& base, double scale)
{
  lamina::TextFile file(base + ".pts");
  file << model.mesh.points.size() << "\n";
  for (const lamina::Vec3& p : model.mesh.points)
  {
    file.Point(p * scale) << "\n";
  }
  return file.Close();
}

lamina::Status WriteElements(const lamina::MeshModel& model, const std::string& base)
{
  lamina::TextFile file(base + ".elem");
  file << model.mesh.CellCount() << "\n";
  for (Id c = 0; c < model.mesh.CellCount(); ++c)
  {
    const Id* n = model.mesh.Cell(c);
    file << "Tt " << n[0] << ' ' << n[1] << ' ' << n[2] << ' ' << n[3] << ' '
         << model.mesh.materials[static_cast<std::size_t>(c)] << '\n';
  }
  return file.Close();
}

lamina::Status WriteFibers(const lamina::MeshModel& model, const std::string& base)
{
  lamina::TextFile file(base + ".lon");
  file << "1\n";
  for (Id c = 0; c < model.mesh.CellCount(); ++c)
  {
    file.Point(model.fibers.empty() ? lamina::Vec3{ 1, 0, 0 } : model.fibers[static_cast<std::size_t>(c)])
      << '\n';
  }
  return file.Close();
}

lamina::Status WriteNodeSet(const lamina::MeshModel& model, const lamina::SideSet& set,
                            const std::string& base)
{
  lamina::TextFile file(base + "_" + set.name + ".vtx");
  const auto ids = lamina::NodesOf(model, set);
  file << ids.size() << "\nextra\n";
  for (Id id : ids)
  {
    file << id << '\n';
  }
  return file.Close();
}

lamina::Status WriteSurface(const lamina::MeshModel& model, const lamina::SideSet& set,
                            const std::string& base)
{
  lamina::TextFile file(base + "_" + set.name + ".surf");
  file << set.sides.size() << "\n";
  std::array<Id, 8> n;
  for (const lamina::Side& side : set.sides)
  {
    lamina::SideNodes(model, side, n);
    file << "Tr " << n[0] << ' ' << n[1] << ' ' << n[2] << '\n';
  }
  return file.Close();
}

} // namespace

lamina::FormatLimits vtkCARPWriter::Limits() const
{
  return lamina::TetrahedraOnly("openCARP", lamina::LargestInt, 100);
}

void vtkCARPWriter::Save(lamina::SaveJob& job)
{
  const std::string base = lamina::FolderOf(job.path) + "/" + lamina::StemOf(job.path);
  const auto scale = Micrometres(job.model.unit);
  if (!scale)
  {
    job.notes.push_back(
      "openCARP expects micrometres, but the mesh's unit is " +
      (job.model.unit.empty() ? "not known" : job.model.unit) +
      ": coordinates are written as they are; set Unit of Fluid-Solid Mesh to m, cm, mm or um");
  }
  if (job.model.fibers.empty())
  {
    job.notes.emplace_back("the mesh has no Fibers: all fibres in the .lon file are along x");
  }
  const bool isStarted = job.Keep(WritePoints(job.model, base, scale.value_or(1))) &&
                         job.GoesOn(0.4, "Writing elements") && job.Keep(WriteElements(job.model, base)) &&
                         job.Keep(WriteFibers(job.model, base)) && job.GoesOn(0.9, "Writing sets");
  for (const lamina::SideSet& set : job.sides)
  {
    if (!isStarted || !job.Keep(WriteNodeSet(job.model, set, base)) ||
        !job.Keep(WriteSurface(job.model, set, base)))
    {
      return;
    }
  }
}
