# SPDX-License-Identifier: BSD-3-Clause
"""What Prism Layer and Core Tetrahedra make of real images: every figure that the page of Prism Layer names.

    LAMINA_PLUGIN=.../Lamina.so pvpython MeasureFluid.py SHARED_DATA CACHE [NAME:EDGES:LAYERS:GROWTH ...]

with PYTHONPATH set to the plugin's folder. NAME is phantom120 (any resolution), heart_cta, mickey (all five
materials taken for fluids), vmtk_aorta (closed) or biv_heart_surface (inside); EDGES the layers of tissue that Feature Size makes the edges for; LAYERS and GROWTH those of
the prisms. Without any: all of them at 5 layers and 1.2. Surfaces are kept in CACHE, to be read again. One line of a
table is written for each.
"""
import os
import sys
import time
from types import SimpleNamespace

import lamina  # noqa: F401  before any object of the plugin is looked at
import numpy as np
from ClosedSurfaces import FILES, read_closed_surface
from FluidFigures import Cells, face_figures

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Examples"))
from lamina_images import read_image  # noqa: E402
from lamina_pipeline import Pipeline, load_plugin, output_of, producer, read_mask, simple  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter  # noqa: E402

#: where no direction into a material sees all faces with a cosine of 0.4 (Surface Refinement)
HIDDEN_NODE = 16
SIZES = {"layers": 6, "anisotropy": 2.0, "min_size": None, "max_size": None, "gradient": 0.5,
         "smoothing_sweeps": 20, "cut": [], "open_border": [], "thresholds": [50, 110, 150]}
HEAD = ("surface", "edges for", "layers, growth", "prisms", "invalid", "0.2 or less (beside listed nodes)", "least", "full layers",
        "pyramids, least", "core tets, least", "a front triangle", "volume 0.3..3 (0.5..2)", "skewness", "non-orthogonality",
        "volume off", "seconds of layers, core (and of processor)")


def options(**changed):
    return SimpleNamespace(**{**SIZES, **changed})


def sized(surface, layers):
    size = simple.FeatureSize(Input=producer(surface), Layers=layers)
    refined = simple.SurfaceRefinement(Input=size)
    refined.UpdatePipeline()
    return output_of(refined)


def make_surface(name, data, layers):
    pipeline = Pipeline()
    if name in FILES:
        return sized(read_closed_surface(data, name), layers)
    pipeline.grey = None
    if name == "heart_cta":
        scan = read_image(os.path.join(data, name, "ct.mha"))
        mask = read_mask(os.path.join(data, name, "mask.mha"), scan)
        labels = pipeline.segment(scan, mask, options(thresholds=[-20, 215]))
    elif name == "mickey":
        labels = pipeline.take_labels(read_image(os.path.join(data, "cleaver_tests", "mickey.nrrd")), None)
    else:
        grey, = pipeline.update(simple.HeartPhantom(Resolution=int(name[len("phantom"):])))
        labels = pipeline.segment(grey, None, options())
    return output_of(pipeline.make_surface(labels, None, [2], options(layers=layers)))


def cached(name, data, cache, layers):
    path = os.path.join(cache, f"{name}-{layers}.vtp")
    if not os.path.exists(path):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(path)
        writer.SetInputData(make_surface(name, data, layers))
        writer.Write()
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def timed(proxy):
    clock, processor = time.perf_counter(), time.process_time()
    proxy.UpdatePipeline()
    return time.perf_counter() - clock, time.process_time() - processor


def enclosed_volume(surface, material):
    points = vtk_to_numpy(surface.GetPoints().GetData())
    corners = points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    labels = vtk_to_numpy(surface.GetCellData().GetArray("BoundaryLabels"))
    side = (labels[:, 0] == material).astype(float) - (labels[:, 1] == material)
    corners = corners - points.mean(axis=0)
    return (side * np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))).sum() / 6


def measure(name, surface, edges, layers, growth):
    labels = vtk_to_numpy(surface.GetCellData().GetArray("BoundaryLabels"))
    fluids = [int(m) for m in np.unique(labels) if m > 0] if name == "mickey" else [2 if (labels == 2).any() else 1]
    prisms = simple.PrismLayer(Input=producer(surface), FluidMaterials=fluids, Layers=layers, GrowthRatio=growth)
    seconds = timed(prisms)
    core = simple.CoreTetrahedra(Input=simple.OutputPort(prisms, 1))
    more = timed(core)
    layer, front, walls = (output_of(prisms, port) for port in range(3))
    if layer.GetNumberOfCells() == 0 or output_of(core).GetNumberOfCells() == 0:
        print(f"| {name} | {edges} | {layers}, {growth} | refused |", flush=True)
        return
    flags = vtk_to_numpy(surface.GetPointData().GetArray("MeshingFlags"))
    cells = Cells(layer)
    listed = cells.columns_on(np.flatnonzero(flags & HIDDEN_NODE))
    wedges = cells.wedge_quality()
    poor = wedges <= 0.2
    pyramids = cells.pyramid_quality()
    tets = Cells(output_of(core))
    quality = np.concatenate([tets.tet_quality(), cells.tet_quality()])
    achieved = vtk_to_numpy(walls.GetCellData().GetArray("LayersAchieved"))
    achieved = achieved[np.isin(labels, fluids).any(axis=1)]
    faces = face_figures(cells, tets)
    expected = sum(enclosed_volume(surface, fluid) for fluid in fluids)
    volume = cells.volumes().sum() + tets.volumes().sum()
    row = (name, edges, f"{layers}, {growth}", f"{len(wedges):,}", int(cells.invalid()),
           f"{poor.sum()} ({(poor & listed).sum()})", f"{wedges.min():.3f}", f"{100 * (achieved == layers).mean():.2f} %",
           f"{len(pyramids)}, {pyramids.min() if len(pyramids) else 1:.3f}", f"{len(tets.tets):,}, {quality.min():.3f}",
           f"{len(tets.tets) / front.GetNumberOfCells():.2f}",
           f"{100 * faces['jump']:.1f} % ({100 * faces['narrow']:.1f} %; below {100 * faces['small']:.1f} %)",
           f"{faces['skewness']:.2f} ({faces['skewed']})", f"{faces['angle']:.1f} ({faces['oblique']})",
           f"{abs(volume / expected - 1):.0e}",
           f"{seconds[0]:.1f}, {more[0]:.1f} ({seconds[1]:.1f}, {more[1]:.1f})")
    print("| " + " | ".join(str(entry) for entry in row) + " |", flush=True)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    data, cache = sys.argv[1:3]
    os.makedirs(cache, exist_ok=True)
    load_plugin()
    runs = sys.argv[3:] or [f"{name}:6:5:1.2" for name in ("phantom120", "heart_cta", "vmtk_aorta", "biv_heart_surface")]
    Pipeline()  # takes over what VTK prints
    print("| " + " | ".join(HEAD) + " |\n" + "|---" * len(HEAD) + "|", flush=True)
    for run in runs:
        name, edges, layers, growth = run.split(":")
        measure(name, cached(name, data, cache, int(edges)), int(edges), int(layers), float(growth))


if __name__ == "__main__":
    main()
