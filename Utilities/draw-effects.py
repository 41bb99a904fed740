#!/usr/bin/env pvpython
# SPDX-License-Identifier: BSD-3-Clause
"""What the properties of the stages do: for each page a picture with a row a property and a column a value, and the table that says
which. Run by draw-pages.sh: draw-effects.py [FOLDER] [PAGE ...]"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Testing", "Python"))
import tiny  # noqa: E402, F401  loads the plugin
from paraview import simple  # noqa: E402
from views import beside, cut, draw, drawn_mask, fewer_colours, image_slice  # noqa: E402

SIZE = [230, 200]

LABELS, GREY, LAYER = ("POINTS", "MaterialIds"), ("POINTS", "Intensity"), ("CELLS", "LayerIds")
SIZES, MASK = ("POINTS", "TargetEdgeLength"), ("POINTS", "Mask")


def whole(stage):
    return stage


class Effects:
    """The small heart that all rows start from; each row makes its stage anew with one property changed."""

    def __init__(self):
        self.phantom = simple.HeartPhantom(Resolution=48)
        self.phantom.UpdatePipeline()
        self.noisy = simple.HeartPhantom(Resolution=48, Noise=35)
        self.labels = simple.MultimaterialSegmentation(Input=self.phantom)
        self.cubes = simple.MultimaterialMarchingCubes(Input=self.labels)
        self.smooth = simple.VolumeConservingSmoothing(Input=self.cubes)
        self.sized = simple.FeatureSize(Input=self.smooth, Layers=3)
        self.fine = simple.SurfaceRefinement(Input=self.sized)
        self.prisms = simple.PrismLayer(Input=self.fine, Layers=3)
        self.mask = drawn_mask(self.phantom)
        self.fine.UpdatePipeline()

    def inner(self):
        return simple.OutputPort(self.prisms, 1)

    def rows(self):
        """Page, property, three values; the stage with its input; what is shown of it, colours, edges, zoom, range of the colours."""
        def stage(maker, **inputs):
            return lambda **changed: maker(**inputs, **changed)
        phantom = stage(simple.HeartPhantom, Resolution=48)
        yield "heart-phantom", "Resolution", (24, 48, 96), simple.HeartPhantom, (image_slice, GREY, False, 1, None)
        for name, values in (("Noise", (0, 12, 40)), ("Blur", (0, 1, 3))):
            yield "heart-phantom", name, values, phantom, (image_slice, GREY, False, 1, (0, 220))
        segment = stage(simple.MultimaterialSegmentation, Input=self.phantom)
        page = "multimaterial-segmentation"
        yield page, "Thresholds", ([], [35, 90, 110], [75, 150, 170]), segment, (image_slice, LABELS, False, 1, None)
        noisy = stage(simple.MultimaterialSegmentation, Input=self.noisy, Thresholds=[52, 127, 148])
        yield page, "SmoothingSweeps", (0, 2, 8), noisy, (image_slice, LABELS, False, 1, None)
        rough = stage(simple.MultimaterialSegmentation, Input=self.noisy, Thresholds=[52, 127, 148], SmoothingSweeps=0, MinimumShare=0)
        yield page, "MinimumVoxels", (0, 5, 500), rough, (image_slice, LABELS, False, 1, None)
        carry = stage(simple.PropagateMask, Input=self.phantom, Mask=self.mask)
        yield "propagate-mask", "Method", ("Shape interpolation", "Registration", "Automatic"), carry, (image_slice, MASK, False, 1, None)
        cubes = stage(simple.MultimaterialMarchingCubes, Input=self.labels, GreyImage=self.phantom)
        yield "multimaterial-marching-cubes", "ClusterPoints", (0, 1), cubes, (whole, None, True, 3, None)
        smooth = stage(simple.VolumeConservingSmoothing, Input=self.cubes)
        yield "volume-conserving-smoothing", "Sweeps", (2, 20, 100), smooth, (whole, None, False, 1.6, None)
        sizes = stage(simple.FeatureSize, Input=self.smooth)
        for name, values in (("Layers", (2, 4, 8)), ("Gradient", (0.1, 0.3, 1)), ("MinimumSize", (0, 4, 8)), ("NodesPerCircumference", (6, 12, 30))):
            yield "feature-size", name, values, sizes, (whole, SIZES, False, 1, (0.5, 6))
        refine = stage(simple.SurfaceRefinement, Input=self.sized)
        yield "surface-refinement", "EdgeLength", (2, 4, 8), refine, (whole, None, True, 2, None)
        solid = stage(simple.LayeredTetrahedra, Input=self.fine)
        yield "layered-tetrahedra", "Layers", (2, 4, 6), solid, (cut, LAYER, True, 2, (1, 3))
        solid = stage(simple.LayeredTetrahedra, Input=self.fine, Layers=3)
        yield "layered-tetrahedra", "Growth", (0.6, 1, 1.6), solid, (cut, LAYER, True, 2, None)
        prisms = stage(simple.PrismLayer, Input=self.fine)
        for name, values in (("Layers", (2, 5, 8)), ("GrowthRatio", (1, 1.2, 1.8)), ("Thickness", (0.1, 0.25, 0.45))):
            yield "prism-layer", name, values, prisms, (cut, LAYER, True, 2, None)
        core = stage(simple.CoreTetrahedra, Input=self.inner())
        yield "core-tetrahedra", "MaximumEdge", (0, 3, 1.5), core, (cut, None, True, 2, None)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(HERE, "..", "docs", "pictures")
    wanted = sys.argv[2:]
    os.makedirs(folder, exist_ok=True)
    pages = {}
    for page, name, values, make, (what, colour, edges, zoom, scale) in Effects().rows():
        if wanted and page not in wanted:
            continue
        parts = []
        for k, value in enumerate(values):
            made = make(**{name: value})
            made.UpdatePipeline()
            parts.append(os.path.join(folder, f"{page}-{name}-{k}.part.png"))
            draw(what(made), colour, edges, zoom, parts[-1], SIZE, scale)
        pages.setdefault(page, []).append(parts)
        print(page, name, values, flush=True)
    for page, rows in pages.items():
        widest = max(len(parts) for parts in rows)
        if any(len(parts) != widest for parts in rows):
            sys.exit(f"{page}: rows of different lengths")
        path = os.path.join(folder, f"{page}-effects.png")
        beside(rows, path)
        fewer_colours(path)


if __name__ == "__main__":
    main()
