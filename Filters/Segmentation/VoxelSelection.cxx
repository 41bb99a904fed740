// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelSelection.h"

#include <vtkAlgorithmOutput.h>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>

#include <string>

#if VTK_MODULE_ENABLE_ParaView_VTKExtensionsExtraction
#include <vtkPVExtractSelection.h>
using Extraction = vtkPVExtractSelection; // knows the queries of ParaView's Find Data as well
#else
#include <vtkExtractSelection.h>
using Extraction = vtkExtractSelection;
#endif

namespace lamina
{

namespace
{

/// Made by the extraction: 1 where a point or cell is selected.
constexpr const char* Insidedness = "vtkInsidedness";

/// Ids beyond the image are passed over by the extraction without a word.
Result<bool> CheckNode(vtkImageData* image, vtkSelectionNode* node)
{
  const int field = node->GetFieldType();
  if (field != vtkSelectionNode::POINT && field != vtkSelectionNode::CELL)
  {
    return InvalidInput(std::string("the selection is of ") + vtkSelectionNode::GetFieldTypeAsString(field) +
                        ": select points (or cells) of the image");
  }
  vtkDataArray* ids = vtkDataArray::SafeDownCast(node->GetSelectionList());
  if (node->GetContentType() != vtkSelectionNode::INDICES || !ids)
  {
    return true;
  }
  const bool points = field == vtkSelectionNode::POINT;
  const vtkIdType count = points ? image->GetNumberOfPoints() : image->GetNumberOfCells();
  vtkIdType outside = 0;
  for (vtkIdType t = 0; t < ids->GetNumberOfTuples(); ++t)
  {
    const double id = ids->GetComponent(t, 0);
    outside += id >= 0 && id < static_cast<double>(count) ? 0 : 1;
  }
  if (outside > 0)
  {
    return InvalidInput("the selection has " + std::to_string(outside) + " of " +
                        std::to_string(ids->GetNumberOfTuples()) + " ids outside the image, whose " +
                        (points ? "points" : "cells") + " are 0 to " + std::to_string(count - 1) +
                        ": select on the image itself, not on a slice or surface of it");
  }
  return true;
}

void KeepMessage(vtkObject*, unsigned long, void* client, void* message)
{
  auto& kept = *static_cast<std::string*>(client);
  if (kept.empty() && message)
  {
    kept = static_cast<const char*>(message);
  }
}

/// Which points, or which cells, are selected: an array on the output of `extract`.
Result<vtkDataSet*> Evaluate(vtkImageData* image, vtkSelection* selection, Extraction* extract)
{
  std::string message;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(KeepMessage);
  keep->SetClientData(&message);
  extract->AddObserver(vtkCommand::ErrorEvent, keep);
  extract->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, keep);
  extract->PreserveTopologyOn();
  extract->SetInputData(0, image);
  extract->SetInputData(1, selection);
  extract->Update();
  if (!message.empty())
  {
    return InvalidInput("the selection cannot be worked out on the image: " + message);
  }
  return vtkDataSet::SafeDownCast(extract->GetOutputDataObject(0));
}

/// Mark the eight corners of cell `cell`.
void MarkCorners(vtkImageData* image, vtkIdType cell, std::vector<unsigned char>& marks)
{
  int size[3];
  image->GetDimensions(size);
  const vtkIdType nx = size[0];
  const vtkIdType ny = size[1];
  const vtkIdType i = cell % (nx - 1);
  const vtkIdType j = cell / (nx - 1) % (ny - 1);
  const vtkIdType k = cell / ((nx - 1) * (ny - 1));
  for (vtkIdType q = 0; q < 8; ++q)
  {
    const vtkIdType point = i + (q & 1) + nx * (j + ((q >> 1) & 1) + ny * (k + (q >> 2)));
    marks[static_cast<std::size_t>(point)] = 1;
  }
}

} // namespace

Result<std::vector<Id>> SelectedVoxels(vtkImageData* image, vtkSelection* selection)
{
  std::vector<Id> ids;
  if (!selection || selection->GetNumberOfNodes() == 0)
  {
    return ids;
  }
  for (unsigned int n = 0; n < selection->GetNumberOfNodes(); ++n)
  {
    if (const Result<bool> good = CheckNode(image, selection->GetNode(n)); !good)
    {
      return good.GetError();
    }
  }
  vtkNew<Extraction> extract;
  const Result<vtkDataSet*> inside = Evaluate(image, selection, extract);
  if (!inside)
  {
    return inside.GetError();
  }
  vtkDataArray* points = *inside ? (*inside)->GetPointData()->GetArray(Insidedness) : nullptr;
  vtkDataArray* cells = *inside ? (*inside)->GetCellData()->GetArray(Insidedness) : nullptr;
  if (!points && !cells)
  {
    return InvalidInput("the selection cannot be worked out on the image: its kind is not supported");
  }
  std::vector<unsigned char> marks(static_cast<std::size_t>(image->GetNumberOfPoints()), 0);
  for (vtkIdType p = 0; points && p < points->GetNumberOfTuples(); ++p)
  {
    marks[static_cast<std::size_t>(p)] = points->GetComponent(p, 0) > 0 ? 1 : 0;
  }
  for (vtkIdType c = 0; cells && c < cells->GetNumberOfTuples(); ++c)
  {
    if (cells->GetComponent(c, 0) > 0)
    {
      MarkCorners(image, c, marks);
    }
  }
  for (std::size_t v = 0; v < marks.size(); ++v)
  {
    if (marks[v])
    {
      ids.push_back(static_cast<Id>(v));
    }
  }
  return ids;
}

} // namespace lamina
