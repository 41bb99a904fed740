// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluidSolidExodusWriter.h"

#include "MeshArrayNames.h"
#include "NetcdfFile.h"
#include "SaveJob.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFluidSolidExodusWriter);

namespace
{

using lamina::CellType;
using lamina::Id;

const char* TypeName(CellType type, bool isQuadratic)
{
  switch (type)
  {
    case CellType::Wedge:
      return isQuadratic ? "WEDGE15" : "WEDGE6";
    case CellType::Pyramid:
      return isQuadratic ? "PYRAMID13" : "PYRAMID5";
    default:
      return isQuadratic ? "TETRA10" : "TETRA4";
  }
}

/// Exodus numbers the edges of a wedge around the base, upwards, around the roof.
const std::vector<std::array<int, 2>>& Edges(CellType type)
{
  static const std::vector<std::array<int, 2>> wedge{ { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } },
                                                      { { 0, 3 } }, { { 1, 4 } }, { { 2, 5 } },
                                                      { { 3, 4 } }, { { 4, 5 } }, { { 5, 3 } } };
  return type == CellType::Wedge ? wedge : lamina::EdgeNodes(type);
}

/// The number of one of our faces (CellFaces.h) in Exodus, whose wedge stands on our wedge's first triangle
/// in the order 0 2 1.
int SideNumber(CellType type, int face)
{
  constexpr int tet[4] = { 2, 3, 1, 4 };
  constexpr int wedge[5] = { 4, 5, 3, 2, 1 };
  constexpr int pyramid[5] = { 5, 1, 2, 3, 4 };
  return type == CellType::Tetrahedron ? tet[face] : (type == CellType::Wedge ? wedge[face] : pyramid[face]);
}

struct Block
{
  int id;
  std::string name;
  CellType type;
  std::vector<Id> cells;
};

/// A block a material and type. The first has the material's id and name, further ones are marked by type.
std::vector<Block> MakeBlocks(const lamina::SaveJob& job)
{
  std::vector<Block> blocks;
  const int step = job.materials.back() + 1;
  for (int material : job.materials)
  {
    int id = material;
    for (CellType type : lamina::AllTypes)
    {
      auto cells = lamina::CellsOf(job.model, material, type);
      if (!cells.empty())
      {
        const std::string& name = job.name.at(material);
        const bool isFirst = id == material;
        blocks.push_back(
          { id, isFirst ? name : name + (type == CellType::Wedge ? "_w" : "_p"), type, std::move(cells) });
        id += step;
      }
    }
  }
  return blocks;
}

/// A list of named things with ids: blocks, node sets, side sets.
void AddNamed(lamina::NetcdfFile& file, const std::string& kind, int count, int length,
              const std::vector<int>& ids, const std::vector<bool>& isFilled,
              const std::vector<std::string>& names)
{
  file.AddVariable(kind + "_status", { count }, lamina::NetcdfFile::Int,
                   [isFilled](Id i) { return isFilled[static_cast<std::size_t>(i)] ? 1 : 0; });
  file.AddVariable(
    kind + "_prop1", { count }, lamina::NetcdfFile::Int,
    [ids](Id i) { return ids[static_cast<std::size_t>(i)]; }, "name", "ID");
  file.AddStrings(kind + "_names", count, length, names);
}

/// A list of ids, from 1 in the file.
void AddIds(lamina::NetcdfFile& file, const std::string& name, int dimension, std::vector<Id> ids)
{
  file.AddVariable(name, { dimension }, lamina::NetcdfFile::Int,
                   [ids = std::move(ids)](Id i)
                   { return static_cast<double>(ids[static_cast<std::size_t>(i)] + 1); });
}

/// Connectivity and LayerIds of block number `number`, from 1.
void AddBlock(lamina::NetcdfFile& file, const lamina::SaveJob& job, const Block& block,
              const std::string& number, int nameLength)
{
  std::array<Id, 15> nodes;
  const int count = lamina::OrderedNodes(job.model, block.cells.front(), Edges(block.type), nodes);
  const int cells = file.AddDimension("num_el_in_blk" + number, static_cast<Id>(block.cells.size()));
  const int perCell = file.AddDimension("num_nod_per_el" + number, count);
  const int attributes = file.AddDimension("num_att_in_blk" + number, 1);
  const auto node = [&job, &block, count](Id i)
  {
    std::array<Id, 15> own;
    const Id cell = block.cells[static_cast<std::size_t>(i / count)];
    lamina::OrderedNodes(job.model, cell, Edges(block.type), own);
    return static_cast<double>(own[static_cast<std::size_t>(i % count)] + 1);
  };
  file.AddVariable("connect" + number, { cells, perCell }, lamina::NetcdfFile::Int, node, "elem_type",
                   TypeName(block.type, job.model.IsQuadratic()));
  file.AddVariable("attrib" + number, { cells, attributes }, lamina::NetcdfFile::Double,
                   [&job, &block](Id i)
                   {
                     const Id cell = block.cells[static_cast<std::size_t>(i)];
                     return job.model.mesh.layers[static_cast<std::size_t>(cell)];
                   });
  file.AddStrings("attrib_name" + number, attributes, nameLength, { lamina::names::LayerIds });
}

