// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FormatLimits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace lamina;

namespace
{

/// A wedge of 2 on a tetrahedron of 1, with its patches.
MeshModel MakeModel()
{
  MeshModel model;
  VolumeMesh& mesh = model.mesh;
  mesh.points = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 },     { 0, 0, 1 },
                  { 0, 1, 1 }, { 1, 0, 1 }, { 0.2, 0.2, -1 } };
  mesh.AddCell(CellType::Wedge, std::array<Id, 6>{ { 0, 1, 2, 3, 4, 5 } }, 2, 3);
  mesh.AddCell(CellType::Tetrahedron, std::array<Id, 4>{ { 0, 1, 2, 6 } }, 1, 0);
  ThreadMonitor monitor;
  EXPECT_TRUE(FindPatches(mesh, nullptr, {}, model.patches, monitor));
  return model;
}

FormatLimits Short(std::size_t length)
{
  FormatLimits limits;
  limits.format = "Format";
  limits.nameLength = length;
  return limits;
}

} // namespace

TEST(MeshModel, SetsOfSidesNodesAndLayers)
{
  MeshModel model = MakeModel();
  const auto sets = SideSetsOf(model);
  ASSERT_EQ(sets.size(), 3u);
  EXPECT_EQ(sets[0].name, "interface_1_2_1");
  EXPECT_EQ(NodesOf(model, sets[0]), (std::vector<Id>{ 0, 1, 2 }));
  EXPECT_EQ(NodesOf(model, sets[2]).size(), 6u);
  const auto layers = LayerSetsOf(model);
  ASSERT_EQ(layers.size(), 1u);
  EXPECT_EQ(layers[0].name, "layer_2_3");
  EXPECT_EQ(MaterialsOf(model), (std::vector<int>{ 1, 2 }));
}

TEST(MeshModel, AMaterialAloneKeepsItsBoundary)
{
  const MeshModel model = MakeModel();
  std::vector<Id> nodes;
  const MeshModel fluid = TakeMaterial(model, 2, nodes);
  EXPECT_EQ(fluid.mesh.CellCount(), 1);
  EXPECT_EQ(nodes, (std::vector<Id>{ 0, 1, 2, 3, 4, 5 }));
  ASSERT_EQ(fluid.patches.patches.size(), 2u);
  EXPECT_EQ(fluid.patches.patches[0].pair, (MaterialPair{ 2, 1 }));
  EXPECT_EQ(fluid.patches.faces.size(), 5u);
  for (const PatchFace& face : fluid.patches.faces)
  {
    EXPECT_EQ(face.cell, 0);
  }
}

TEST(FormatLimits, TwoToTheThirtyOne)
{
  FormatLimits limits = Short(0);
  limits.largestId = 2147483647;
  EXPECT_TRUE(CheckCount(limits, 2147483647, "nodes"));
  const auto refused = CheckCount(limits, Id{ 2147483648 }, "nodes");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.GetError().message.find("2147483648 nodes, but Format can number 2147483647"),
            std::string::npos);
  limits.largestId = 6; // the model has seven nodes
  EXPECT_FALSE(CheckFormat(limits, MakeModel()));
}

TEST(FormatLimits, CellsThatAFormatLacks)
{
  FormatLimits limits = Short(0);
  EXPECT_TRUE(CheckFormat(limits, MakeModel()));
  limits.holdsWedges = false;
  const auto refused = CheckFormat(limits, MakeModel());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.GetError().message,
            "Format cannot hold the mesh's 1 prisms: run Prisms to Tetrahedra first");
}

TEST(FormatLimits, NamesAreShortenedStablyAndTold)
{
  std::vector<std::string> notes;
  const std::string wall(100, 'w');
  const auto alone = FitNames(Short(20), { wall + "1" }, notes);
  EXPECT_EQ(notes.size(), 1u);
  const auto among =
    FitNames(Short(20), { "blood", wall + "2", wall + "1", "left wall", "left_wall" }, notes);
  EXPECT_EQ(among[2], alone[0]); // the same whatever stands beside it
  EXPECT_EQ(among[0], "blood");
  EXPECT_EQ(among[3], "left_wall");
  EXPECT_NE(among[4], "left_wall");
  EXPECT_EQ(std::set<std::string>(among.begin(), among.end()).size(), 5u);
  for (const std::string& name : among)
  {
    EXPECT_LE(name.size(), 20u);
  }
  EXPECT_EQ(FitNames(Short(0), { "1st", "" }, notes)[0], "n_1st");
  FormatLimits folded = Short(0);
  folded.ignoresCase = true;
  const auto cases = FitNames(folded, { "Wall", "WALL" }, notes);
  EXPECT_EQ(cases[0], "Wall");
  EXPECT_NE(cases[1], "WALL");
}
