// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkReassignVoxels.h"

#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace
{

constexpr int Edge = 14;

vtkIdType Voxel(int i, int j, int k)
{
  return i + Edge * (j + Edge * k);
}

vtkSmartPointer<vtkReassignVoxels> Filter(vtkImageData* image)
{
  auto filter = vtkSmartPointer<vtkReassignVoxels>::New();
  filter->SetInputData(image);
  return filter;
}

vtkSmartPointer<vtkReassignVoxels> WithEdit(const char* json)
{
  auto filter = Filter(NestedBoxes(Edge));
  filter->AddEdit(json);
  return filter;
}

vtkSmartPointer<vtkSelection> Select(const std::vector<vtkIdType>& ids, int field = vtkSelectionNode::POINT)
{
  vtkNew<vtkIdTypeArray> list;
  for (const vtkIdType id : ids)
  {
    list->InsertNextValue(id);
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetFieldType(field);
  node->SetSelectionList(list);
  auto selection = vtkSmartPointer<vtkSelection>::New();
  selection->AddNode(node);
  return selection;
}

vtkImageData* Output(vtkReassignVoxels* filter)
{
  return vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
}

int Label(vtkReassignVoxels* filter, vtkIdType voxel)
{
  return vtkIntArray::SafeDownCast(Output(filter)->GetPointData()->GetArray("MaterialIds"))->GetValue(voxel);
}

vtkIdType Count(vtkReassignVoxels* filter, int material)
{
  auto* ids = vtkIntArray::SafeDownCast(Output(filter)->GetPointData()->GetArray("MaterialIds"));
  return std::count(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples(), material);
}

std::string WarningOf(vtkReassignVoxels* filter)
{
  Watch watch(filter);
  filter->Modified();
  filter->Update();
  EXPECT_FALSE(watch.GetError()) << watch.Error();
  return watch.GetWarning() ? watch.Warning() : std::string();
}

/// A command that fails with an error that has `part` in it, and adds no edit.
template<typename Command>
void ExpectRefused(vtkReassignVoxels* filter, const Command& command, const std::string& part)
{
  const int before = filter->GetNumberOfEdits();
  Watch watch(filter);
  EXPECT_FALSE(command()) << part;
  EXPECT_NE(watch.Error().find(part), std::string::npos) << watch.Error();
  EXPECT_EQ(filter->GetNumberOfEdits(), before);
}

/// A file that is gone at the end of the test.
struct File
{
  std::string name;
  explicit File(const std::string& content = {})
    : name(testing::TempDir() + "lamina-edits-" +
           testing::UnitTest::GetInstance()->current_test_info()->name() + ".json")
  {
    std::ofstream(this->name) << content;
  }
  ~File() { std::remove(this->name.c_str()); }
  std::string Content() const
  {
    std::ostringstream text;
    text << std::ifstream(this->name).rdbuf();
    return text.str();
  }
};

} // namespace

TEST(ReassignVoxels, WithoutEditsAllPassesThrough)
{
  auto image = NestedBoxes(Edge);
  auto filter = Filter(image);
  EXPECT_EQ(WarningOf(filter), "");
  auto* ids = vtkIntArray::SafeDownCast(Output(filter)->GetPointData()->GetScalars());
  ASSERT_TRUE(ids);
  EXPECT_STREQ(ids->GetName(), "MaterialIds");
  for (vtkIdType v = 0; v < ids->GetNumberOfTuples(); ++v)
  {
    ASSERT_EQ(ids->GetValue(v), image->GetPointData()->GetScalars()->GetComponent(v, 0));
  }
}

TEST(ReassignVoxels, EditsStackAndTheInputStays)
{
  auto image = NestedBoxes(Edge);
  vtkNew<vtkDoubleArray> other;
  other->SetName("Intensity");
  other->SetNumberOfTuples(image->GetNumberOfPoints());
  other->Fill(3);
  image->GetPointData()->AddArray(other);
  auto filter = Filter(image);
  const double bounds[6] = { 5, 8, 5, 8, 5, 6 };
  const double center[3] = { 2, 2, 2 };
  EXPECT_TRUE(filter->AddBox(bounds, 7));
  EXPECT_TRUE(filter->AddBox(bounds, 9, 2));
  EXPECT_TRUE(filter->AddSphere(center, 1.2, 3, 1));
  filter->RepairTopologyOff();
  EXPECT_NE(WarningOf(filter).find("edit 2 (box, to material 9) changes nothing: none of its 32 voxels"),
            std::string::npos);
  EXPECT_EQ(Count(filter, 7), 32);
  EXPECT_EQ(Count(filter, 3), 4) << "the corner of the tissue and its three neighbours in it";
  EXPECT_EQ(image->GetPointData()->GetScalars()->GetComponent(Voxel(5, 5, 5), 0), 2);
  EXPECT_TRUE(Output(filter)->GetPointData()->GetArray("Intensity"));
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(table->GetNumberOfRows(), 3);
  EXPECT_EQ(table->GetValueByName(0, "Step").ToString(), "edit 1");
  EXPECT_EQ(table->GetValueByName(2, "Shape").ToString(), "sphere");
  EXPECT_EQ(table->GetValueByName(2, "Material").ToInt(), 3);
  EXPECT_EQ(table->GetValueByName(2, "Covered").ToInt(), 7);
  EXPECT_EQ(table->GetValueByName(2, "Decided").ToInt(), 4);
  EXPECT_EQ(table->GetValueByName(0, "Changed").ToInt(), 32);
  EXPECT_NE(ReportOf(Output(filter), "ReassignVoxels").find("\"covered\": 7, \"decided\": 4"),
            std::string::npos);
  filter->RemoveLastEdit();
  filter->Update();
  EXPECT_EQ(Count(filter, 3), 0);
  filter->ClearEdits();
  EXPECT_EQ(filter->GetNumberOfEdits(), 0);
}

TEST(ReassignVoxels, TheCurrentEditComesLastAndCanBeKept)
{
  auto filter = Filter(NestedBoxes(Edge));
  filter->SetShape(vtkReassignVoxels::Box);
  filter->SetBounds(5, 8, 5, 8, 5, 6);
  filter->SetToMaterial(7);
  filter->AddFromMaterial(2);
  EXPECT_EQ(WarningOf(filter), "");
  EXPECT_EQ(Count(filter, 7), 32);
  EXPECT_TRUE(filter->KeepEdit());
  EXPECT_EQ(filter->GetShape(), vtkReassignVoxels::None);
  EXPECT_EQ(WarningOf(filter), "");
  EXPECT_EQ(Count(filter, 7), 32);
  EXPECT_STREQ(filter->GetEdit(0), R"({"bounds":[5.0,8.0,5.0,8.0,5.0,6.0],"from":[2],"shape":"box","to":7})");
  filter->SetShape(vtkReassignVoxels::Sphere);
  filter->SetCenter(7, 7, 7);
  filter->SetRadius(0.5);
  filter->SetToMaterial(8);
  filter->RepairTopologyOff();
  EXPECT_EQ(WarningOf(filter), "");
  EXPECT_EQ(Count(filter, 8), 1);
  EXPECT_TRUE(filter->KeepEdit());
  EXPECT_EQ(filter->GetNumberOfEdits(), 2);
  ExpectRefused(
    filter, [&] { return filter->KeepEdit(); }, "the current edit is 0: choose");
}

TEST(ReassignVoxels, Selections)
{
  auto filter = Filter(NestedBoxes(Edge));
  filter->RepairTopologyOff();
  filter->SetToMaterial(4);
  filter->SetInputData(1, Select({ Voxel(3, 3, 3), Voxel(10, 3, 3) }));
  EXPECT_EQ(WarningOf(filter), "");
  EXPECT_EQ(Count(filter, 4), 2);
  EXPECT_EQ(Label(filter, Voxel(10, 3, 3)), 4);
  EXPECT_TRUE(filter->KeepEdit());
  filter->SetInputData(1, nullptr);
  EXPECT_EQ(WarningOf(filter), "");
  EXPECT_EQ(Count(filter, 4), 2);

  EXPECT_TRUE(filter->AddSelection(Select({ 0 }, vtkSelectionNode::CELL), 5));
  EXPECT_EQ(WarningOf(filter), "");
  EXPECT_EQ(Count(filter, 5), 8) << "a cell is its eight corners";

  auto inverse = Select({ Voxel(0, 0, 0) });
  inverse->GetNode(0)->GetProperties()->Set(vtkSelectionNode::INVERSE(), 1);
  EXPECT_TRUE(filter->AddSelection(inverse, 6));
  EXPECT_EQ(WarningOf(filter), "");
  EXPECT_EQ(Count(filter, 6), Edge * Edge * Edge - 1);

  filter->ClearEdits();
  vtkNew<vtkSelection> nothing;
  filter->SetShape(vtkReassignVoxels::Selection);
  filter->SetInputData(1, nothing);
  EXPECT_NE(WarningOf(filter).find("has no voxels"), std::string::npos);
  ExpectRefused(
    filter, [&] { return filter->KeepEdit(); }, "has no voxels: select some");
}

TEST(ReassignVoxels, SelectionsThatDoNotFit)
{
  auto filter = Filter(NestedBoxes(Edge));
  filter->SetInputData(1, Select({ 5, 2744, -1 }));
  ExpectError(filter, "the selection has 2 of 3 ids outside the image, whose points are 0 to 2743");
  filter->SetInputData(1, Select({ 2197 }, vtkSelectionNode::CELL));
  ExpectError(filter, "1 of 1 ids outside the image, whose cells are 0 to 2196");
  filter->SetInputData(1, Select({ 1 }, vtkSelectionNode::ROW));
  ExpectError(filter, "select points (or cells) of the image");
  auto both = Select({ 1 });
  both->AddNode(Select({ 1 }, vtkSelectionNode::CELL)->GetNode(0));
  filter->SetInputData(1, both);
  ExpectError(filter, "the selection cannot be worked out");
  ExpectRefused(
    filter, [&] { return filter->AddSelection(Select({ 5000 }), 1); }, "1 of 1 ids outside");
  vtkNew<vtkReassignVoxels> alone;
  ExpectRefused(
    alone, [&] { return alone->AddSelection(Select({ 1 }), 1); }, "connect the image first");
  ExpectRefused(
    alone, [&] { return alone->KeepEdit(); }, "connect the image first");
}

TEST(ReassignVoxels, ListsOfVoxels)
{
  auto filter = Filter(NestedBoxes(Edge));
  vtkNew<vtkIdTypeArray> ids;
  for (const vtkIdType id : { 100, 102, 101, 700 })
  {
    ids->InsertNextValue(id);
  }
  EXPECT_TRUE(filter->AddVoxels(ids, 1));
  EXPECT_STREQ(filter->GetEdit(0),
               R"({"dimensions":[14,14,14],"ids":[[100,102],700],"shape":"voxels","to":1})");
  EXPECT_EQ(filter->GetEdits()->GetNumberOfValues(), 1);
  ids->InsertNextValue(99999);
  ExpectRefused(
    filter, [&] { return filter->AddVoxels(ids, 1); }, "1 of 5 voxel ids are outside the image");
  filter->SetInputData(NestedBoxes(16));
  ExpectError(filter,
              "edit 1: its voxels were picked in an image of 14 x 14 x 14 voxels, this one has 16 x 16 x 16");
}

TEST(ReassignVoxels, DisputedIsClearedByDecisions)
{
  auto image = NestedBoxes(Edge);
  vtkNew<vtkUnsignedCharArray> disputed;
  disputed->SetName("Disputed");
  disputed->SetNumberOfTuples(image->GetNumberOfPoints());
  disputed->Fill(0);
  disputed->SetValue(Voxel(3, 3, 3), 1);
  disputed->SetValue(Voxel(9, 9, 9), 1);
  image->GetPointData()->AddArray(disputed);
  auto filter = Filter(image);
  const double center[3] = { 3, 3, 3 };
  filter->AddSphere(center, 0.5, 1);
  WarningOf(filter);
  auto* after = vtkUnsignedCharArray::SafeDownCast(Output(filter)->GetPointData()->GetArray("Disputed"));
  ASSERT_TRUE(after);
  EXPECT_EQ(after->GetValue(Voxel(3, 3, 3)), 0) << "said to be tissue, as it was";
  EXPECT_EQ(after->GetValue(Voxel(9, 9, 9)), 1);
  EXPECT_EQ(disputed->GetValue(Voxel(3, 3, 3)), 1) << "the input stays";
}

TEST(ReassignVoxels, TheTopologyIsRepaired)
{
  // Two voxels of blood that touch over an edge, in background.
  auto filter = WithEdit(R"({"shape": "voxels", "ids": [0, 15], "to": 2})");
  WarningOf(filter);
  EXPECT_GT(Count(filter, 2), 64 + 2 - 1);
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(table->GetNumberOfRows(), 3);
  EXPECT_EQ(table->GetValueByName(1, "Step").ToString(), "repair");
  EXPECT_GT(table->GetValueByName(1, "Changed").ToInt(), 0);
  filter->RepairTopologyOff();
  filter->Update();
  EXPECT_EQ(Count(filter, 2), 66);
  EXPECT_EQ(vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfRows(), 1);
}

TEST(ReassignVoxels, ForbiddenContacts)
{
  auto filter = Filter(NestedBoxes(Edge));
  filter->AddForbiddenContact(0, 2);
  int pair[2];
  filter->GetForbiddenContact(0, pair);
  EXPECT_EQ(pair[1], 2);
  // The wall is two to three voxels thick: blood through all of it.
  const double bounds[6] = { 6, 7, 6, 7, 1.5, 5 };
  filter->AddBox(bounds, 2);
  WarningOf(filter);
  EXPECT_EQ(Label(filter, Voxel(6, 6, 2)), 2);
  EXPECT_EQ(Label(filter, Voxel(6, 6, 1)), 1) << "background that touched blood is tissue";
  EXPECT_EQ(Label(filter, Voxel(5, 5, 1)), 1);
  filter->ClearForbiddenContacts();
  filter->Update();
  EXPECT_EQ(Label(filter, Voxel(6, 6, 1)), 0);
  filter->AddForbiddenContact(3, 3);
  ExpectError(filter, "the forbidden contact of materials 3 and 3");
}

TEST(ReassignVoxels, EditsThatAreNone)
{
  ExpectError(WithEdit("{\"shape\": \"box\",\n \"to\" 3}"),
              "edit 1 is not JSON: parse error at line 2, column 7");
  ExpectError(WithEdit(""), "edit 1 is not JSON: parse error at line 1, column 1");
  ExpectError(WithEdit("[]"), "edit 1: an edit is an object");
  ExpectError(WithEdit(R"({"to": 2})"), R"("shape" is missing)");
  ExpectError(WithEdit(R"({"shape": "cone", "to": 2})"),
              R"(the shape "cone" is not known; there are box, sphere and voxels)");
  ExpectError(WithEdit(R"({"shape": 3, "to": 2})"), "the shape 3 is not known");
  ExpectError(WithEdit(R"({"shape": "box", "to": 2})"), R"("bounds" is missing)");
  ExpectError(WithEdit(R"({"shape": "box", "bounds": [1, 2], "to": 2})"),
              R"("bounds" must be a list of 6 numbers)");
  ExpectError(WithEdit(R"({"shape": "box", "bounds": [1, 2, 1, 2, 1, "a"], "to": 2})"),
              R"(must be made of numbers, not "a")");
  ExpectError(WithEdit(R"({"shape": "box", "bounds": [2, 1, 1, 2, 1, 2], "to": 2})"),
              "edit 1: the box is empty, along x");
  ExpectError(WithEdit(R"({"shape": "sphere", "center": [1, 2, 3], "radius": -1, "to": 2})"),
              "has the radius -1");
  ExpectError(WithEdit(R"({"shape": "sphere", "centre": [1, 2, 3], "radius": 1, "to": 2})"),
              R"("centre" is not known; this shape has shape, from, to, center, radius)");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [1], "to": 65536})"), R"("to" names material 65536)");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [1], "to": -1})"), R"("to" names material -1)");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [1], "to": 1.5})"),
              "must be made of whole numbers, not 1.5");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [1], "to": 1, "from": 2})"), R"("from" must be a list)");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [1], "to": 1, "from": [70000]})"),
              R"("from" names material 70000)");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [[3, 2]], "to": 1})"),
              "the run [3,2]: give its first id first");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [[1, 2, 3]], "to": 1})"),
              "ids and of runs [first, last]");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [18446744073709551615], "to": 1})"),
              "must be made of whole numbers");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [[0, 9000000000000]], "to": 1})"),
              R"("ids" has more ids than)");
  ExpectError(WithEdit(R"({"shape": "voxels", "ids": [-1, 3, 2744], "to": 1})"),
              "2 of 3 voxel ids are outside the image");
  ExpectError(WithEdit(R"({"shape": "voxels", "dimensions": [0, 1, 1], "ids": [], "to": 1})"),
              "above 0, not [0,1,1]");
  auto second = WithEdit(R"({"shape": "sphere", "center": [7, 7, 7], "radius": 1, "to": 2})");
  second->AddEdit("{");
  ExpectError(second, "edit 2 is not JSON");
}

