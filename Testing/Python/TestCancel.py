# SPDX-License-Identifier: BSD-3-Clause
"""Stages stopped at random moments, 100 times: no crash, no leak, inputs as they were, and afterwards the same result as ever.

    pvpython TestCancel.py [TIMES]
"""
import random
import resource
import sys

import tiny
from digests import digest
from paraview import simple

RESOLUTION = 36


def chain():
    """All stages from the grey image to the audit."""
    s = simple
    grey = s.HeartPhantom(Resolution=RESOLUTION)
    labels = s.MultimaterialSegmentation(Input=grey)
    cubes = s.MultimaterialMarchingCubes(Input=labels, OpenMaterials=[2])
    smooth = s.VolumeConservingSmoothing(Input=cubes)
    sized = s.FeatureSize(Input=smooth)
    fine = s.SurfaceRefinement(Input=sized)
    solid = s.LayeredTetrahedra(Input=fine)
    prisms = s.PrismLayer(Input=fine)
    core = s.CoreTetrahedra(Input=s.OutputPort(prisms, 1))
    mesh = s.FluidSolidMesh(Input=[solid, prisms, core], Surface=fine)
    audit = s.MeshAudit(Input=mesh, Surface=fine)
    return [grey, labels, cubes, smooth, sized, fine, solid, prisms, core, mesh, audit]


class Stage:
    """One stage behind inputs that are ready: what it made first, and how often it told of its progress."""

    def __init__(self, proxy):
        self.algorithm = proxy.GetClientSideObject()
        self.name = proxy.GetXMLLabel()
        self.stop_at = 0
        self.moments = 0
        self.last = 0
        self.algorithm.AddObserver("ProgressEvent", self.on_progress)
        proxy.UpdatePipeline()
        self.told = self.moments
        self.result = self.digest()
        assert self.last == 1, f"{self.name} ends at {self.last}"

    def on_progress(self, *_):
        self.moments += 1
        self.last = self.algorithm.GetProgress()
        if self.moments == self.stop_at:
            self.algorithm.SetAbortExecute(1)

    def digest(self):
        return [digest(self.algorithm.GetOutputDataObject(port)) for port in range(self.algorithm.GetNumberOfOutputPorts())
                if self.algorithm.GetOutputDataObject(port).IsA("vtkDataSet")]

    def inputs(self):
        found = []
        for port in range(self.algorithm.GetNumberOfInputPorts()):
            for number in range(self.algorithm.GetNumberOfInputConnections(port)):
                data = self.algorithm.GetInputDataObject(port, number)
                found.append(digest(data) if data and data.IsA("vtkDataSet") else "")
        return found

    def run(self, stop_at):
        self.moments = 0
        self.stop_at = stop_at
        self.algorithm.SetAbortExecute(0)
        self.algorithm.Modified()
        self.algorithm.Update()
        self.algorithm.SetAbortExecute(0)


def main():
    times = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    proxies = chain()
    stages = [Stage(proxy) for proxy in proxies]
    for stage in stages:
        print(f"{stage.name}: {stage.told} moments", flush=True)
    chosen = random.Random(5)
    memory, stopped, late = 0, 0, 0
    for number in range(times):
        stage = chosen.choice(stages)
        before = stage.inputs()
        stage.run(chosen.randint(1, max(1, stage.told - 1)))
        assert stage.inputs() == before, f"{stage.name}: its input changed"
        done = stage.digest()
        empty = all(stage.algorithm.GetOutputDataObject(port).GetNumberOfPoints() == 0
                    for port in range(stage.algorithm.GetNumberOfOutputPorts())
                    if stage.algorithm.GetOutputDataObject(port).IsA("vtkPointSet"))
        # Asked at its last word, a stage may be done already: then all of the result is there.
        if done == stage.result:
            late += 1
        else:
            stopped += 1
            assert empty or stage.algorithm.GetOutputDataObject(0).IsA("vtkImageData"), f"{stage.name}: half a result"
        stage.run(0)
        assert stage.digest() == stage.result, f"{stage.name}: another result after a stop"
        if number == times // 3:
            memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / memory
    print(f"{stopped} stopped, {late} done before they heard of it; peak memory {grown:.3f} of that after a third", flush=True)
    assert stopped > times // 4, "hardly any was stopped"
    assert grown < 1.1, "memory grows"


if __name__ == "__main__":
    assert tiny  # loads the plugin
    main()
