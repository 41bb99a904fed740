# SPDX-License-Identifier: BSD-3-Clause
"""The plugin loads, and every proxy stands in paraview.simple under its label, with working properties and named ports.

    pvpython TestPlugin.py PROXY_FOLDER
"""
import os
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

import lamina  # before any object of the plugin is looked at, or Python takes it for one of its base class
from paraview import simple

simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)

EXPECTED = {
    "MultimaterialMarchingCubes", "VolumeConservingSmoothing", "FeatureSize", "SurfaceRefinement", "LayeredTetrahedra",
    "PrismLayer", "CoreTetrahedra", "FluidSolidMesh", "MeshAudit", "PropagateMask",
    "PrismstoTetrahedra", "QuadraticCells", "RuleBasedFibers", "AbaqusWriter", "GmshWriter", "SU2Writer", "NastranWriter", "LSDynaWriter",
    "FEBioWriter", "CARPWriter", "OpenFOAMWriter", "SimVascularWriter", "FluidSolidExodusWriter", "VesselCut", "WallDepth", "MeshEstimate",
}


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def main():
    found = set()
    for path in sorted(pathlib.Path(sys.argv[1]).glob("*.xml")):
        proxy = ElementTree.parse(path).getroot().find("ProxyGroup/*[@class]")
        name = re.sub(r"\W", "", proxy.get("label"))
        found.add(name)
        check(hasattr(simple, name), f"{name} is not in paraview.simple")
        check(hasattr(lamina, proxy.get("class")), f"{proxy.get('class')} is not in the package lamina")
        instance = getattr(simple, name)()
        for prop in proxy:
            if prop.tag.endswith("Property"):
                check(prop.get("name") in instance.ListProperties(), f"{name}.{prop.get('name')} is missing")
        ports = [port.get("name") for port in proxy.iter("OutputPort")]
        for index, port in enumerate(ports):
            check(instance.SMProxy.GetOutputPortName(index) == port, f"{name}: port {index} is not named {port}")
        check(instance.GetClientSideObject().GetClassName() == proxy.get("class"), f"{name}: wrong class")
        simple.Delete(instance)
    check(EXPECTED <= found, f"missing: {EXPECTED - found}")
    print(f"{len(found)} proxies work: {', '.join(sorted(found))}")


if __name__ == "__main__":
    main()
