// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMReassignVoxelsProxy
 * @brief   the proxy of Reassign Voxels, whose commands change its list of edits
 *
 * Keep Edit, Remove Last Edit and Load Edits work on the filter's own list, as a selection can be worked out
 * only where the data are. State files, traces and undo hold the properties of the proxy. So this proxy
 * fetches the list back into its property Edits (and Shape) after each command, as one step of undo.
 */
#ifndef vtkSMReassignVoxelsProxy_h
#define vtkSMReassignVoxelsProxy_h

#include "LaminaServerManagerModule.h" // For the export macro
#include "vtkSMSourceProxy.h"

class LAMINASERVERMANAGER_EXPORT vtkSMReassignVoxelsProxy : public vtkSMSourceProxy
{
public:
  static vtkSMReassignVoxelsProxy* New();
  vtkTypeMacro(vtkSMReassignVoxelsProxy, vtkSMSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMReassignVoxelsProxy();
  ~vtkSMReassignVoxelsProxy() override;

private:
  vtkSMReassignVoxelsProxy(const vtkSMReassignVoxelsProxy&) = delete;
  void operator=(const vtkSMReassignVoxelsProxy&) = delete;

  void AfterUpdateOf(vtkObject* caller, unsigned long event, void* property);
  void FetchEdits();
};

#endif
