#!/usr/bin/env pvpython
# SPDX-License-Identifier: BSD-3-Clause
"""All pictures of docs/filters, before and after each stage: xvfb-run -a Utilities/draw-pages.sh [FOLDER] [NAME ...]"""
import json
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Testing", "Python"))
import tiny  # noqa: E402, F401  loads the plugin
from paraview import simple  # noqa: E402
from views import beside, cut, draw, drawn_mask, image_slice  # noqa: E402

HALF = [360, 320]


def port(source, index):
    return simple.OutputPort(source, index)


def stages():
    """The pipeline on a small heart, by name."""
    s = {"phantom": simple.HeartPhantom(Resolution=64)}
    s["labels"] = simple.MultimaterialSegmentation(Input=s["phantom"])
    s["cubes"] = simple.MultimaterialMarchingCubes(Input=s["labels"])
    s["smooth"] = simple.VolumeConservingSmoothing(Input=s["cubes"])
    s["sized"] = simple.FeatureSize(Input=s["smooth"], Layers=3)
    s["fine"] = simple.SurfaceRefinement(Input=s["sized"])
    s["solid"] = simple.LayeredTetrahedra(Input=s["fine"], Layers=3)
    s["prisms"] = simple.PrismLayer(Input=s["fine"], Layers=4)
    s["core"] = simple.CoreTetrahedra(Input=port(s["prisms"], 1))
    s["mesh"] = simple.FluidSolidMesh(Input=[s["solid"], s["prisms"], s["core"]], Surface=s["fine"])
    s["audit"] = simple.MeshAudit(Input=s["mesh"], Surface=s["fine"])
    s["ball"] = tiny.pipeline()["prisms"]
    s["cut ball"] = simple.PrismstoTetrahedra(Input=s["ball"])
    s["tets"] = simple.PrismstoTetrahedra(Input=s["mesh"])
    s["quadratic"] = simple.QuadraticCells(Input=s["tets"], Surface=s["smooth"])
    s["fibers"] = simple.RuleBasedFibers(Input=s["tets"])
    s["depth"] = simple.WallDepth(Input=s["tets"])
    s["smooth"].UpdatePipeline()
    bounds = s["smooth"].GetDataInformation().GetBounds()
    s["vessel cut"] = simple.VesselCut(Input=s["smooth"], Normal=[0.3, -0.1, 1], Origin=[
        0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), bounds[4] + 0.6 * (bounds[5] - bounds[4])])
    for stage in s.values():
        stage.UpdatePipeline()
    return s


def edited(labels):
    bounds = labels.GetDataInformation().GetBounds()
    middle = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    stage = simple.ReassignVoxels(Input=labels, Shape="None")
    stage.Edits = [json.dumps({"shape": "sphere", "center": middle, "radius": 0.12 * bounds[1], "to": 1}),
                   json.dumps({"shape": "sphere", "center": middle, "radius": 0.06 * bounds[1], "to": 2})]
    stage.UpdatePipeline()
    return stage


def scenes(s):
    """Page, then before and after: what is shown, the array that colours it (None: one colour), edges, zoom."""
    grey, labels, truth = ("POINTS", "Intensity"), ("POINTS", "MaterialIds"), ("POINTS", "MaterialIds")
    layers, material = ("CELLS", "LayerIds"), ("CELLS", "MaterialIds")
    mask = drawn_mask(s["phantom"])
    carried = simple.PropagateMask(Input=s["phantom"], Mask=mask)
    carried.UpdatePipeline()
    mesh, solid, prisms, core = (cut(s[name]) for name in ("mesh", "solid", "prisms", "core"))
    inner = cut(simple.ExtractSurface(Input=port(s["prisms"], 1)))
    yield "heart-phantom", (image_slice(s["phantom"], 1), truth, False, 1), (image_slice(s["phantom"]), grey, False, 1)
    yield "multimaterial-segmentation", (image_slice(s["phantom"]), grey, False, 1), (image_slice(s["labels"]), labels, False, 1)
    yield "propagate-mask", (image_slice(mask), truth, False, 1), (image_slice(carried), ("POINTS", "Mask"), False, 1)
    yield "reassign-voxels", (image_slice(s["labels"]), labels, False, 1), (image_slice(edited(s["labels"])), labels, False, 1)
    yield "multimaterial-marching-cubes", (image_slice(s["labels"]), labels, False, 1), (cut(s["cubes"]), None, False, 1)
    yield "volume-conserving-smoothing", (s["cubes"], None, False, 1.6), (s["smooth"], None, False, 1.6)
    yield "feature-size", (s["smooth"], None, False, 1), (s["sized"], ("POINTS", "FeatureSize"), False, 1)
    yield "surface-refinement", (s["sized"], None, True, 3), (s["fine"], None, True, 3)
    yield "layered-tetrahedra", (cut(s["fine"]), None, True, 2), (solid, layers, True, 2)
    yield "prism-layer", (cut(s["fine"]), None, True, 2), (prisms, layers, True, 2)
    yield "core-tetrahedra", (inner, None, True, 1.4), (core, None, True, 1.4)
    yield "fluid-solid-mesh", (solid, material, True, 1.4), (mesh, material, True, 1.4)
    yield "mesh-audit", (mesh, material, True, 1.4), (cut(s["audit"]), ("CELLS", "MeshQuality"), True, 1.4)
    yield "prisms-to-tetrahedra", (cut(s["ball"]), layers, True, 1.2), (cut(s["cut ball"]), layers, True, 1.2)
    yield "quadratic-cells", (s["tets"], None, True, 5), (s["quadratic"], None, True, 5)
    yield "vessel-cut", (s["smooth"], None, False, 1), (s["vessel cut"], ("CELLS", "PatchIds"), False, 1)
    yield "wall-depth", (cut(s["tets"]), material, False, 1), (cut(s["depth"]), ("CELLS", "WallDepth"), False, 1)
    yield "rule-based-fibers", (cut(s["tets"]), material, False, 1), (cut(s["fibers"]), ("CELLS", "WallDepth"), False, 1)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(HERE, "..", "docs", "pictures")
    wanted = sys.argv[2:]
    os.makedirs(folder, exist_ok=True)
    for name, *pair in scenes(stages()):
        if wanted and name not in wanted:
            continue
        parts = [os.path.join(folder, f"{name}-{k}.part.png") for k in range(2)]
        for (source, colour, edges, zoom), part in zip(pair, parts):
            draw(source, colour, edges, zoom, part, HALF)
        beside([parts], os.path.join(folder, f"{name}.png"))
        print(name, flush=True)


if __name__ == "__main__":
    main()
