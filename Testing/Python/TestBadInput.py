# SPDX-License-Identifier: BSD-3-Clause
"""What a new user runs into: a plugin of another ParaView, a program that is missing or broken, Python without the module, a state file of
an older version, an image that is still being written, ParaView closed during a run.

    pvpython TestBadInput.py SOURCES
"""
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree

import files
import tiny
from paraview import simple

SOURCES = os.path.abspath(sys.argv[1])
PLUGIN = os.environ["LAMINA_PLUGIN"]
FOLDER = os.path.dirname(PLUGIN)

TINY = """
import sys
sys.path.insert(0, sys.argv[1])
import tiny
stages = tiny.pipeline()
stages["audit"].UpdatePipeline()
print("passed", stages["audit"].GetClientSideObject().GetPassed(), stages["audit"].GetDataInformation().GetNumberOfCells())
"""

LONG = """
import sys
sys.path.insert(0, sys.argv[1])
import tiny
core = tiny.pipeline()["core"]
core.MaximumEdge = 0.04
core.UpdatePipeline()
"""

WITHOUT_PLUGIN = """
import sys
from paraview import simple
simple.SetActiveSource(simple.Wavelet())
with open(sys.argv[1], encoding="utf-8") as file:
    exec(compile(file.read(), "macro", "exec"), {"__name__": "__main__"})
"""

LOAD = """
import os, sys
import lamina
from paraview import simple
simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)
simple.LoadState(sys.argv[1])
cubes = simple.FindSource("Interfaces")
cubes.UpdatePipeline()
print("loaded", cubes.ClusterPoints, list(cubes.OpenMaterials), cubes.GetDataInformation().GetNumberOfCells())
"""


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def run(command, **environment):
    kept = {name: value for name, value in {**os.environ, **environment}.items() if value is not None}
    done = subprocess.run(command, env=kept, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=250)
    return done.returncode, done.stdout


