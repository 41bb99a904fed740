// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshModelWriter.h"

#include "AlgorithmMonitor.h"
#include "ModelBridge.h"
#include "SaveJob.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

namespace
{

/// Fit the names of all sets to the format; the job's notes tell what changed.
void FitSets(const lamina::FormatLimits& limits, lamina::SaveJob& job)
{
  std::vector<std::string> names;
  for (int material : job.materials)
  {
    names.push_back(lamina::MaterialName(job.model.patches.materialNames, material));
  }
  for (const lamina::SideSet& set : job.sides)
  {
    names.push_back(set.name);
  }
  for (const lamina::LayerSet& set : job.layers)
  {
    names.push_back(set.name);
  }
  const auto fitted = lamina::FitNames(limits, names, job.notes);
  auto next = fitted.begin();
  for (int material : job.materials)
  {
    job.name[material] = *next++;
  }
  for (lamina::SideSet& set : job.sides)
  {
    set.name = *next++;
  }
  for (lamina::LayerSet& set : job.layers)
  {
    set.name = *next++;
  }
}

} // namespace

vtkMeshModelWriter::~vtkMeshModelWriter()
{
  this->SetFileName(nullptr);
}

int vtkMeshModelWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

void vtkMeshModelWriter::WriteData()
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  this->SetErrorCode(vtkErrorCode::NoError);
  lamina::AlgorithmMonitor monitor(this);
  const auto work = [&]() -> lamina::Status
  {
    if (!this->FileName || !*this->FileName)
    {
      return lamina::InvalidOption("no FileName: say where to write");
    }
    if (lamina::IsEmpty(grid))
    {
      return lamina::InvalidInput("there is nothing to write: the mesh is empty");
    }
    bool isFoundAnew = false;
    const auto model = lamina::ReadModel(grid, isFoundAnew, monitor);
    if (!model)
    {
      return model.GetError();
    }
    const lamina::FormatLimits limits = this->Limits();
    const auto fits = lamina::CheckFormat(limits, *model);
    if (!fits)
    {
      return fits.GetError();
    }
    lamina::SaveJob job{ this->FileName,
                         *model,
                         grid,
                         monitor,
                         lamina::SideSetsOf(*model),
                         lamina::LayerSetsOf(*model),
                         lamina::MaterialsOf(*model),
                         {},
                         {} };
    FitSets(limits, job);
    if (isFoundAnew)
    {
      job.notes.emplace_back(
        "the mesh has no patches of its own, or lost cells since they were named: they were "
        "found anew, and openings count as walls");
    }
    this->Save(job);
    for (const std::string& note : job.notes)
    {
      vtkWarningMacro(<< note);
    }
    return job.status;
  };
  if (lamina::RunStage(this, work) == 0 || monitor.Cancelled())
  {
    this->SetErrorCode(vtkErrorCode::UnknownError);
  }
}

void vtkMeshModelWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
