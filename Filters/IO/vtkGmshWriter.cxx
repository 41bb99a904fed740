// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGmshWriter.h"

#include "SaveJob.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkGmshWriter);

namespace
{

using lamina::CellType;
using lamina::Id;

int CellNumber(CellType type, bool isQuadratic)
{
  switch (type)
  {
    case CellType::Wedge:
      return isQuadratic ? 18 : 6;
    case CellType::Pyramid:
      return isQuadratic ? 19 : 7;
    default:
      return isQuadratic ? 11 : 4;
  }
}

/// Of a triangle or quad with this many nodes.
int SideNumber(int nodes)
{
  switch (nodes)
  {
    case 3:
      return 2;
    case 4:
      return 3;
    case 6:
      return 9;
    default:
      return 16;
  }
}

/// The edges of middle nodes in Gmsh's order.
const std::vector<std::array<int, 2>>& GmshEdges(CellType type)
{
  static const std::vector<std::array<int, 2>> tet{ { { 0, 1 } }, { { 1, 2 } }, { { 0, 2 } },
                                                    { { 0, 3 } }, { { 2, 3 } }, { { 1, 3 } } };
  static const std::vector<std::array<int, 2>> wedge{ { { 0, 1 } }, { { 0, 2 } }, { { 0, 3 } },
                                                      { { 1, 2 } }, { { 1, 4 } }, { { 2, 5 } },
                                                      { { 3, 4 } }, { { 3, 5 } }, { { 4, 5 } } };
  static const std::vector<std::array<int, 2>> pyramid{ { { 0, 1 } }, { { 0, 3 } }, { { 0, 4 } },
                                                        { { 1, 2 } }, { { 1, 4 } }, { { 2, 3 } },
                                                        { { 2, 4 } }, { { 3, 4 } } };
  return type == CellType::Tetrahedron ? tet : (type == CellType::Wedge ? wedge : pyramid);
}

/// Elements of one entity and type: surfaces first, then volumes.
struct Block
{
  int dimension;
  int tag;
  int type;
  std::vector<lamina::Side> sides; ///< of a surface
  std::vector<Id> cells;           ///< of a volume
  Id Count() const { return static_cast<Id>(this->sides.size() + this->cells.size()); }
};

std::vector<Block> MakeBlocks(const lamina::SaveJob& job)
{
  std::vector<Block> blocks;
  std::array<Id, 8> nodes;
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    std::map<int, std::vector<lamina::Side>> byType;
    for (const lamina::Side& side : job.sides[s].sides)
    {
      byType[SideNumber(lamina::SideNodes(job.model, side, nodes))].push_back(side);
    }
    for (auto& [type, sides] : byType)
    {
      blocks.push_back({ 2, static_cast<int>(s) + 1, type, std::move(sides), {} });
    }
  }
  for (int material : job.materials)
  {
    for (CellType type : lamina::AllTypes)
    {
      auto cells = lamina::CellsOf(job.model, material, type);
      if (!cells.empty())
      {
        blocks.push_back({ 3, material, CellNumber(type, job.model.IsQuadratic()), {}, std::move(cells) });
      }
    }
  }
  return blocks;
}

/// One line an element: `head` after its number, then its nodes.
void WriteBlock(lamina::TextFile& file, const lamina::SaveJob& job, const Block& block,
                const std::string& head, Id& number)
{
  std::array<Id, 8> side;
  std::array<Id, 15> cell;
  for (const lamina::Side& s : block.sides)
  {
    const int count = lamina::SideNodes(job.model, s, side);
    file << ++number << head;
    for (int k = 0; k < count; ++k)
    {
      file << ' ' << side[static_cast<std::size_t>(k)] + 1;
    }
    file << '\n';
  }
  for (Id c : block.cells)
  {
    const auto type = job.model.mesh.types[static_cast<std::size_t>(c)];
    const int count = lamina::OrderedNodes(job.model, c, GmshEdges(type), cell);
    file << ++number << head;
    for (int k = 0; k < count; ++k)
    {
      file << ' ' << cell[static_cast<std::size_t>(k)] + 1;
    }
    file << '\n';
  }
}

void WriteNames(lamina::TextFile& file, const lamina::SaveJob& job)
{
  file << "$PhysicalNames\n" << job.sides.size() + job.materials.size() << "\n";
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    file << "2 " << s + 1 << " \"" << job.sides[s].name << "\"\n";
  }
  for (int material : job.materials)
  {
    file << "3 " << material << " \"" << job.name.at(material) << "\"\n";
  }
  file << "$EndPhysicalNames\n";
}

