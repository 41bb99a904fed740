# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's real window: voxels are selected with a rubber band drawn by mouse over the image, handed to Reassign Voxels by Copy Active
Selection, and reassigned by Apply; the saved state makes the same change in pvpython. Needs an X server (xvfb-run).

    TestSelection.py SOURCES PLUGINS_FOLDER OUTPUT_FOLDER    selection.png and selection.pvsm land in OUTPUT_FOLDER
"""
import os
import re
import subprocess
import sys
import tempfile

from window import APPLY, OPEN_PHANTOM, PROPERTIES, WINDOW, apply_filter, check, play, prepare, resolution, save_state

SOURCES, PLUGINS, OUTPUT = (os.path.abspath(path) for path in sys.argv[1:4])
SECONDS = 300
RELOAD = """
import sys
import lamina
from paraview import simple
simple.LoadPlugin(sys.argv[1] + "/Lamina/Lamina.so", remote=False)
simple.LoadState(sys.argv[2])
stage = next(s for (name, _), s in simple.GetSources().items() if name.startswith("ReassignVoxels"))
stage.UpdatePipeline()
print("summary:", stage.GetClientSideObject().GetSummary())
"""


def main():
    os.makedirs(OUTPUT, exist_ok=True)
    done = os.path.join(OUTPUT, "selection.pvsm")
    if os.path.exists(done):
        os.remove(done)
    frame = f"{WINDOW}/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1/Container/Frame.1"
    events = [
        *OPEN_PHANTOM,
        resolution(30),
        APPLY,
        *apply_filter("MultimaterialSegmentation"),
        (f"{frame}/actionSelectFrustumPoints", "activate", ""),
        (f"{frame}/CentralWidgetFrame/Viewport/1QVTKOpenGLNativeWidget0", "mousePress", "(0.45,0.45,1,1,0)"),
        (f"{frame}/CentralWidgetFrame/Viewport/1QVTKOpenGLNativeWidget0", "mouseMove", "(0.55,0.55,1,1,0)"),
        (f"{frame}/CentralWidgetFrame/Viewport/1QVTKOpenGLNativeWidget0", "mouseRelease", "(0.55,0.55,1,0,0)"),
        *apply_filter("ReassignVoxels"),
        (f"{PROPERTIES}/Selection/Selection/pushButtonCopySelection", "activate", ""),
        APPLY,
        *save_state(done),
    ]
    with tempfile.TemporaryDirectory() as home:
        said = play(home, PLUGINS, prepare(home, SOURCES, events), os.path.join(OUTPUT, "selection.log"), lambda: os.path.isfile(done),
                    os.path.join(OUTPUT, "selection.png"), SECONDS)
    check("critical:" not in said, said[:3000])
    check(os.path.isfile(done), f"not done within {SECONDS} s; see {OUTPUT}/selection.png\n{said[:2000]}")
    with tempfile.TemporaryDirectory() as home:
        script = os.path.join(home, "reload.py")
        with open(script, "w", encoding="utf-8") as file:
            file.write(RELOAD)
        environment = {**os.environ, "PYTHONPATH": f"{PLUGINS}/Lamina"}
        again = subprocess.run(["pvpython", "--no-mpi", script, PLUGINS, done], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               env=environment, timeout=SECONDS).stdout
    told = re.search(r"summary: 1 edit, (\d+) voxels? changed, 0 faults left", again)
    check(told and int(told[1]) > 0, f"the state makes no edit:\n{again}")
    print(told[0])


if __name__ == "__main__":
    main()
