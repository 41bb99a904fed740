// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenFOAMWriter.h"

#include "PolyMesh.h"
#include "SaveJob.h"

#include "vtkObjectFactory.h"

#include <filesystem>

vtkStandardNewMacro(vtkOpenFOAMWriter);

namespace
{

using lamina::Id;

std::string Header(const char* type, const char* object, const char* location)
{
  return std::string("FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       ") + type +
         ";\n    location    \"" + location + "\";\n    object      " + object + ";\n}\n\n";
}

std::string MeshHeader(const char* type, const char* object)
{
  return Header(type, object, "constant/polyMesh");
}

lamina::Status WritePoints(const lamina::SaveJob& job, const std::string& folder)
{
  lamina::TextFile file(folder + "/points");
  file << MeshHeader("vectorField", "points") << job.model.mesh.points.size() << "\n(\n";
  for (const lamina::Vec3& p : job.model.mesh.points)
  {
    file << '(';
    file.Point(p) << ")\n";
  }
  file << ")\n";
  return file.Close();
}

lamina::Status WriteFaces(const lamina::PolyMesh& mesh, const std::string& folder)
{
  lamina::TextFile file(folder + "/faces");
  file << MeshHeader("faceList", "faces") << mesh.owners.size() << "\n(\n";
  for (std::size_t f = 0; f < mesh.faces.size(); f += 4)
  {
    const bool isQuad = mesh.faces[f + 3] >= 0;
    file << (isQuad ? "4(" : "3(") << mesh.faces[f] << ' ' << mesh.faces[f + 1] << ' ' << mesh.faces[f + 2];
    if (isQuad)
    {
      file << ' ' << mesh.faces[f + 3];
    }
    file << ")\n";
  }
  file << ")\n";
  return file.Close();
}

lamina::Status WriteLabels(const std::vector<Id>& labels, const char* name, const std::string& folder)
{
  lamina::TextFile file(folder + "/" + name);
  file << MeshHeader("labelList", name) << labels.size() << "\n(\n";
  for (Id label : labels)
  {
    file << label << '\n';
  }
  file << ")\n";
  return file.Close();
}

lamina::Status WriteBoundary(const lamina::SaveJob& job, const lamina::PolyMesh& mesh,
                             const std::string& folder)
{
  std::string text;
  int count = 0;
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    if (!mesh.zoneFaces[s].empty())
    {
      continue;
    }
    ++count;
    const bool isOpening = job.sides[s].kind == lamina::PatchKind::Opening;
    text += "    " + job.sides[s].name + "\n    {\n        type            " +
            (isOpening ? "patch" : "wall") + ";\n        nFaces          " +
            std::to_string(mesh.patchStart[s + 1] - mesh.patchStart[s]) + ";\n        startFace       " +
            std::to_string(mesh.patchStart[s]) + ";\n    }\n";
  }
  lamina::TextFile file(folder + "/boundary");
  file << MeshHeader("polyBoundaryMesh", "boundary") << count << "\n(\n" << text << ")\n";
  return file.Close();
}

template<typename Values>
void WriteList(lamina::TextFile& file, const char* name, const char* type, const Values& values)
{
  file << "    " << name << "      List<" << type << ">\n" << values.size() << "\n(\n";
  for (const auto& value : values)
  {
    file << static_cast<Id>(value) << '\n';
  }
  file << ");\n";
}

