# SPDX-License-Identifier: BSD-3-Clause
"""The sizes of single materials through the proxy: set, written into a state, read back from it, cleared."""
import os
import sys
import tempfile

from paraview import simple

import lamina  # the plugin's own classes in Python


def check(condition, text):
    if not condition:
        sys.exit("FAILED: " + text)


def edges(proxy):
    proxy.UpdatePipeline()
    return proxy.PointData["TargetEdgeLength"].GetRange()


def main():
    simple.LoadPlugin(os.environ["LAMINA_PLUGIN"], remote=False)
    ball = simple.Sphere(ThetaResolution=40, PhiResolution=40)
    size = simple.FeatureSize(Input=ball, MinimumSize=0.01, MaximumSize=10, NodesPerCircumference=0)
    check(abs(edges(size)[0] - 1 / 3) < 0.01, f"diameter 1, six layers, anisotropy 2: {edges(size)}")
    size.MaterialSizings = [1, 4, 1, 0, 0]
    check(abs(edges(size)[0] - 1 / 4) < 0.01, f"four layers, anisotropy 1: {edges(size)}")
    check(isinstance(size.GetClientSideObject(), lamina.vtkFeatureSize), "the proxy stands for another class")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sizes.pvsm")
        simple.SaveState(path)
        simple.ResetSession()
        simple.LoadState(path)
    loaded = [p for (_, _), p in simple.GetSources().items() if p.GetXMLName() == "FeatureSize"]
    check(len(loaded) == 1, f"{len(loaded)} Feature Size in the state")
    check(list(loaded[0].MaterialSizings) == [1, 4, 1, 0, 0], f"the state holds {list(loaded[0].MaterialSizings)}")
    loaded[0].MaterialSizings = []
    check(abs(edges(loaded[0])[0] - 1 / 3) < 0.01, f"sizes were cleared: {edges(loaded[0])}")
    print("all holds")


if __name__ == "__main__":
    main()
