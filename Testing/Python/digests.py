# SPDX-License-Identifier: BSD-3-Clause
"""A sum over a data set: the same for the same points, cells and arrays, whatever their order in the file."""
import hashlib

from vtkmodules.util.numpy_support import vtk_to_numpy


def arrays_of(data):
    """Its named parts as arrays."""
    if data.IsA("vtkTable"):
        columns = data.GetRowData()
        return {f"row {columns.GetArrayName(i)}": columns.GetAbstractArray(i) for i in range(columns.GetNumberOfArrays())}
    parts = {}
    if data.IsA("vtkPointSet") and data.GetPoints():
        parts["points"] = data.GetPoints().GetData()
    for name in ("GetCells", "GetPolys"):
        cells = getattr(data, name)() if hasattr(data, name) and not data.IsA("vtkImageData") else None
        if cells is not None:  # a grid that was never filled has none
            parts[name + " nodes"] = cells.GetConnectivityArray()
            parts[name + " offsets"] = cells.GetOffsetsArray()
    for kind, held in (("point", data.GetPointData()), ("cell", data.GetCellData())):
        for i in range(held.GetNumberOfArrays()):
            parts[f"{kind} {held.GetArrayName(i)}"] = held.GetAbstractArray(i)
    return parts


def digest(data):
    sums = hashlib.sha256()
    if data.IsA("vtkImageData"):
        sums.update(repr((data.GetExtent(), data.GetSpacing(), data.GetOrigin())).encode())
    for name, part in sorted(arrays_of(data).items()):
        sums.update(name.encode())
        if part.IsA("vtkStringArray"):
            sums.update(repr([part.GetValue(i) for i in range(part.GetNumberOfValues())]).encode())
        else:
            sums.update(vtk_to_numpy(part).tobytes())
    return sums.hexdigest()
