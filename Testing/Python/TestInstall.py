# SPDX-License-Identifier: BSD-3-Clause
"""What is installed: a tree that is moved and then runs a pipeline, with nothing of the build in it.

    TestInstall.py BUILD_FOLDER
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

BUILD = os.path.abspath(sys.argv[1])
PLUGIN = "lib/paraview-5.11/plugins/Lamina"
# Only inside the installed tree: what a user's own shell would not have.
CLEAN = {key: value for key, value in os.environ.items()
         if key not in ("LAMINA_PLUGIN", "LAMINA_BUILD_DIR", "PYTHONPATH", "LD_LIBRARY_PATH", "PV_PLUGIN_PATH")}

BY_ITSELF = """
from paraview.simple import *
assert "HeartPhantom" in globals(), "ParaView did not load the plugin by itself"
source = HeartPhantom(Resolution=32)
segmented = MultimaterialSegmentation(Input=source)
segmented.UpdatePipeline()
assert segmented.GetDataInformation().GetNumberOfPoints() > 10000
names = [segmented.PointData.GetArray(i).Name for i in range(segmented.PointData.GetNumberOfArrays())]
assert "MaterialIds" in names, names
"""

NO_BUILD = """
for line in open("/proc/self/maps"):
    assert sys.argv[1] not in line, "something of the build is loaded: " + line
"""


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def run(command, **more):
    environment = {**CLEAN, **more}
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=250, env=environment)
    check(done.returncode == 0, f"{' '.join(command)} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def script(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def files_of(tree):
    return sorted(os.path.relpath(os.path.join(folder, name), tree) for folder, _, names in os.walk(tree) for name in names)


def check_contents(tree):
    names = files_of(tree)
    for wanted in (f"{PLUGIN}/Lamina.so", f"{PLUGIN}/lamina-tetgen", f"{PLUGIN}/lamina/__init__.py", "bin/lamina-mesh",
                   "bin/lamina-audit", "bin/lamina-paraview", "share/lamina/scripts/image_to_mesh.py",
                   "share/lamina/macros/Mesh This Image.py", "share/lamina/macros/Look At This Segmentation.py",
                   "share/lamina/lamina-run.sh", "share/doc/lamina/copyright", "share/doc/lamina/filters/prism-layer.md"):
        check(wanted in names, f"{wanted} is not installed")
    for name in names:
        check(not name.endswith((".a", ".h", ".cmake", ".pyc")) and "LaminaFilterTests" not in name and "gtest" not in name,
              f"{name} is no use to a user")
    for name in names:
        path = os.path.join(tree, name)
        with open(path, "rb") as file:
            if file.read(4) != b"\x7fELF":
                continue
        entries = re.findall(r"\((?:RUNPATH|RPATH)\)\s+Library r\w*path: \[(.*)\]", run(["readelf", "-d", path], LC_ALL="C"))
        places = [place for entry in entries for place in entry.split(":") if place]
        check(all(place.startswith("$ORIGIN") for place in places), f"{name} looks for libraries in {places}")
    needed = run(["readelf", "-d", os.path.join(tree, PLUGIN, "Lamina.so")], LC_ALL="C")
    check("Qt5" not in needed, "Lamina.so needs Qt, which a server may lack")
    print(len(names), "files")


def main():
    with tempfile.TemporaryDirectory() as folder:
        first, tree = os.path.join(folder, "first"), os.path.join(folder, "moved here", "tree")
        run(["cmake", "--install", BUILD, "--prefix", first])
        os.makedirs(os.path.dirname(tree))
        shutil.move(first, tree)
        check_contents(tree)
        plugin = os.path.join(tree, PLUGIN)
        package = os.path.join(os.path.dirname(os.path.abspath(__file__)), "TestPackage.py")
        print(run(["pvpython", "--no-mpi", package, BUILD], PYTHONPATH=plugin).strip())
        run(["pvpython", "--no-mpi", script(folder, "itself.py", "import sys\n" + BY_ITSELF + NO_BUILD), BUILD], PV_PLUGIN_PATH=plugin)
        image, output = os.path.join(folder, "phantom.vti"), os.path.join(folder, "result")
        scripts = os.path.join(tree, "share/lamina/scripts")
        run(["pvpython", "--no-mpi", os.path.join(scripts, "heart_phantom.py"), image, "--resolution", "36"])
        text = run([os.path.join(tree, "bin/lamina-mesh"), image, "--output", output, "--layers", "2", "--prism-layers", "2"])
        check("the audit found nothing wrong" in text, text)
        text = run([os.path.join(tree, "bin/lamina-audit"), os.path.join(output, "mesh.vtu")])
        check(os.path.isfile(os.path.join(output, "mesh.vtu.audit.json")), text)
        wrong = subprocess.run([os.path.join(tree, "bin/lamina-mesh"), "--help"], stdout=subprocess.PIPE, text=True, env=CLEAN,
                               timeout=60)
        check(wrong.stdout.startswith("usage: lamina-mesh"), wrong.stdout[:200])
        other = os.path.join(folder, "lib", "paraview-9.9", "plugins")
        shutil.copytree(plugin, os.path.join(other, "Lamina"))
        bad = subprocess.run(["pvpython", "--no-mpi", os.path.join(scripts, "heart_phantom.py"), image], text=True, timeout=60,
                             env={**CLEAN, "LAMINA_PLUGIN": os.path.join(other, "Lamina", "Lamina.so")},
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        check(bad.returncode != 0 and "built for ParaView 9.9, this is ParaView 5.11" in bad.stdout, bad.stdout)
    print("the moved tree works")


if __name__ == "__main__":
    main()