TEST(ReassignVoxels, CurrentEditsThatAreNone)
{
  auto filter = Filter(NestedBoxes(Edge));
  filter->SetShape(9);
  ExpectError(filter, "the shape of the current edit is 9");
  filter->SetShape(vtkReassignVoxels::Box);
  filter->SetBounds(1, 1, 0, 1, 0, 1);
  ExpectError(filter, "the current edit: the box is empty, along x");
  filter->SetShape(vtkReassignVoxels::Sphere);
  filter->SetRadius(0);
  ExpectError(filter, "the current edit: the sphere");
  filter->SetRadius(1);
  filter->SetToMaterial(65536);
  ExpectError(filter, "the material to give is 65536");
  filter->SetToMaterial(1);
  filter->AddFromMaterial(-4);
  ExpectError(filter, "restricted to material -4");
  const double bounds[6] = { 1, 0, 0, 1, 0, 1 };
  const double center[3] = { 0, 0, 0 };
  ExpectRefused(
    filter, [&] { return filter->AddBox(bounds, 1); }, "the new edit: the box is empty");
  ExpectRefused(
    filter, [&] { return filter->AddSphere(center, -1, 1); }, "the radius -1");
  ExpectRefused(
    filter, [&] { return filter->AddSphere(center, 1, -1); }, "the material to give is -1");
}

