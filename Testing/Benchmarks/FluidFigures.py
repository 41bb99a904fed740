# SPDX-License-Identifier: BSD-3-Clause
"""Measures of prisms, pyramids and tetrahedra, written anew with numpy: they know nothing of the kernel's own."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

TET, WEDGE, PYRAMID = 10, 13, 14
#: faces of a type, by local corners, turned outwards for a positive cell
FACES = {TET: ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)),
         WEDGE: ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (0, 2, 5, 3)),
         PYRAMID: ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4))}


def norm(v):
    return np.sqrt(np.einsum("...i,...i->...", v, v))


def dot(a, b):
    return np.einsum("...i,...i->...", a, b)


def det(a, b, c):
    return dot(np.cross(a, b), c)


def triangle_quality(p):
    """2 r/R of triangles (n, 3, 3)."""
    a, b, c = (norm(p[:, (i + 1) % 3] - p[:, i]) for i in range(3))
    product = (a + b + c) * a * b * c
    return 4 * norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])) ** 2 / np.maximum(product, 1e-300)


def tet_quality(p):
    """3 r/R of tetrahedra (n, 4, 3), negative where they are inverted."""
    u, v, w = (p[:, i] - p[:, 0] for i in (1, 2, 3))
    vw, wu, uv = np.cross(v, w), np.cross(w, u), np.cross(u, v)
    volume = dot(uv, w)
    surface = norm(uv) + norm(vw) + norm(wu) + norm(uv + vw + wu)
    radius = norm(dot(u, u)[:, None] * vw + dot(v, v)[:, None] * wu + dot(w, w)[:, None] * uv)
    return 6 * volume * np.abs(volume) / np.maximum(surface * radius, 1e-300)


class Cells:
    """The cells of a grid by type, as corners; and what they are worth."""

    def __init__(self, grid):
        self.points = vtk_to_numpy(grid.GetPoints().GetData())
        types = vtk_to_numpy(grid.GetCellTypesArray())
        ids = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
        starts = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[:-1]
        self.tets, self.wedges, self.pyramids = (
            ids[starts[types == kind][:, None] + np.arange(size)] for kind, size in ((TET, 4), (WEDGE, 6), (PYRAMID, 5)))
        self.wall_ids = vtk_to_numpy(grid.GetPointData().GetArray("InterfaceNodeIds"))
        layers = vtk_to_numpy(grid.GetCellData().GetArray("LayerIds"))
        self.layer = layers[types == WEDGE]
        materials = vtk_to_numpy(grid.GetCellData().GetArray("MaterialIds"))
        self.materials = np.concatenate([materials[types == kind] for kind in (TET, WEDGE, PYRAMID)])

    def columns_on(self, nodes):
        """For each wedge whether one of its columns stands on one of the surface's nodes."""
        on = np.isin(self.wall_ids, nodes)
        for layer in range(1, self.layer.max(initial=0) + 1):
            feet = self.wedges[self.layer == layer]
            on[feet[:, 3:]] |= on[feet[:, :3]]
        return on[self.wedges].any(axis=1)

    def wedge_corners(self):
        return self.points[self.wedges]

    def wedge_quality(self):
        """The smaller of shape times orthogonality and the scaled Jacobian, 1 for a right prism on an equilateral triangle."""
        p = self.wedge_corners()[:, [0, 2, 1, 3, 5, 4]]  # VTK's first triangle looks out
        shape = np.minimum(triangle_quality(p[:, :3]), triangle_quality(p[:, 3:]))
        upright = np.full(len(p), np.inf)
        jacobian = np.full(len(p), np.inf)
        for low in (0, 3):
            normal = np.cross(p[:, low + 1] - p[:, low], p[:, low + 2] - p[:, low])
            for i in range(3):
                side = p[:, 3 + i] - p[:, i]
                one, two = (p[:, low + (i + k) % 3] - p[:, low + i] for k in (1, 2))
                upright = np.minimum(upright, dot(side, normal) / (norm(side) * norm(normal)))
                jacobian = np.minimum(jacobian, det(one, two, side) / (norm(one) * norm(two) * norm(side)))
        return np.minimum(shape * upright, 2 / np.sqrt(3) * jacobian)

    def invalid(self):
        """How many have a Jacobian that is not positive everywhere, by the Bernstein form, or a split with a flat tetrahedron."""
        p = self.wedge_corners()[:, [0, 2, 1, 3, 5, 4]]
        e0, f0, e1, f1 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0], p[:, 4] - p[:, 3], p[:, 5] - p[:, 3]
        normals = (np.cross(e0, f0), 0.5 * (np.cross(e0, f1) + np.cross(e1, f0)), np.cross(e1, f1))
        bad = np.zeros(len(p), bool)
        for i in range(3):
            low, middle, high = (dot(normal, p[:, 3 + i] - p[:, i]) for normal in normals)
            bad |= ~((low > 0) & (high > 0))
            bad |= ~(middle > -np.sqrt(np.maximum(low, 0) * np.maximum(high, 0)))
            j, k = (i + 1) % 3, (i + 2) % 3
            for tet in ((0, 1, 2, 3 + i), (3, 4, 5, i), (j, k, 3 + i, 3 + k), (j, k, 3 + i, 3 + j)):
                a, b, c, d = (p[:, corner] for corner in tet)
                volume = det(b - a, c - a, d - a)
                bad |= ~((-volume if tet == (3, 4, 5, i) else volume) > 0)
        q = self.points[self.pyramids]
        flat = np.zeros(len(q), bool)
        for i in range(4):
            flat |= ~(det(q[:, (i + 1) % 4] - q[:, i], q[:, (i + 3) % 4] - q[:, i], q[:, 4] - q[:, i]) > 0)
        return bad.sum() + flat.sum() + (self.tet_quality() <= 0).sum()

    def pyramid_quality(self):
        p = self.points[self.pyramids]
        halves = [tet_quality(p[:, list(corners)]) for corners in ((0, 1, 2, 4), (0, 2, 3, 4), (0, 1, 3, 4), (1, 2, 3, 4))]
        return np.maximum(np.minimum(*halves[:2]), np.minimum(*halves[2:]))

    def tet_quality(self):
        return tet_quality(self.points[self.tets])

    def groups(self):
        return ((TET, self.tets), (WEDGE, self.wedges), (PYRAMID, self.pyramids))

    def volumes(self):
        """Of the isoparametric cells: as their faces bound them, each quad as its bilinear patch."""
        return np.concatenate([self.volume_of(kind, ids) for kind, ids in self.groups()])

    def volume_of(self, kind, ids):
        p = self.points[ids]
        p = p - p[:, :1]
        total = np.zeros(len(ids))
        for face in FACES[kind]:
            q = p[:, list(face)]
            if len(face) == 3:
                total += det(q[:, 0], q[:, 1], q[:, 2]) / 6
            else:
                for a, b, c in ((0, 1, 2), (0, 2, 3), (0, 1, 3), (1, 2, 3)):
                    total += det(q[:, a], q[:, b], q[:, c]) / 12
        return total


