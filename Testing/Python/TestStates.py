# SPDX-License-Identifier: BSD-3-Clause
"""A state (.pvsm, .py) and a trace of all filters come back, in a new process, with the same properties and the same results.

    pvpython TestStates.py PROXY_FOLDER
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import lamina  # noqa: F401  before any object of the plugin is looked at
from digests import digest
from paraview import simple, smstate, smtrace

simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)

EDIT = json.dumps({"shape": "sphere", "center": [60, 60, 60], "radius": 6, "to": 1})


def build():
    """Every filter at least once, none of them all at its defaults."""
    s = simple
    port = s.OutputPort
    phantom = s.HeartPhantom(registrationName="HeartPhantom", Resolution=40, Noise=8.0, Seed=3)
    mask = s.PropagateMask(registrationName="PropagateMask", Input=phantom, Mask=port(phantom, 1), SliceAxis="K", MaximumSlices=2)
    labels = s.MultimaterialSegmentation(registrationName="MultimaterialSegmentation", Input=phantom, MinimumVoxels=20,
                                         Thresholds=[48.0, 112.0, 152.0], SmoothingSweeps=1)
    edited = s.ReassignVoxels(registrationName="ReassignVoxels", Input=labels, Shape="None", Edits=[EDIT], ForbiddenContacts=[0, 2])
    cubes = s.MultimaterialMarchingCubes(registrationName="MultimaterialMarchingCubes", Input=edited, GreyImage=phantom, OpenMaterials=[2])
    smooth = s.VolumeConservingSmoothing(registrationName="VolumeConservingSmoothing", Input=cubes, Sweeps=12)
    sized = s.FeatureSize(registrationName="FeatureSize", Input=smooth, Layers=2, Gradient=0.4)
    fine = s.SurfaceRefinement(registrationName="SurfaceRefinement", Input=sized, Iterations=4)
    s.MeshEstimate(registrationName="MeshEstimate", Input=sized, Layers=2, PrismLayers=3, MemoryLimit=100.0)
    solid = s.LayeredTetrahedra(registrationName="LayeredTetrahedra", Input=fine, Layers=2, SolidMaterials=[1])
    prisms = s.PrismLayer(registrationName="PrismLayer", Input=fine, Layers=3, GrowthRatio=1.3)
    core = s.CoreTetrahedra(registrationName="CoreTetrahedra", Input=port(prisms, 1), RadiusEdgeRatio=1.5)
    mesh = s.FluidSolidMesh(registrationName="FluidSolidMesh", Input=[solid, prisms, core], Surface=fine, Scale=0.001, Unit="m",
                            Names="1=tissue; 2=blood")
    audit = s.MeshAudit(registrationName="MeshAudit", Input=mesh, Surface=fine, SurfaceScale=0.001, QualityGate=0.05)
    tets = s.PrismstoTetrahedra(registrationName="PrismsToTetrahedra", Input=mesh)
    s.QuadraticCells(registrationName="QuadraticCells", Input=tets, Surface=smooth, SurfaceScale=0.001, LargestOffset=0.2)
    s.RuleBasedFibers(registrationName="RuleBasedFibers", Input=tets, EndocardialHelixAngle=50.0, MuscleMaterials=[1])
    s.WallDepth(registrationName="WallDepth", Input=tets, InnerWalls="1-2")
    s.VesselCut(registrationName="VesselCut", Input=smooth, Origin=[52.0, 45.0, 68.0], Normal=[0.3, -0.1, 1.0], Name="top")
    return [mask, audit]


def text_of(value):
    """Values as text; of other proxies their names, as objects differ from process to process."""
    if hasattr(value, "SMProxy"):
        return value.SMProxy.GetXMLName()
    if isinstance(value, str) or not hasattr(value, "__len__"):
        return str(value)
    return [text_of(entry) for entry in value]


def facts():
    """Of every source: its properties and the sums of its outputs."""
    found = {}
    for (name, _), source in sorted(simple.GetSources().items()):
        source.UpdatePipeline()
        algorithm = source.GetClientSideObject()
        # What only mirrors the server (...Held) is fetched when a command asks for it.
        values = {p: text_of(source.GetPropertyValue(p)) for p in sorted(source.ListProperties()) if not p.endswith("Held")}
        outputs = []
        for port in range(algorithm.GetNumberOfOutputPorts()):
            data = algorithm.GetOutputDataObject(port)
            outputs.append(digest(data) if data.IsA("vtkDataSet") or data.IsA("vtkTable") else data.GetClassName())
        found[name] = {"class": algorithm.GetClassName(), "properties": values, "outputs": outputs}
    return found


def compare(kind, path, wanted_file):
    """Run in a process of its own."""
    if kind == "pvsm":
        simple.LoadState(path)
    else:
        with open(path, encoding="utf-8") as file:
            exec(compile(file.read(), path, "exec"), {"__name__": "replayed"})
    found = facts()
    with open(wanted_file, encoding="utf-8") as file:
        wanted = json.load(file)
    wrong = []
    for name, fact in wanted.items():
        if name not in found:
            wrong.append(f"{name} is missing; there are {sorted(found)}")
            continue
        for part in ("class", "outputs"):
            if found[name][part] != fact[part]:
                wrong.append(f"{name}: {part} {found[name][part]} for {fact[part]}")
        for prop, value in fact["properties"].items():
            if found[name]["properties"].get(prop) != value:
                wrong.append(f"{name}.{prop} is {found[name]['properties'].get(prop)}, was {value}")
    for text in wrong:
        print("FAILED:", kind, text)
    print(f"{kind}: {len(wanted)} sources, {len(wrong)} differences")
    sys.exit(1 if wrong else 0)


def main():
    if sys.argv[1] == "--compare":
        compare(*sys.argv[2:5])
    with tempfile.TemporaryDirectory() as folder:
        smtrace.start_trace(preamble="from paraview.simple import *\n")
        build()
        trace = smtrace.stop_trace()
        wanted = facts()
        kinds = {"pvsm": os.path.join(folder, "state.pvsm"), "py": os.path.join(folder, "state.py"),
                 "trace": os.path.join(folder, "trace.py")}
        simple.SaveState(kinds["pvsm"])
        for kind, text in (("py", smstate.get_state()), ("trace", trace)):
            with open(kinds[kind], "w", encoding="utf-8") as file:
                file.write(text)
        facts_file = os.path.join(folder, "facts.json")
        with open(facts_file, "w", encoding="utf-8") as file:
            json.dump(wanted, file)
        listed = {fact["class"] for fact in wanted.values()}
        for path in sorted(pathlib.Path(sys.argv[1]).glob("*.xml")):
            proxy = ElementTree.parse(path).getroot().find("ProxyGroup/*[@class]")
            if proxy.tag != "WriterProxy" and proxy.get("class") not in listed:
                sys.exit(f"FAILED: {proxy.get('label')} is not part of this test")
        failed = [kind for kind, path in kinds.items()
                  if subprocess.run(["pvpython", "--no-mpi", __file__, "--compare", kind, path, facts_file], timeout=250).returncode]
        if failed:
            if os.environ.get("LAMINA_KEEP"):
                subprocess.run(["cp", "-r", folder, os.environ["LAMINA_KEEP"]], check=True)
            sys.exit(f"FAILED: {', '.join(failed)} did not come back the same")


if __name__ == "__main__":
    main()