TEST(ReassignVoxels, FilesHoldEdits)
{
  File file;
  auto filter = Filter(NestedBoxes(Edge));
  const double center[3] = { 7, 7, 1.0 / 3.0 };
  filter->AddSphere(center, 2.5, 1, 0);
  filter->AddSelection(Select({ 1, 2, 3, 50 }), 2);
  filter->SetFileName(file.name.c_str());
  EXPECT_TRUE(filter->SaveEdits());
  WarningOf(filter);
  auto again = Filter(NestedBoxes(Edge));
  again->AddEdit("is replaced");
  again->SetFileName(file.name.c_str());
  EXPECT_TRUE(again->LoadEdits());
  ASSERT_EQ(again->GetNumberOfEdits(), 2);
  WarningOf(again);
  for (int e = 0; e < 2; ++e)
  {
    EXPECT_STREQ(again->GetEdit(e), filter->GetEdit(e));
  }
  for (vtkIdType v = 0; v < Edge * Edge * Edge; ++v)
  {
    ASSERT_EQ(Label(again, v), Label(filter, v));
  }
}

TEST(ReassignVoxels, FilesThatHoldNone)
{
  auto filter = WithEdit(R"({"shape": "voxels", "ids": [1], "to": 1})");
  const auto load = [&] { return filter->LoadEdits(); };
  ExpectRefused(filter, load, "no file name is given");
  ExpectRefused(
    filter, [&] { return filter->SaveEdits(); }, "no file name is given");
  filter->SetFileName((testing::TempDir() + "no-such-folder/edits.json").c_str());
  ExpectRefused(filter, load, "cannot be read");
  ExpectRefused(
    filter, [&] { return filter->SaveEdits(); }, "cannot be written");
  filter->SetFileName(testing::TempDir().c_str());
  ExpectRefused(filter, load, "cannot be read");
  ExpectRefused(
    filter, [&] { return filter->SaveEdits(); }, "cannot be written");
  const std::pair<const char*, const char*> wrong[] = {
    { "", "cannot be read" },
    { "{\n\"format\": \"Lamina voxel edits\",\n\"version\" 1}",
      "is not JSON: parse error at line 3, column 11" },
    { "[]", "holds no edits" },
    { R"({"format": "something else", "version": 1, "edits": []})", "holds no edits" },
    { R"({"format": "Lamina voxel edits", "version": 2, "edits": []})", R"("version": 1)" },
    { R"({"format": "Lamina voxel edits", "version": 1, "edits": 3})", R"(a list "edits")" },
    { R"({"format": "Lamina voxel edits", "version": 1, "edits": [{"shape": "voxels", "ids": [], "to": 1}, {"shape": "cone"}]})",
      ", edit 2: the shape \"cone\" is not known" },
  };
  for (const auto& content : wrong)
  {
    File file(content.first);
    filter->SetFileName(file.name.c_str());
    ExpectRefused(filter, load, content.second);
  }
  File kept("as it was");
  filter->SetFileName(kept.name.c_str());
  filter->AddEdit("broken");
  ExpectRefused(
    filter, [&] { return filter->SaveEdits(); }, "edit 2 is not JSON");
  EXPECT_EQ(kept.Content(), "as it was");
}

