# SPDX-License-Identifier: BSD-3-Clause
"""Volume-Conserving Smoothing beside two of VTK's smoothers, all at their defaults, on digitised shapes.

    pvpython CompareSmoothing.py

with PYTHONPATH set to the plugin's folder. For each shape and smoother a row of Markdown: the angle of the triangles'
normals to the true ones and the distance of the points from the true surface (root mean square, voxels), the change of
the volume against the voxels', and the pairs of triangles that intersect. All three start from the voxel faces of
Multimaterial Marching Cubes, so that volumes can be compared.
"""
import numpy as np

import lamina
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkWindowedSincPolyDataFilter

try:
    from vtkmodules.vtkFiltersGeneral import vtkConstrainedSmoothingFilter
except ImportError:
    try:
        from vtkmodules.vtkFiltersCore import vtkConstrainedSmoothingFilter
    except ImportError:  # older than VTK 9.1, or not packaged
        vtkConstrainedSmoothingFilter = None


def image_of(n, inside):
    """The labels of a shape in an image of n voxels a side, with the origin in its middle."""
    at = np.arange(n) - (n - 1) / 2
    z, y, x = np.meshgrid(at, at, at, indexing="ij")
    labels = inside(x, y, z)
    labels[:3], labels[-3:], labels[:, :3], labels[:, -3:], labels[..., :3], labels[..., -3:] = (0,) * 6
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetOrigin(at[0], at[0], at[0])
    values = numpy_to_vtk(labels.astype(np.uint8).ravel(), deep=1)
    values.SetName("MaterialIds")
    image.GetPointData().SetScalars(values)
    return image, int(labels.sum())


def ball(radius):
    centre = np.array([0.13, 0.27, 0.41])
    return lambda p: np.linalg.norm(p - centre, axis=-1) - radius


def slab(tilt):
    normal = np.array([np.sin(np.radians(tilt)), 0, np.cos(np.radians(tilt))])
    return lambda p: np.abs(p @ normal - 0.1) - 8.3


def cylinder(axis, radius, half):
    axis = np.array(axis) / np.linalg.norm(axis)

    def distance(p):
        along = p @ axis
        return np.maximum(np.linalg.norm(p - along[..., None] * axis, axis=-1) - radius, np.abs(along) - half)
    return distance


def chorda(p):
    """A strand of two voxels between two blocks; the distance is that of the strand."""
    axis = np.array([np.sin(0.3), 0.3 * np.sin(0.3), np.cos(0.3)])
    axis /= np.linalg.norm(axis)
    strand = np.linalg.norm(p - (p @ axis)[..., None] * axis, axis=-1) - 1.1
    block = (np.abs(p[..., 2]) > 18) & (np.abs(p[..., 2]) < 26) & (np.abs(p[..., 0]) < 24) & (np.abs(p[..., 1]) < 24)
    return np.where(block, -1, np.where(np.abs(p[..., 2]) <= 18, strand, 1))


def arrays(surface):
    return (vtk_to_numpy(surface.GetPoints().GetData()).astype(float),
            vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def volume_of(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return abs(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def slice_volume(points, triangles, height):
    """The volume between z = -height and height, by the divergence theorem in each slice."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    middle, area = (a + b + c) / 3, np.cross(b - a, c - a) / 2
    within = np.abs(middle[:, 2]) < height
    return abs((middle[within, :2] * area[within, :2]).sum() / 2)


def errors(points, triangles, distance, region):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    middle = (a + b + c) / 3
    normal = np.cross(b - a, c - a)
    kept = region(middle) & (np.linalg.norm(normal, axis=1) > 0)
    middle, normal = middle[kept], normal[kept]
    step = 1e-4 * np.eye(3)
    true = np.stack([distance(middle + step[k]) - distance(middle - step[k]) for k in range(3)], axis=1)
    cosine = np.abs((normal * true).sum(1)) / np.linalg.norm(normal, axis=1) / np.linalg.norm(true, axis=1)
    angles = np.degrees(np.arccos(np.minimum(1, cosine)))
    near = points[region(points)]
    return np.sqrt((angles ** 2).mean()), np.sqrt((distance(near) ** 2).mean())


def intersections(surface):
    audit = lamina.vtkMeshAudit()
    audit.SetInputData(surface)
    audit.Update()
    table = audit.GetOutputDataObject(1)
    for row in range(table.GetNumberOfRows()):
        if table.GetValueByName(row, "Name").ToString() == "intersectingPairs":
            return int(table.GetValueByName(row, "Value").ToDouble())
    raise RuntimeError("the audit told nothing of intersections")


def main():
    everywhere = lambda p: np.ones(len(p), bool)
    inner = lambda p: (np.abs(p[:, 0]) < 20) & (np.abs(p[:, 1]) < 20) & (np.abs(p[:, 2]) < 22)
    away = lambda axis: (lambda p: np.abs(p @ (np.array(axis) / np.linalg.norm(axis))) < 15)
    oblique = (0.3, 0.2, 0.93)
    shapes = [(f"ball, radius {r}", 2 * r + 9, ball(r), everywhere) for r in (10, 20, 40)]
    shapes += [(f"slab tilted by {t}°", 64, slab(t), inner) for t in (3, 8, 15, 25, 40)]
    shapes += [("cylinder, upright", 60, cylinder((0, 0, 1), 10, 22), away((0, 0, 1))),
               ("cylinder, oblique", 60, cylinder(oblique, 10, 22), away(oblique)),
               ("chorda of 2 voxels", 60, chorda, lambda p: np.abs(p[:, 2]) < 12)]
    smoothers = [("none", None), ("Volume-Conserving Smoothing", lamina.vtkVolumeConservingSmoothing),
                 ("vtkWindowedSincPolyDataFilter", vtkWindowedSincPolyDataFilter)]
    if vtkConstrainedSmoothingFilter:
        smoothers.append(("vtkConstrainedSmoothingFilter", vtkConstrainedSmoothingFilter))
    else:
        print("vtkConstrainedSmoothingFilter is not in this VTK: left out\n")
    print("| shape | smoother | angle | distance | volume | pairs |")
    print("|---|---|---:|---:|---:|---:|")
    for name, size, distance, region in shapes:
        image, voxels = image_of(size, lambda x, y, z: distance(np.stack([x, y, z], -1)) < 0)
        extraction = lamina.vtkMultimaterialMarchingCubes()
        extraction.SetInputData(image)
        extraction.Update()
        for label, kind in smoothers:
            surface = extraction.GetOutput()
            if kind:
                smoother = kind()
                smoother.SetInputData(surface)
                smoother.Update()
                surface = smoother.GetOutput()
            points, triangles = arrays(surface)
            angle, away_by = errors(points, triangles, distance, region)
            if distance is chorda:
                at = np.arange(size) - (size - 1) / 2
                z, y, x = np.meshgrid(at[np.abs(at) < 12], at, at, indexing="ij")
                voxels = int((chorda(np.stack([x, y, z], -1)) < 0).sum())
                change = slice_volume(points, triangles, 12) / voxels - 1
            else:
                change = volume_of(points, triangles) / voxels - 1
            print(f"| {name} | {label} | {angle:.1f}° | {away_by:.2f} | {100 * change:+.2g} % | {intersections(surface)} |",
                  flush=True)


if __name__ == "__main__":
    main()