def all_faces(layer, core):
    """Corners (by place, -1 for the fourth of a triangle) and cell of every face of two grids, and the cells' figures."""
    points = np.concatenate([layer.points, core.points])
    _, same = np.unique(points, axis=0, return_inverse=True)
    same = same.ravel()
    corners, owners, centres, volumes, kinds = [], [], [], [], []
    count = 0
    for cells, shift in ((layer, 0), (core, len(layer.points))):
        for kind, ids in cells.groups():
            for face in FACES[kind]:
                picked = ids[:, list(face)] + shift
                corners.append(np.pad(picked, ((0, 0), (0, 4 - len(face))), constant_values=-1))
                owners.append(count + np.arange(len(ids)))
            centres.append(centroids(points, ids + shift, kind))
            volumes.append(cells.volume_of(kind, ids))
            kinds.append(np.full(len(ids), kind))
            count += len(ids)
    corners = np.concatenate(corners)
    keys = np.sort(np.where(corners < 0, -1, same[corners]), axis=1)
    return points, corners, keys, np.concatenate(owners), np.concatenate(centres), np.concatenate(volumes), np.concatenate(kinds)


def centroids(points, ids, kind):
    """Of a cell as OpenFOAM has it: pyramids from the mean of the faces' centres to the faces, weighted by volume."""
    if kind == TET:
        return points[ids].mean(axis=1)
    faces = [face_of(points, ids[:, list(face)]) for face in FACES[kind]]
    middle = np.mean([centre for _, centre in faces], axis=0)
    weight = [np.abs(dot(area, centre - middle)) for area, centre in faces]
    return sum(w[:, None] * (0.75 * centre + 0.25 * middle) for w, (_, centre) in zip(weight, faces)) / sum(weight)[:, None]