TEST(ReassignVoxels, WrongImages)
{
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 4);
  ExpectError(Filter(bare),
              "no array on its points: run Multimaterial Segmentation first, which makes MaterialIds");
  auto grey = NestedBoxes(Edge);
  grey->GetPointData()->GetScalars()->SetComponent(0, 0, 70000);
  ExpectError(Filter(grey), "material ids are whole numbers from 0 to 65535");
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(4, 4, 1);
  flat->AllocateScalars(VTK_INT, 1);
  ExpectError(Filter(flat), "a 3-D image is needed");
  vtkNew<vtkImageData> nothing;
  auto filter = Filter(nothing);
  ExpectFine(filter);
  EXPECT_EQ(Output(filter)->GetNumberOfPoints(), 0);
}

TEST(ReassignVoxels, ExtentsThatStartElsewhere)
{
  auto image = NestedBoxes(Edge);
  image->SetExtent(5, 18, -3, 10, 2, 15);
  image->SetOrigin(10, 20, 30);
  image->SetSpacing(0.5, 0.5, 0.5);
  auto filter = Filter(image);
  filter->RepairTopologyOff();
  const double center[3] = { 10 + 0.5 * 6, 20 + 0.5 * -2, 30 + 0.5 * 3 };
  EXPECT_TRUE(filter->AddSphere(center, 0.1, 9));
  EXPECT_EQ(WarningOf(filter), "");
  EXPECT_EQ(Count(filter, 9), 1);
  EXPECT_EQ(Label(filter, Voxel(1, 1, 1)), 9);
  EXPECT_TRUE(filter->AddSelection(Select({ Voxel(2, 2, 2) }), 9));
  EXPECT_TRUE(filter->AddSelection(Select({ 0 }, vtkSelectionNode::CELL), 8));
  EXPECT_EQ(WarningOf(filter), "");
  EXPECT_EQ(Label(filter, Voxel(2, 2, 2)), 9);
  EXPECT_EQ(Label(filter, Voxel(1, 1, 1)), 8);
  EXPECT_EQ(Count(filter, 8), 8);
}
