// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMReassignVoxelsProxy.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMTrace.h"
#include "vtkSMUndoStackBuilder.h"

#include <string>

vtkStandardNewMacro(vtkSMReassignVoxelsProxy);

namespace
{

// As in the proxy's XML.
constexpr int ShapeNone = 0;
constexpr int ShapeSelection = 1;

/// The commands that change the list on the server.
bool ChangesEdits(const std::string& command)
{
  return command == "KeepEdit" || command == "RemoveLastEdit" || command == "LoadEdits";
}

} // namespace

vtkSMReassignVoxelsProxy::vtkSMReassignVoxelsProxy()
{
  this->AddObserver(vtkCommand::UpdatePropertyEvent, this, &vtkSMReassignVoxelsProxy::AfterUpdateOf);
}

vtkSMReassignVoxelsProxy::~vtkSMReassignVoxelsProxy() = default;

void vtkSMReassignVoxelsProxy::AfterUpdateOf(vtkObject*, unsigned long, void* property)
{
  const char* name = static_cast<const char*>(property);
  if (name && ChangesEdits(name))
  {
    vtkSMUndoStackBuilder* undo = vtkSMProxyManager::GetProxyManager()->GetUndoStackBuilder();
    if (undo)
    {
      undo->Begin(name);
    }
    this->FetchEdits();
    if (undo)
    {
      undo->End();
      undo->PushToStack();
    }
  }
}

void vtkSMReassignVoxelsProxy::FetchEdits()
{
  this->UpdatePropertyInformation();
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this);
  const bool wasOfSelection = vtkSMPropertyHelper(this, "Shape").GetAsInt() == ShapeSelection;
  for (const char* name : { "Edits", "Shape" })
  {
    vtkSMProperty* property = this->GetProperty(name);
    vtkSMProperty* held = this->GetProperty((std::string(name) + "Held").c_str());
    if (property && held)
    {
      property->Copy(held);
    }
  }
  if (wasOfSelection && vtkSMPropertyHelper(this, "Shape").GetAsInt() == ShapeNone)
  {
    // It is kept as a list of voxels; and ParaView has no name for selections in scripts and Python states.
    vtkSMPropertyHelper(this, "Selection").RemoveAllValues();
  }
  this->UpdateVTKObjects();
}

void vtkSMReassignVoxelsProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
