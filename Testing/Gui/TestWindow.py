# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's real window: Sources > Lamina > Heart Phantom, Apply, the macro Mesh This Image, File > Save State; the state then
makes the same mesh again in pvpython. Needs an X server (xvfb-run).

    TestWindow.py SOURCES PLUGINS_FOLDER OUTPUT_FOLDER    window.png and state.pvsm land in OUTPUT_FOLDER
"""
import os
import subprocess
import sys
import tempfile

from window import APPLY, OPEN_PHANTOM, WINDOW, check, play, prepare, save_state

SOURCES, PLUGINS, OUTPUT = (os.path.abspath(path) for path in sys.argv[1:4])
SECONDS = 500

# What the mouse does: object, command, arguments, as ParaView's own recorder writes it.
EVENTS = (
    *OPEN_PHANTOM,
    APPLY,
    (f"{WINDOW}/menubar", "activate", "menu_Macros"),
    (f"{WINDOW}/menubar/menu_Macros", "activate", "Mesh This Image"),
    *save_state(os.path.join(OUTPUT, "state.pvsm")),
)

RELOAD = """
import sys
from paraview import simple
simple.LoadPlugin(sys.argv[1] + "/Lamina/Lamina.so", remote=False)
simple.LoadState(sys.argv[2])
audit = simple.FindSource("Audit")
audit.UpdatePipeline()
print("cells", audit.GetDataInformation().GetNumberOfCells())
"""


def main():
    os.makedirs(OUTPUT, exist_ok=True)
    state = os.path.join(OUTPUT, "state.pvsm")
    if os.path.exists(state):
        os.remove(state)
    with tempfile.TemporaryDirectory() as home:
        said = play(home, PLUGINS, prepare(home, SOURCES, EVENTS), os.path.join(OUTPUT, "window.log"), lambda: os.path.isfile(state),
                    os.path.join(OUTPUT, "window.png"), SECONDS)
        check("critical:" not in said, said[:3000])
        check(os.path.isfile(state), f"no state was saved within {SECONDS} s; see {OUTPUT}/window.png\n{said[:2000]}")
        told = next((line for line in said.splitlines() if "cells," in line), "")
        check(told, f"the macro did not tell of a mesh:\n{said[:3000]}")
        cells = told.split(" cells,")[0].replace(",", "")
        script = os.path.join(home, "reload.py")
        with open(script, "w", encoding="utf-8") as file:
            file.write(RELOAD)
        done = subprocess.run(["pvpython", "--no-mpi", script, PLUGINS, state], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=SECONDS)
        check(f"cells {cells}" in done.stdout, f"the state makes another mesh than {cells} cells:\n{done.stdout}")
    print(told)
    print("the window's mesh comes back from its state")


if __name__ == "__main__":
    main()