std::string BoundsOf(const std::vector<lamina::Vec3>& points)
{
  lamina::Vec3 low = points.front();
  lamina::Vec3 high = low;
  for (const lamina::Vec3& p : points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  std::string text;
  for (const lamina::Vec3& p : { low, high })
  {
    for (int k = 0; k < 3; ++k)
    {
      text += " " + std::to_string(p[k]);
    }
  }
  return text;
}

void WriteEntities(lamina::TextFile& file, const lamina::SaveJob& job)
{
  const std::string bounds = BoundsOf(job.model.mesh.points);
  file << "$Entities\n0 0 " << job.sides.size() << ' ' << job.materials.size() << "\n";
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    file << s + 1 << bounds << " 1 " << s + 1 << " 0\n";
  }
  for (int material : job.materials)
  {
    file << material << bounds << " 1 " << material;
    std::vector<std::size_t> own;
    for (std::size_t s = 0; s < job.sides.size(); ++s)
    {
      const auto& pair = job.sides[s].pair;
      if (pair.first == material || pair.second == material)
      {
        own.push_back(s + 1);
      }
    }
    file << ' ' << own.size();
    for (std::size_t s : own)
    {
      file << ' ' << s;
    }
    file << "\n";
  }
  file << "$EndEntities\n";
}

void WriteNodes41(lamina::TextFile& file, const lamina::SaveJob& job)
{
  // All nodes are put down in the first volume: what they lie on is told by the elements.
  const auto& points = job.model.mesh.points;
  file << "$Nodes\n1 " << points.size() << " 1 " << points.size() << "\n";
  file << "3 " << job.materials.front() << " 0 " << points.size() << "\n";
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    file << p + 1 << '\n';
  }
  for (const lamina::Vec3& p : points)
  {
    file.Point(p) << '\n';
  }
  file << "$EndNodes\n";
}

void Write41(lamina::TextFile& file, lamina::SaveJob& job, const std::vector<Block>& blocks, Id elements)
{
  WriteEntities(file, job);
  WriteNodes41(file, job);
  if (!job.GoesOn(0.4, "Writing elements"))
  {
    return;
  }
  file << "$Elements\n" << blocks.size() << ' ' << elements << " 1 " << elements << "\n";
  Id number = 0;
  for (const Block& block : blocks)
  {
    file << block.dimension << ' ' << block.tag << ' ' << block.type << ' ' << block.Count() << "\n";
    WriteBlock(file, job, block, "", number);
  }
  file << "$EndElements\n";
}

void Write22(lamina::TextFile& file, lamina::SaveJob& job, const std::vector<Block>& blocks, Id elements)
{
  const auto& points = job.model.mesh.points;
  file << "$Nodes\n" << points.size() << "\n";
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    file << p + 1 << ' ';
    file.Point(points[p]) << '\n';
  }
  file << "$EndNodes\n";
  if (!job.GoesOn(0.4, "Writing elements"))
  {
    return;
  }
  file << "$Elements\n" << elements << "\n";
  Id number = 0;
  for (const Block& block : blocks)
  {
    const std::string tag = std::to_string(block.tag);
    WriteBlock(file, job, block, " " + std::to_string(block.type) + " 2 " + tag + " " + tag, number);
  }
  file << "$EndElements\n";
}

} // namespace

lamina::FormatLimits vtkGmshWriter::Limits() const
{
  lamina::FormatLimits limits;
  limits.format = "Gmsh";
  limits.holdsQuadratic = true;
  limits.holdsQuadraticPyramids = true;
  limits.largestId = this->Version == 22 ? lamina::LargestInt : 0;
  limits.nameLength = 127;
  limits.lettersOnly = false;
  return limits;
}

void vtkGmshWriter::Save(lamina::SaveJob& job)
{
  if (this->Version != 41 && this->Version != 22)
  {
    job.Keep(lamina::InvalidOption("Version is " + std::to_string(this->Version) + ", but must be 41 or 22"));
    return;
  }
  const bool isNew = this->Version == 41;
  lamina::TextFile file(job.path);
  file << "$MeshFormat\n" << (isNew ? "4.1" : "2.2") << " 0 8\n$EndMeshFormat\n";
  WriteNames(file, job);
  const std::vector<Block> blocks = MakeBlocks(job);
  Id elements = 0;
  for (const Block& block : blocks)
  {
    elements += block.Count();
  }
  if (isNew)
  {
    Write41(file, job, blocks, elements);
  }
  else
  {
    Write22(file, job, blocks, elements);
  }
  if (job.status)
  {
    job.Keep(file.Close());
  }
}

void vtkGmshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Version: " << this->Version << "\n";
}
