// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimVascularWriter.h"

#include "Arrays.h"
#include "SaveJob.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <functional>

vtkStandardNewMacro(vtkSimVascularWriter);

namespace
{

using lamina::Id;

/// Write with VTK's writer under a name of its own and rename.
lamina::Status WriteXML(vtkXMLWriter* writer, vtkDataObject* data, const std::string& path)
{
  const std::string unfinished = path + ".unfinished";
  writer->SetInputDataObject(data);
  writer->SetFileName(unfinished.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  if (writer->Write() == 0 || writer->GetErrorCode() != 0 ||
      std::rename(unfinished.c_str(), path.c_str()) != 0)
  {
    std::remove(unfinished.c_str());
    return lamina::Unreachable(path + " could not be written: the disk is full, or you may not write there");
  }
  return lamina::Done{};
}

/// A model with the numbers that its nodes and cells have in the whole mesh, from 1.
struct Piece
{
  const lamina::MeshModel& model;
  std::vector<Id> nodes;
  std::vector<Id> cells;
  int region;
};

vtkSmartPointer<vtkIdTypeArray> FromOne(const char* name, std::vector<Id> ids)
{
  for (Id& id : ids)
  {
    ++id;
  }
  return lamina::MakeArray<vtkIdTypeArray>(name, ids);
}

lamina::Status WriteMesh(const Piece& piece, const std::string& path)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkCellArray> cells;
  cells->SetData(lamina::MakeArray<vtkIdTypeArray>("", piece.model.mesh.offsets),
                 lamina::MakeArray<vtkIdTypeArray>("", piece.model.mesh.connectivity));
  grid->SetPoints(lamina::MakePoints(piece.model.mesh.points));
  grid->SetCells(VTK_TETRA, cells);
  grid->GetPointData()->AddArray(FromOne("GlobalNodeID", piece.nodes));
  grid->GetCellData()->AddArray(FromOne("GlobalElementID", piece.cells));
  grid->GetCellData()->AddArray(
    lamina::MakeArray<vtkIntArray>("ModelRegionID", std::vector<int>(piece.cells.size(), piece.region)));
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  return WriteXML(writer, grid, path);
}

/// The faces of the sets for which `isAsked` says so.
lamina::Status WriteFaces(const Piece& piece, const std::vector<lamina::SideSet>& sets,
                          const std::function<bool(std::size_t)>& isAsked, const std::string& path)
{
  std::vector<Id> numberOf(piece.model.mesh.points.size(), -1);
  std::vector<lamina::Vec3> points;
  std::vector<Id> nodes;
  std::vector<Id> parents;
  std::vector<int> faceIds;
  vtkNew<vtkCellArray> polys;
  std::array<Id, 8> corners;
  for (std::size_t s = 0; s < sets.size(); ++s)
  {
    if (!isAsked(s))
    {
      continue;
    }
    for (const lamina::Side& side : sets[s].sides)
    {
      lamina::SideNodes(piece.model, side, corners);
      polys->InsertNextCell(3);
      for (std::size_t k = 0; k < 3; ++k)
      {
        Id& number = numberOf[static_cast<std::size_t>(corners[k])];
        if (number < 0)
        {
          number = static_cast<Id>(points.size());
          points.push_back(piece.model.mesh.points[static_cast<std::size_t>(corners[k])]);
          nodes.push_back(piece.nodes[static_cast<std::size_t>(corners[k])]);
        }
        polys->InsertCellPoint(number);
      }
      parents.push_back(piece.cells[static_cast<std::size_t>(side.cell)]);
      faceIds.push_back(static_cast<int>(s) + 1);
    }
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(lamina::MakePoints(points));
  surface->SetPolys(polys);
  surface->GetPointData()->AddArray(FromOne("GlobalNodeID", nodes));
  surface->GetCellData()->AddArray(FromOne("GlobalElementID", parents));
  surface->GetCellData()->AddArray(lamina::MakeArray<vtkIntArray>("ModelFaceID", faceIds));
  vtkNew<vtkXMLPolyDataWriter> writer;
  return WriteXML(writer, surface, path);
}

void WritePiece(const Piece& piece, const std::map<std::string, std::string>& fitted,
                const std::string& folder, const std::string& name, lamina::SaveJob& job)
{
  const auto sets = lamina::SideSetsOf(piece.model);
  const auto isAll = [](std::size_t) { return true; };
  const auto isWall = [&](std::size_t s) { return sets[s].kind != lamina::PatchKind::Opening; };
  const bool isStarted = job.Keep(lamina::MakeFolder(folder + "/mesh-surfaces")) &&
                         job.Keep(WriteMesh(piece, folder + "/" + name + ".mesh.vtu")) &&
                         job.Keep(WriteFaces(piece, sets, isAll, folder + "/" + name + ".exterior.vtp")) &&
                         job.Keep(WriteFaces(piece, sets, isWall, folder + "/walls_combined.vtp"));
  for (std::size_t s = 0; s < sets.size() && isStarted && job.status; ++s)
  {
    const auto isThis = [s](std::size_t other) { return other == s; };
    job.Keep(WriteFaces(piece, sets, isThis, folder + "/mesh-surfaces/" + fitted.at(sets[s].name) + ".vtp"));
  }
}

} // namespace

lamina::FormatLimits vtkSimVascularWriter::Limits() const
{
  return lamina::TetrahedraOnly("SimVascular", lamina::LargestInt, 100);
}

void vtkSimVascularWriter::Save(lamina::SaveJob& job)
{
  const std::string folder = lamina::FolderOf(job.path);
  std::string name = lamina::StemOf(job.path);
  name = name.substr(0, name.rfind(".mesh"));
  std::map<std::string, std::string> fitted;
  const auto own = lamina::SideSetsOf(job.model);
  for (std::size_t s = 0; s < own.size(); ++s)
  {
    fitted[own[s].name] = job.sides[s].name;
  }
  for (std::size_t m = 0; m < job.materials.size() && job.status; ++m)
  {
    const int material = job.materials[m];
    std::vector<Id> nodes;
    const lamina::MeshModel part = lamina::TakeMaterial(job.model, material, nodes);
    const std::string place = job.materials.size() == 1 ? folder : folder + "/" + job.name.at(material);
    const Piece piece{ part, nodes, lamina::CellsOf(job.model, material, lamina::CellType::Tetrahedron),
                       material };
    WritePiece(piece, fitted, place, name, job);
  }
  if (job.status && job.materials.size() > 1)
  {
    job.notes.emplace_back("SimVascular has a mesh a domain: there is a folder a material");
  }
}