def script(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def check_version(folder):
    """Its folder tells for which ParaView it was built; the message names both."""
    other = os.path.join(folder, "lib", "paraview-5.99", "plugins", "Lamina")
    os.makedirs(other)
    os.symlink(PLUGIN, os.path.join(other, "Lamina.so"))
    image = files.meta(folder, "good.mha")
    code, said = run(["pvpython", os.path.join(SOURCES, "Examples", "image_to_mesh.py"), image, "--output", os.path.join(folder, "out")],
                     LAMINA_PLUGIN=os.path.join(other, "Lamina.so"))
    version = simple.GetParaViewVersion()
    check(code != 0 and "built for ParaView 5.99" in said and f"this is ParaView {version.major}.{version.minor}" in said, said)
    check(not os.path.exists(os.path.join(folder, "out")) or not os.listdir(os.path.join(folder, "out")), "something was written")
    print("a plugin of another ParaView: told which")


def check_program(folder):
    """Without lamina-tetgen TetGen runs inside; one that dies is an error that says so, and the pipeline stands."""
    copy = shutil.copytree(FOLDER, os.path.join(folder, "Lamina"), ignore=shutil.ignore_patterns("*.a", "*Tests", "cmake", "vtk"))
    program = os.path.join(copy, "lamina-tetgen")
    check(os.path.isfile(program), "no lamina-tetgen beside the plugin")
    command = ["pvpython", "--no-mpi", script(folder, "tiny_run.py", TINY), os.path.dirname(os.path.abspath(__file__))]
    there = {"LAMINA_PLUGIN": os.path.join(copy, "Lamina.so"), "PYTHONPATH": copy}
    os.remove(program)
    code, said = run(command, **there)
    check(code == 0 and "passed True" in said, f"without the program: {said}")
    with open(program, "w", encoding="ascii") as file:
        file.write("#!/bin/sh\nexit 3\n")
    os.chmod(program, 0o755)
    code, said = run(command, **there)
    check(code == 0 and "lamina-tetgen" in said and "passed True" not in said, f"with a broken program: {said}")
    print("a missing program: TetGen runs inside; a broken one:", re.search(r"[^:\n]*lamina-tetgen[^\n]*", said)[0].strip()[:120])


def check_module(folder):
    code, said = run(["pvpython", "-c", "from lamina import vtkMeshAudit"], PYTHONPATH=None)
    check(code != 0 and "No module named 'lamina'" in said, said)
    macro = os.path.join(SOURCES, "Plugin", "Macros", "Mesh This Image.py")
    code, said = run(["pvpython", "--no-mpi", script(folder, "no_plugin.py", WITHOUT_PLUGIN), macro], PYTHONPATH=None, PV_PLUGIN_PATH=None)
    check("the plugin Lamina is not loaded" in said, said)
    print("without the module, or the plugin: told")


def check_old_state(folder):
    """A state that lacks a property that came later, and has one that is gone, loads; what it lacks is the default."""
    source = simple.TrivialProducer(registrationName="Image")
    cubes = simple.MultimaterialMarchingCubes(registrationName="Interfaces", Input=simple.HeartPhantom(Resolution=20), OpenMaterials=[1])
    simple.Delete(source)
    labels = simple.MultimaterialSegmentation(Input=cubes.Input)
    cubes.Input = labels
    cubes.ClusterPoints = 0
    cubes.UpdatePipeline()
    cells = cubes.GetDataInformation().GetNumberOfCells()
    path = os.path.join(folder, "old.pvsm")
    simple.SaveState(path)
    tree = ElementTree.parse(path)
    proxy = next(p for p in tree.iter("Proxy") if p.get("type") == "MultimaterialMarchingCubes")
    gone = next(p for p in proxy if p.get("name") == "ClusterPoints")
    gone.set("name", "AsItWasOnceCalled")
    gone.set("id", gone.get("id").replace("ClusterPoints", "AsItWasOnceCalled"))
    tree.write(path)
    code, said = run(["pvpython", "--no-mpi", script(folder, "load.py", LOAD), path])
    check(code == 0 and f"loaded 1 [1] {cells}" in said, f"wanted {cells} cells: {said}")
    for name, proxy in list(simple.GetSources().items())[::-1]:
        simple.Delete(proxy)
    print("an older state loads; what it lacks is the default")


def check_unfinished_image(folder):
    """Half of a file, as a copy in progress shows it: refused with what is missing; the whole file is read."""
    whole = files.meta(folder, "whole.mha")
    command = ["pvpython", os.path.join(SOURCES, "Examples", "image_to_mesh.py"), "--output", os.path.join(folder, "unfinished")]
    for keep in (0.3, 0.9):
        code, said = run(command + [files.shortened(whole, keep, f"part{int(10 * keep)}.mha")])
        check(code != 0 and "truncated" in said and "copy" in said, said)
    check(not os.path.exists(os.path.join(folder, "unfinished", "mesh.vtu")), "a mesh was made of half an image")
    print("an image still being written: refused")


def child_of(process):
    """The running lamina-tetgen that the process started; None if there is none."""
    for entry in os.listdir("/proc"):
        try:
            with open(f"/proc/{entry}/stat", encoding="ascii", errors="replace") as file:
                name, rest = file.read().split("(", 1)[1].rsplit(")", 1)
        except (OSError, IndexError):
            continue
        if name == "lamina-tetgen" and int(rest.split()[1]) == process:
            return int(entry)
    return None


def runs(process):
    try:
        with open(f"/proc/{process}/stat", encoding="ascii", errors="replace") as file:
            return file.read().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


def check_closed(folder):
    """ParaView goes away in the middle of a run: so does the program it had started."""
    parent = subprocess.Popen(["pvpython", "--no-mpi", script(folder, "long.py", LONG), os.path.dirname(os.path.abspath(__file__))],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + 120
    child = None
    while child is None and time.monotonic() < end and parent.poll() is None:
        time.sleep(0.05)
        child = child_of(parent.pid)
    if child is None:
        parent.kill()
        sys.exit("FAILED: lamina-tetgen was never started")
    time.sleep(1)
    check(runs(child), "lamina-tetgen was done at once: this proves nothing")
    parent.kill()
    parent.wait()
    end = time.monotonic() + 20
    while runs(child) and time.monotonic() < end:
        time.sleep(0.1)
    if runs(child):
        os.kill(child, signal.SIGKILL)
        sys.exit("FAILED: lamina-tetgen went on without its ParaView")
    print("ParaView closed during a run: nothing goes on")


def main():
    sys.stdout = open(1, "w", buffering=1, closefd=False)
    for part in (check_version, check_program, check_module, check_old_state, check_unfinished_image, check_closed):
        with tempfile.TemporaryDirectory() as folder:
            part(folder)


if __name__ == "__main__":
    main()
