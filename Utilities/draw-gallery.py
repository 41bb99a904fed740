#!/usr/bin/env pvpython
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of docs/gallery.md: each data set meshed by Apply alone, half of the mesh by material. Run by draw-pages.sh where
LAMINA_SHARED_DATA names the folder of the data: draw-gallery.py [FOLDER] [PAGE ...], PAGE gallery or a case of TestApplyAlone.py"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Testing", "Python"))
from TestApplyAlone import CASES, stages_of  # noqa: E402  loads the plugin
from paraview import simple  # noqa: E402
from views import cut, draw, fewer_colours  # noqa: E402

SIZE = [300, 270]
SHOWN = ("mickey", "heart_surface", "aorta_surface")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(HERE, "..", "docs", "pictures")
    wanted = [page for page in sys.argv[2:] if page in SHOWN] or (SHOWN if not sys.argv[2:] or "gallery" in sys.argv[2:] else [])
    data = os.environ.get("LAMINA_SHARED_DATA", "")
    for name in wanted:
        kind, *files = CASES[name]
        paths = [os.path.join(data, file) for file in files]
        if not all(os.path.isfile(path) for path in paths):
            print(f"gallery {name}: skipped, {paths[0]} is not there")
            continue
        audit = stages_of(kind, paths)["audit"]
        audit.UpdatePipeline()
        print(f"gallery {name}: {audit.GetClientSideObject().GetSummary()}", flush=True)
        path = os.path.join(folder, f"gallery-{name.replace('_', '-')}.png")
        draw(cut(audit), ("CELLS", "MaterialIds"), True, 0.75, path, SIZE)
        fewer_colours(path)
        for source in list(simple.GetSources().values())[::-1]:
            simple.Delete(source)


if __name__ == "__main__":
    main()
