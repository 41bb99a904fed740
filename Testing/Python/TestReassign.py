# SPDX-License-Identifier: BSD-3-Clause
"""Reassign Voxels in ParaView's own terms: selections become edits; properties, state files, scripts, undo and files hold them.

    xvfb-run -a pvpython TestReassign.py SCRATCH_FOLDER
"""
import json
import pathlib
import subprocess
import sys

import numpy as np

import tiny
from paraview import servermanager, simple, smstate, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy

EDGE = 24


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def labels(proxy):
    proxy.UpdatePipeline()
    image = servermanager.Fetch(proxy)
    return vtk_to_numpy(image.GetPointData().GetArray("MaterialIds")).copy()


def image_file(folder):
    """The nested spheres as a file, so that a state file can find the image again."""
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(folder / "spheres.vti"))
    writer.SetInputData(tiny.nested_spheres(EDGE))
    writer.Write()
    return str(folder / "spheres.vti")


def point(i, j, k):
    return i + EDGE * (j + EDGE * k)


def block(low, high):
    """Ids of a box of voxels, both ends included."""
    return [point(i, j, k) for k in range(low, high + 1) for j in range(low, high + 1) for i in range(low, high + 1)]


def check_selections(image, before):
    """Ids, a query, a frustum of the whole, and cells: each gives what it names."""
    centre = block(10, 13)
    ids = simple.IDSelectionSource(FieldType="POINT", IDs=[x for v in centre for x in (0, v)])
    by_ids = simple.ReassignVoxels(Input=image, Selection=ids, ToMaterial=5)
    after = labels(by_ids)
    check((after[centre] == 5).all() and (np.delete(after, centre) == np.delete(before, centre)).all(), "selected ids")

    def selected(**shape):
        """The image with what is selected on it now, as Copy Active Selection hands it over."""
        selection = servermanager._getPyProxy(image.SMProxy.GetSelectionInput(0))
        filtered = simple.ReassignVoxels(Input=image, Selection=selection, RepairTopology=0, **shape)
        result = labels(filtered)
        simple.Delete(filtered)
        simple.ClearSelection(image)
        return result

    simple.QuerySelect(QueryString="MaterialIds == 2", FieldType="POINT", Source=image)
    check(((selected(ToMaterial=7) == 7) == (before == 2)).all(), "a query of a material")
    simple.SelectThresholds(Thresholds=[1, 2], ArrayName="MaterialIds", FieldType="POINT", Source=image)
    check(((selected(ToMaterial=7) == 7) == (before > 0)).all(), "a threshold")
    simple.SelectLocation(Locations=[6.0, 6.0, 6.0], Source=image)
    check(list(np.flatnonzero(selected(ToMaterial=11) == 11)) == [point(12, 12, 12)], "a location")
    simple.SelectIDs(IDs=[0, point(3, 4, 5), 0, point(7, 7, 7)], FieldType="POINT", Source=image)
    check(list(np.flatnonzero(selected(ToMaterial=11) == 11)) == [point(3, 4, 5), point(7, 7, 7)], "picked ids")
    cell = 10 + (EDGE - 1) * (10 + (EDGE - 1) * 10)
    simple.SelectIDs(IDs=[0, cell], FieldType="CELL", Source=image)
    check(list(np.flatnonzero(selected(ToMaterial=9) == 9)) == block(10, 11), "a selected cell is its eight corners")
    check_frustum(image, selected)
    return centre, ids