/// Nodes and sides of one set; nothing for an empty one, which its status tells.
void AddSet(lamina::NetcdfFile& file, const lamina::SaveJob& job, const lamina::SideSet& set,
            const std::string& number, const std::vector<Id>& elementOf)
{
  if (set.sides.empty())
  {
    return;
  }
  auto nodes = lamina::NodesOf(job.model, set);
  std::vector<Id> elements;
  std::vector<Id> sides;
  for (const lamina::Side& side : set.sides)
  {
    elements.push_back(elementOf[static_cast<std::size_t>(side.cell)]);
    sides.push_back(SideNumber(job.model.mesh.types[static_cast<std::size_t>(side.cell)], side.face) - 1);
  }
  const int nodeCount = file.AddDimension("num_nod_ns" + number, static_cast<Id>(nodes.size()));
  const int sideCount = file.AddDimension("num_side_ss" + number, static_cast<Id>(sides.size()));
  AddIds(file, "node_ns" + number, nodeCount, std::move(nodes));
  AddIds(file, "elem_ss" + number, sideCount, std::move(elements));
  AddIds(file, "side_ss" + number, sideCount, std::move(sides));
}

/// What the format demands of every file.
int AddHead(lamina::NetcdfFile& file, const lamina::MeshModel& model)
{
  using lamina::NetcdfFile;
  file.AddNumber("api_version", NetcdfFile::Float, 5.22);
  file.AddNumber("version", NetcdfFile::Float, 5.22);
  file.AddNumber("floating_point_word_size", NetcdfFile::Int, 8);
  file.AddNumber("file_size", NetcdfFile::Int, 1);
  file.AddNumber("maximum_name_length", NetcdfFile::Int, 32);
  file.AddNumber("int64_status", NetcdfFile::Int, 0);
  file.AddText("title", "Fluid-solid mesh by Lamina" +
                          (model.unit.empty() ? "" : ", lengths in " + model.unit.substr(0, 20)));
  file.AddDimension("len_string", 33);
  file.AddDimension("len_line", 81);
  file.AddDimension("four", 4);
  const int nameLength = file.AddDimension("len_name", 33);
  file.AddDimension("time_step", 0);
  const int space = file.AddDimension("num_dim", 3);
  const int nodes = file.AddDimension("num_nodes", static_cast<Id>(model.mesh.points.size()));
  for (int k = 0; k < 3; ++k)
  {
    file.AddVariable(
      std::string("coord") + "xyz" [k], { nodes }, NetcdfFile::Double,
      [&model, k](Id i) { return model.mesh.points[static_cast<std::size_t>(i)][k]; });
  }
  file.AddStrings("coor_names", space, nameLength, { "x", "y", "z" });
  return nameLength;
}

void AddBlocks(lamina::NetcdfFile& file, const lamina::SaveJob& job, const std::vector<Block>& blocks,
               int nameLength, std::vector<Id>& elementOf)
{
  const int cells = file.AddDimension("num_elem", job.model.mesh.CellCount());
  const int count = file.AddDimension("num_el_blk", static_cast<Id>(blocks.size()));
  std::vector<int> ids;
  std::vector<std::string> names;
  std::vector<Id> order;
  elementOf.assign(job.model.mesh.types.size(), 0);
  for (const Block& block : blocks)
  {
    ids.push_back(block.id);
    names.push_back(block.name);
    for (Id cell : block.cells)
    {
      elementOf[static_cast<std::size_t>(cell)] = static_cast<Id>(order.size());
      order.push_back(cell);
    }
  }
  AddNamed(file, "eb", count, nameLength, ids, std::vector<bool>(ids.size(), true), names);
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    AddBlock(file, job, blocks[b], std::to_string(b + 1), nameLength);
  }
  AddIds(file, "elem_num_map", cells, std::move(order));
}

void AddSets(lamina::NetcdfFile& file, const lamina::SaveJob& job, int nameLength,
             const std::vector<Id>& elementOf)
{
  if (job.sides.empty())
  {
    return;
  }
  std::vector<int> ids;
  std::vector<bool> isFilled;
  std::vector<std::string> names;
  for (const lamina::SideSet& set : job.sides)
  {
    ids.push_back(static_cast<int>(ids.size()) + 1);
    isFilled.push_back(!set.sides.empty());
    names.push_back(set.name);
  }
  const auto count = static_cast<Id>(ids.size());
  AddNamed(file, "ns", file.AddDimension("num_node_sets", count), nameLength, ids, isFilled, names);
  AddNamed(file, "ss", file.AddDimension("num_side_sets", count), nameLength, ids, isFilled, names);
  for (std::size_t s = 0; s < job.sides.size(); ++s)
  {
    AddSet(file, job, job.sides[s], std::to_string(s + 1), elementOf);
  }
}

} // namespace

lamina::FormatLimits vtkFluidSolidExodusWriter::Limits() const
{
  // Names have 32 characters, with room for the mark of further blocks.
  lamina::FormatLimits limits = lamina::LimitsOf("Exodus", lamina::LargestInt, 30);
  limits.holdsQuadratic = true;
  limits.holdsQuadraticPyramids = true;
  return limits;
}

void vtkFluidSolidExodusWriter::Save(lamina::SaveJob& job)
{
  const std::vector<Block> blocks = MakeBlocks(job);
  std::vector<Id> elementOf;
  lamina::NetcdfFile file;
  const int nameLength = AddHead(file, job.model);
  AddBlocks(file, job, blocks, nameLength, elementOf);
  AddSets(file, job, nameLength, elementOf);
  if (job.GoesOn(0.2, "Writing the file"))
  {
    job.Keep(file.Write(job.path));
  }
}