def face_of(points, corners):
    """Area vector and centre of faces of three or four corners, a quad by the triangles round its mean."""
    p = points[corners]
    if p.shape[1] == 3:
        return 0.5 * np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), p.mean(axis=1)
    middle = p.mean(axis=1)
    areas = [0.5 * np.cross(p[:, i] - middle, p[:, (i + 1) % 4] - middle) for i in range(4)]
    total = sum(areas)
    unit = total / np.maximum(norm(total), 1e-300)[:, None]
    weights = [dot(area, unit) for area in areas]
    parts = [(p[:, i] + p[:, (i + 1) % 4] + middle) / 3 for i in range(4)]
    return total, sum(w[:, None] * part for w, part in zip(weights, parts)) / sum(weights)[:, None]


def face_figures(layer, core):
    """Non-orthogonality and skewness of all faces inside a material, and how volumes jump from the last prisms to the core."""
    points, corners, keys, owners, centres, volumes, kinds = all_faces(layer, core)
    order = np.lexsort(keys.T)
    pair = np.flatnonzero((keys[order][1:] == keys[order][:-1]).all(axis=1))
    materials = np.concatenate([layer.materials, core.materials])
    pair = pair[materials[owners[order[pair]]] == materials[owners[order[pair + 1]]]]
    one, two = order[pair], order[pair + 1]
    area, centre = np.empty((len(one), 3)), np.empty((len(one), 3))
    for quad in (False, True):
        chosen = (corners[one, 3] >= 0) == quad
        area[chosen], centre[chosen] = face_of(points, corners[one[chosen]][:, :4 if quad else 3])
    near, far = centres[owners[one]], centres[owners[two]]
    line = far - near
    cosine = np.abs(dot(line, area)) / (norm(line) * norm(area))
    angle = np.degrees(np.arccos(np.clip(cosine, 0, 1)))
    offset = centre - near
    skew = offset - (dot(area, offset) / dot(area, line))[:, None] * line
    direction = skew / np.maximum(norm(skew), 1e-300)[:, None]
    extent = 0.2 * norm(line)
    for i in range(4):
        there = corners[one, i] >= 0
        reach = np.abs(dot(direction, points[corners[one, i]] - centre))
        extent = np.where(there, np.maximum(extent, reach), extent)
    skewness = norm(skew) / np.maximum(extent, 1e-300)
    # The core stands after the layers in the lists: the face between a wedge and a tetrahedron of it.
    split = len(layer.tets) + len(layer.wedges) + len(layer.pyramids)
    low, high = np.minimum(owners[one], owners[two]), np.maximum(owners[one], owners[two])
    between = (high >= split) & (low < split) & (kinds[low] == WEDGE)
    ratio = volumes[high[between]] / volumes[low[between]]
    return {"jump": ((ratio > 0.3) & (ratio < 3)).mean(), "narrow": ((ratio > 0.5) & (ratio < 2)).mean(),
            "small": (ratio <= 0.3).mean(), "skewness": skewness.max(), "skewed": int((skewness > 4).sum()),
            "angle": angle.max(), "oblique": int((angle > 85).sum())}
