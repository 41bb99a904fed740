#!/usr/bin/env pvpython
# SPDX-License-Identifier: BSD-3-Clause
"""Audit a mesh from anywhere: Utilities/lamina-audit FILE [options] runs this under pvpython with the built plugin.

FILE is a .vtu of tetrahedra, prisms and pyramids, or a .vtp of triangles. Writes FILE's name with .audit.json and .audit.html, prints
the findings, and ends with 0 if there are none, 1 if there are, 2 for wrong options, 3 if the file cannot be audited.
"""
import argparse
import json
import os
import subprocess
import sys


def fail(message, code):
    sys.stdout.flush()
    with open(2, "w", closefd=False) as terminal:
        print(f"lamina-audit: error: {' '.join(str(message).split())}", file=terminal)
    os._exit(code)


class Parser(argparse.ArgumentParser):
    def error(self, message):
        fail(message, 2)


def parse():
    p = Parser(prog="lamina-audit", description="Audit a mesh (.vtu) or a surface (.vtp).", allow_abbrev=False)
    p.add_argument("file", help=".vtu or .vtp")
    p.add_argument("--surface", metavar="FILE", help="the surface (.vtp) that the mesh was made from")
    p.add_argument("--image", metavar="FILE", help="the image of materials (.vti) that the mesh was made from")
    p.add_argument("--scale", type=float, default=1.0, help="factor on surface and image to match the mesh (1)")
    p.add_argument("--output", metavar="DIR", help="where the report goes (beside FILE)")
    p.add_argument("--pictures", action="store_true", help="put pictures into the page (takes an X server, or xvfb-run)")
    options = p.parse_args()
    for name in (options.file, options.surface, options.image):
        if name and not os.path.isfile(name):
            fail(f"{name}: no such file", 3)
    if not options.file.lower().endswith((".vtu", ".vtp")):
        fail(f"{options.file}: neither a .vtu nor a .vtp", 3)
    if not options.scale > 0:
        fail(f"--scale {options.scale} must be above 0", 2)
    return options


def read(path):
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
    readers = {".vtu": vtkXMLUnstructuredGridReader, ".vtp": vtkXMLPolyDataReader, ".vti": vtkXMLImageDataReader}
    ending = os.path.splitext(path)[1].lower()
    if ending not in readers:
        fail(f"{path}: not one of {', '.join(readers)}", 3)
    reader = readers[ending]()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    reader.SetFileName(path)
    reader.Update()
    if errors or reader.GetErrorCode() or reader.GetOutput().GetNumberOfPoints() == 0:
        from lamina_files import EXPAT, appended_works
        fail(f"{path} cannot be read, or is empty" + ("" if appended_works() else f"; {EXPAT}"), 3)
    return reader.GetOutput()


def draw(path):
    """PNGs of the mesh, by another process: a broken X server must not cost the report."""
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "audit_picture.py")
    command = ["pvpython", "--no-mpi", script, path, path + ".audit.png"]
    if not os.environ.get("DISPLAY"):
        command = ["xvfb-run", "-a", "-n", str(100 + os.getpid() % 800), "-s", "-screen 0 1280x1024x24 -noreset"] + command
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600)
    return [path + ".audit.png"] if done.returncode == 0 and os.path.isfile(path + ".audit.png") else []


def main():
    options = parse()
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    from paraview import simple
    from lamina_page import page
    from lamina_pipeline import Failed, Pipeline, load_plugin, producer, report_of
    pipeline = Pipeline()
    try:
        load_plugin()
        stage = simple.MeshAudit(Input=producer(read(options.file)), SurfaceScale=options.scale)
        if options.surface:
            stage.Surface = producer(read(options.surface))
        if options.image:
            stage.Image = producer(read(options.image))
        pipeline.stage = "Mesh Audit"
        output, = pipeline.update(stage)
    except Failed as error:
        fail(error, 3)
    report = report_of(output, "Mesh Audit")
    folder = options.output or os.path.dirname(os.path.abspath(options.file))
    base = os.path.join(folder, os.path.basename(options.file))
    try:
        os.makedirs(folder, exist_ok=True)
        images = draw(os.path.abspath(options.file)) if options.pictures else []
        with open(base + ".audit.json", "w", encoding="utf-8") as file:
            json.dump(report, file, indent=1)
        with open(base + ".audit.html", "w", encoding="utf-8") as file:
            file.write(page(f"Audit of {os.path.basename(options.file)}", report, images))
        for image in images:
            os.remove(image)
    except OSError as error:
        fail(f"{folder}: {error.strerror}", 3)
    for finding in report["findings"]:
        print("finding:", finding)
    print(f"{base}.audit.html: {'passed' if report['passed'] else 'NOT passed'}, {len(report['findings'])} findings", flush=True)
    os._exit(0 if report["passed"] else 1)


if __name__ == "__main__":
    main()
