# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's real window: after Apply the panel tells what came out, materials have check boxes, voxels are selected by mouse in a
slice view, and the Help button opens the stage's page. Needs an X server (xvfb-run).

    TestPanels.py SOURCES PLUGINS_FOLDER OUTPUT_FOLDER    panels.png lands in OUTPUT_FOLDER
"""
import os
import sys
import tempfile

from window import APPLY, OPEN_PHANTOM, PANEL, PROPERTIES, apply_filter, check, play, prepare, resolution, save_state

SOURCES, PLUGINS, OUTPUT = (os.path.abspath(path) for path in sys.argv[1:4])
SECONDS = 300
SUMMARY = f"{PROPERTIES}/Summary/Summary"


def main():
    os.makedirs(OUTPUT, exist_ok=True)
    done = os.path.join(OUTPUT, "panels.pvsm")
    if os.path.exists(done):
        os.remove(done)
    events = [
        *OPEN_PHANTOM,
        resolution(30),
        APPLY,
        ("check", SUMMARY, "text", "tissue: 3264 voxels in 1 piece; blood: 883 voxels in 2 pieces"),
        *apply_filter("MultimaterialSegmentation"),
        *apply_filter("MultimaterialMarchingCubes"),
        *apply_filter("VolumeConservingSmoothing"),
        *apply_filter("FeatureSize"),
        *apply_filter("SurfaceRefinement"),
        *apply_filter("PrismLayer"),
        ("check", f"{PROPERTIES}/FluidMaterials/Materials", "count", "2"),
        (f"{PANEL}/Help", "activate", ""),
        *save_state(done),
    ]
    with tempfile.TemporaryDirectory() as home:
        said = play(home, PLUGINS, prepare(home, SOURCES, events), os.path.join(OUTPUT, "panels.log"), lambda: os.path.isfile(done),
                    os.path.join(OUTPUT, "panels.png"), SECONDS)
    check("critical:" not in said, said[:3000])
    check(os.path.isfile(done), f"not done within {SECONDS} s; see {OUTPUT}/panels.png\n{said[:2000]}")
    print("panels tell what came out")


if __name__ == "__main__":
    main()