lamina::Status WriteZones(const lamina::SaveJob& job, const lamina::PolyMesh& mesh, const std::string& folder)
{
  lamina::TextFile cells(folder + "/cellZones");
  cells << MeshHeader("regIOobject", "cellZones") << job.materials.size() << "\n(\n";
  for (int material : job.materials)
  {
    std::vector<Id> own;
    for (std::size_t c = 0; c < job.model.mesh.materials.size(); ++c)
    {
      if (job.model.mesh.materials[c] == material)
      {
        own.push_back(static_cast<Id>(c));
      }
    }
    cells << job.name.at(material) << "\n{\n    type cellZone;\n";
    WriteList(cells, "cellLabels", "label", own);
    cells << "}\n";
  }
  cells << ")\n";
  lamina::TextFile faces(folder + "/faceZones");
  std::size_t zones = 0;
  for (const auto& zone : mesh.zoneFaces)
  {
    zones += zone.empty() ? 0 : 1;
  }
  faces << MeshHeader("regIOobject", "faceZones") << zones << "\n(\n";
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    if (!mesh.zoneFaces[s].empty())
    {
      faces << job.sides[s].name << "\n{\n    type faceZone;\n";
      WriteList(faces, "faceLabels", "label", mesh.zoneFaces[s]);
      WriteList(faces, "flipMap", "bool", mesh.zoneFlips[s]);
      faces << "}\n";
    }
  }
  faces << ")\n";
  const lamina::Status first = cells.Close();
  return first ? faces.Close() : first;
}

/// What checkMesh and other utilities want to see, where there is nothing yet.
lamina::Status WriteControl(const std::string& root)
{
  const std::string solvers =
    "ddtSchemes { default steadyState; }\ngradSchemes { default Gauss linear; }\n"
    "divSchemes { default none; }\nlaplacianSchemes { default none; }\n"
    "interpolationSchemes { default linear; }\nsnGradSchemes { default corrected; }\n";
  const std::map<std::string, std::string> texts = {
    { "controlDict",
      "application     checkMesh;\nstartFrom       startTime;\nstartTime       0;\nstopAt          "
      "endTime;\nendTime         0;\ndeltaT          1;\nwriteControl    timeStep;\nwriteInterval   "
      "1;\n" },
    { "fvSchemes", solvers },
    { "fvSolution", "solvers {}\n" },
  };
  for (const auto& [name, text] : texts)
  {
    const std::string path = root + "/system/" + name;
    if (std::filesystem::exists(path))
    {
      continue;
    }
    lamina::TextFile file(path);
    file << Header("dictionary", name.c_str(), "system") << text;
    const lamina::Status done = file.Close();
    if (!done)
    {
      return done;
    }
  }
  return lamina::Done{};
}

} // namespace

lamina::FormatLimits vtkOpenFOAMWriter::Limits() const
{
  lamina::FormatLimits limits;
  limits.format = "OpenFOAM";
  limits.largestId = lamina::LargestInt; // of a label of 32 bits, as most builds have
  return limits;
}

void vtkOpenFOAMWriter::Save(lamina::SaveJob& job)
{
  const std::string root = lamina::FolderOf(job.path);
  const std::string folder = root + "/constant/polyMesh";
  if (!job.Keep(lamina::MakeFolder(folder)) || !job.Keep(lamina::MakeFolder(root + "/system")))
  {
    return;
  }
  const auto mesh = lamina::MakePolyMesh(job);
  if (!mesh)
  {
    job.Keep(mesh.GetError());
    return;
  }
  const auto faces = lamina::CheckCount(this->Limits(), static_cast<Id>(mesh->owners.size()), "faces");
  if (!faces)
  {
    job.Keep(faces.GetError());
    return;
  }
  const bool isDone = job.GoesOn(0.3, "Writing points") && job.Keep(WritePoints(job, folder)) &&
                      job.GoesOn(0.5, "Writing faces") && job.Keep(WriteFaces(*mesh, folder)) &&
                      job.Keep(WriteLabels(mesh->owners, "owner", folder)) &&
                      job.Keep(WriteLabels(mesh->neighbours, "neighbour", folder)) &&
                      job.Keep(WriteBoundary(job, *mesh, folder)) && job.GoesOn(0.9, "Writing zones") &&
                      job.Keep(WriteZones(job, *mesh, folder)) && job.Keep(WriteControl(root));
  if (isDone)
  {
    lamina::TextFile marker(job.path); // by which ParaView finds the case
    job.Keep(marker.Close());
  }
}
