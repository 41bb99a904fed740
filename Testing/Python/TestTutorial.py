# SPDX-License-Identifier: BSD-3-Clause
"""The commands of docs/tutorial.md, in their order, in an empty folder: they end well, and flow and wall come out sensible.

    TestTutorial.py SOURCES PLUGINS_FOLDER    without OpenFOAM or CalculiX their parts are left out
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

SOURCES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:3])
SKIPPED = 77


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def blocks():
    """(language, text) of every fenced block, in order."""
    with open(os.path.join(SOURCES, "docs", "tutorial.md"), encoding="utf-8") as file:
        return re.findall(r"^```(\w+)\n(.*?)^```", file.read(), re.S | re.M)


def environment(folder):
    """As after installing: the commands on PATH, the plugin found by itself."""
    programs = os.path.join(folder, "programs")
    os.mkdir(programs)
    os.symlink(os.path.join(SOURCES, "Utilities", "mesh.sh"), os.path.join(programs, "lamina-mesh"))
    os.symlink(os.path.join(SOURCES, "Utilities", "lamina-audit"), os.path.join(programs, "lamina-audit"))
    result = {**os.environ, "PATH": programs + os.pathsep + os.environ["PATH"], "PV_PLUGIN_PATH": os.path.join(PLUGINS, "Lamina")}
    checker = shutil.which("checkMesh")
    if checker:  # OpenFOAM of Debian keeps its settings beside its programs' folder, and wants to be told
        result.setdefault("WM_PROJECT_DIR", os.path.join(os.path.dirname(os.path.dirname(checker)), "share", "openfoam"))
    return result


def run(text, folder, variables):
    done = subprocess.run(["sh", "-e", "-c", text], cwd=folder, env=variables, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=280)
    check(done.returncode == 0, f"{text}\nended with {done.returncode}:\n{done.stdout[-3000:]}")
    return done.stdout


def fastest(path):
    with open(path, encoding="ascii") as file:
        inside = file.read().split("internalField", 1)[1].split("boundaryField")[0]
    vectors = re.findall(r"\((\S+) (\S+) (\S+)\)", inside)
    return max(sum(float(v) ** 2 for v in vector) ** 0.5 for vector in vectors)


def main():
    left_out = []
    with tempfile.TemporaryDirectory() as folder:
        variables = environment(folder)
        work = os.path.join(folder, "work")
        os.mkdir(work)
        for language, text in blocks():
            if language == "python":
                name = re.match(r"# file: (\S+)\n", text).group(1)
                with open(os.path.join(work, name), "w", encoding="utf-8") as file:
                    file.write(text)
                continue
            needed = next((program for program in ("icoFoam", "ccx") if program in text and not shutil.which(program)), None)
            if needed:
                left_out.append(needed)
                continue
            print(run(text, work, variables)[-300:], flush=True)
        check(os.path.isfile(os.path.join(work, "result", "mesh.vtu.audit.html")), "no page of the audit")
        if "icoFoam" not in left_out:
            speed = fastest(os.path.join(work, "flow", "0.005", "U"))
            print(f"greatest speed {speed:.3g} m/s")
            check(0.1 < speed < 0.5, f"the fastest blood has {speed} m/s of 0.1 m/s that enter")
        if "ccx" not in left_out:
            with open(os.path.join(work, "wall.dat"), encoding="ascii") as file:
                rows = [line.split() for line in file if re.match(r"\s+\d+\s", line)]
            most = max(sum(float(v) ** 2 for v in row[1:4]) ** 0.5 for row in rows)
            print(f"greatest displacement {1000 * most:.3g} mm")
            check(1e-5 < most < 1e-3, f"the wall moves by {most} m")
    if left_out:
        print("left out, not installed:", ", ".join(left_out), "(Utilities/install-dependencies.sh --all)")
        sys.exit(SKIPPED)


if __name__ == "__main__":
    main()
