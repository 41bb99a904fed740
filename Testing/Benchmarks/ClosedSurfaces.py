# SPDX-License-Identifier: BSD-3-Clause
"""The closed surfaces of the shared data, read with their points merged."""
import os

from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

#: by the folder they lie in
FILES = {"biv_heart_surface": (vtkXMLPolyDataReader, "heart.vtp"), "vmtk_aorta": (vtkSTLReader, "aorta-surface.stl")}


def read_closed_surface(data, name):
    """The surface of this name in the folder of shared data."""
    make_reader, file = FILES[name]
    reader = make_reader()
    reader.SetFileName(os.path.join(data, name, file))
    clean = vtkCleanPolyData()
    clean.SetInputConnection(reader.GetOutputPort())
    clean.Update()
    return clean.GetOutput()