def check_frustum(image, selected):
    """A rubber band over the left half of the view, through the whole image."""
    view = simple.GetActiveView()
    view.CameraParallelProjection = 1
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [5.75, 5.75, 60], [5.75, 5.75, 5.75], [0, 1, 0]
    view.CameraParallelScale = 8
    simple.Render(view)
    width, height = view.ViewSize
    simple.SelectPointsThrough(Rectangle=[0, 0, width // 2, height - 1], View=view)
    chosen = selected(ToMaterial=13).reshape(EDGE, EDGE, EDGE) == 13
    check(chosen[:, :, :12].all() and not chosen[:, :, 12:].any(), f"a frustum: {chosen.sum()} voxels")


def check_keep(image, ids, centre, before):
    """Keep Edit turns the selection into an edit, on the proxy and in the filter, that outlives the selection."""
    edited = simple.ReassignVoxels(Input=image, Selection=ids, ToMaterial=5)
    wanted = labels(edited)
    edited.InvokeCommand("KeepEdit")
    check(len(edited.Edits) == 1 and edited.Shape == "None", f"the kept edit is a property: {edited.Edits}, {edited.Shape}")
    check(edited.Selection is None, "the selection is no longer needed")
    kept = json.loads(edited.Edits[0])
    check(kept["dimensions"] == [EDGE] * 3 and kept["to"] == 5, f"what is kept: {kept}")
    ids.IDs = [0, 0]
    check((labels(edited) == wanted).all(), "a kept edit does not follow the selection")
    edited.Shape, edited.Center, edited.Radius, edited.ToMaterial = "Sphere", [1.5, 6.0, 6.0], 1.1, 2
    edited.UpdatePipeline()
    edited.InvokeCommand("KeepEdit")
    edited.Shape, edited.Bounds, edited.ToMaterial, edited.FromMaterials = "Box", [8, 10, 8, 10, 8, 10], 3, [0]
    edited.UpdatePipeline()
    edited.InvokeCommand("KeepEdit")
    check([json.loads(e)["shape"] for e in edited.Edits] == ["voxels", "sphere", "box"], f"edits stack: {edited.Edits}")
    result = labels(edited)
    check((result[centre] == 5).all() and result[point(3, 12, 12)] == 2 and result[point(18, 18, 18)] == 3, "all three edits")
    check(edited.GetClientSideObject().GetNumberOfEdits() == 3, "filter and proxy agree")
    return edited, result


def check_file(image, edited, result, folder):
    """The JSON file brings the edits back; a broken one changes nothing."""
    edited.FileName = str(folder / "edits.json")
    edited.UpdateVTKObjects()
    edited.InvokeCommand("SaveEdits")
    content = json.loads((folder / "edits.json").read_text(encoding="utf-8"))
    check(len(content["edits"]) == 3, "the file holds the edits")
    again = simple.ReassignVoxels(Input=image, FileName=edited.FileName, Shape="None")
    again.UpdateVTKObjects()
    again.InvokeCommand("LoadEdits")
    check(list(again.Edits) == list(edited.Edits), "loaded edits are properties")
    check((labels(again) == result).all(), "the same image from the file")
    again.InvokeCommand("RemoveLastEdit")
    check(len(again.Edits) == 2, "the last edit is gone from the property")
    simple.Delete(again)


def check_undo(edited, result):
    """Undo takes a kept edit away, redo brings it back."""
    from paraview.modules.vtkRemotingServerManager import vtkSMUndoStack, vtkSMUndoStackBuilder
    stack, builder = vtkSMUndoStack(), vtkSMUndoStackBuilder()
    builder.SetUndoStack(stack)
    manager = servermanager.vtkSMProxyManager.GetProxyManager()
    manager.SetUndoStackBuilder(builder)
    edited.Shape, edited.Bounds, edited.ToMaterial, edited.FromMaterials = "Box", [0, 2, 0, 2, 0, 2], 4, []
    edited.UpdatePipeline()
    edited.InvokeCommand("KeepEdit")
    check(stack.CanUndo() == 1 and len(edited.Edits) == 4, "keeping an edit is a step of undo")
    stack.Undo()
    check(len(edited.Edits) == 3, f"undo: {len(edited.Edits)} edits")
    stack.Redo()
    check(len(edited.Edits) == 4, f"redo: {len(edited.Edits)} edits")
    stack.Undo()
    manager.SetUndoStackBuilder(None)
    edited.Shape = "None"
    check((labels(edited) == result).all(), "the image after undo")


def check_trace(edited):
    """A trace spells the edits out."""
    smtrace.start_trace()
    edited.InvokeCommand("RemoveLastEdit")
    text = smtrace.stop_trace()
    check("Edits = [" in text and '"sphere"' in text, f"the trace holds the edits:\n{text}")


def check_states(edited, result, folder):
    """Both kinds of state files bring the same image back, in a new process."""
    (folder / "state.py").write_text(smstate.get_state(), encoding="utf-8")
    simple.SaveState(str(folder / "state.pvsm"))
    np.save(folder / "result.npy", result)
    for state in ("state.py", "state.pvsm"):
        code = subprocess.run([sys.executable if "pvpython" in sys.executable else "pvpython", __file__,
                               "--reload", str(folder), state]).returncode
        check(code == 0, f"reloading {state}")


def reload(folder, state):
    if state.endswith(".py"):
        exec(compile((folder / state).read_text(encoding="utf-8"), state, "exec"), {"__name__": "__main__"})
    else:
        simple.LoadState(str(folder / state))
    found = simple.FindSource("Edited")
    check(found is not None and len(found.Edits) == 3, f"{state} holds three edits")
    check((labels(found) == np.load(folder / "result.npy")).all(), f"the image from {state}")
    print(f"{state}: the same image")


def main():
    if sys.argv[1] == "--reload":
        reload(pathlib.Path(sys.argv[2]), sys.argv[3])
        return
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    image = simple.XMLImageDataReader(FileName=[image_file(folder)])
    before = labels(image)
    simple.SetActiveView(simple.CreateView("RenderView"))
    simple.Show(image).SetRepresentationType("Outline")
    check((labels(simple.ReassignVoxels(Input=image)) == before).all(), "without edits nothing changes")
    centre, ids = check_selections(image, before)
    edited, result = check_keep(image, ids, centre, before)
    simple.RenameSource("Edited", edited)
    check_file(image, edited, result, folder)
    check_undo(edited, result)
    check_states(edited, result, folder)
    check_trace(edited)
    simple.Delete(simple.GetActiveView())
    print("edits are held by properties, state files, trace, undo and files")


if __name__ == "__main__":
    main()
