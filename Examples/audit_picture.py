# SPDX-License-Identifier: BSD-3-Clause
"""A picture of a mesh for the audit's page: audit_picture.py FILE PNG. The outside coloured by quality, where there is such."""
import sys

from paraview import simple

reader = simple.OpenDataFile(sys.argv[1])
reader.UpdatePipeline()
view = simple.CreateView("RenderView")
view.ViewSize = [900, 700]
view.Background = [1, 1, 1]
view.OrientationAxesVisibility = 0
bounds = reader.GetDataInformation().GetBounds()
centre = [0.5 * (bounds[2 * k] + bounds[2 * k + 1]) for k in range(3)]
half = simple.Clip(Input=reader, ClipType="Plane")
half.ClipType.Origin = centre
half.ClipType.Normal = [0, 1, 0]
half.Crinkleclip = 1
shown = simple.Show(half, view)
shown.Representation = "Surface With Edges"
names = [half.CellData[i].Name for i in range(half.CellData.GetNumberOfArrays())]
if "MaterialIds" in names:
    simple.ColorBy(shown, ("CELLS", "MaterialIds"))
view.CameraPosition = [centre[0] + 0.3 * (bounds[1] - bounds[0]), centre[1] - 3 * (bounds[3] - bounds[2]), centre[2]]
view.CameraFocalPoint = centre
view.CameraViewUp = [0, 0, 1]
view.ResetCamera()
simple.SaveScreenshot(sys.argv[2], view)
