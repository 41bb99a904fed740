# SPDX-License-Identifier: BSD-3-Clause
"""The stages in order, as image_to_mesh.py runs them: errors become exceptions, results appear when all is done."""
import json
import os
import resource
import shutil
import signal
import sys
import tempfile
import time

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

from lamina_files import prepare
from lamina_guard import SCRATCH, STOPPED
from lamina_images import ImageError, read_image, scalars_of
from lamina_plugin import Failed, load_plugin

WRITERS = {".vti": vtkXMLImageDataWriter, ".vtp": vtkXMLPolyDataWriter, ".vtu": vtkXMLUnstructuredGridWriter}


def peak_memory():
    """The most memory this process or one it started has held so far, in MB."""
    return max(resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)) / 1024


class Pipeline:
    def __init__(self, tell=lambda stage: None):
        self.tell = tell
        self.stage = "start"
        self.stages = []
        self.stopped = False
        self.silence, self.silent_after = 0.0, ""
        self.scratch = None
        self.running = None
        # pvpython prints through VTK's window of messages, which is caught here: print past it.
        sys.stdout = open(1, "w", buffering=1, closefd=False)
        sys.stderr = open(2, "w", buffering=1, closefd=False)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # warnings are told below, once
        self.catch_messages()

    # Running one stage -----------------------------------------------------------------------------------------------

    def catch_messages(self):
        self.messages = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.messages)

    def begin(self, name):
        self.stage = name
        self.tell(name)
        self.since = time.monotonic()
        self.silence, self.silent_after = 0.0, ""
        if self.stopped:
            raise Failed(name, "stopped on request; nothing was written", STOPPED)
        print(f"{name} ...", flush=True)

    def end(self, **counts):
        seconds = time.monotonic() - self.since
        entry = {"stage": self.stage, "seconds": round(seconds, 3), "longestSilence": round(self.silence, 3),
                 "silentAfter": self.silent_after, "peakMemoryMB": round(peak_memory(), 1), **counts}
        self.stages.append(entry)
        text = ", ".join(f"{key} {value:,}" if isinstance(value, int) else f"{key} {value}"
                         for key, value in counts.items() if isinstance(value, (int, float, str)))
        print(f"  {seconds:.1f} s{'; ' + text if text else ''}", flush=True)

    def stop(self, *_):
        self.stopped = True
        if self.running:
            self.running.SetAbortExecute(1)

    def update(self, proxy, ports=(0,)):
        """Run a filter; its errors end the work. Returns the outputs."""
        algorithm = proxy.GetClientSideObject()
        errors = []

        @calldata_type(VTK_STRING)
        def on_error(_, __, text):
            errors.append(text)

        heard, last = time.monotonic(), "the start"

        def listen():
            """How long it took to hear of the stage again: as long may it take to stop it."""
            nonlocal heard
            now = time.monotonic()
            if now - heard > self.silence:
                self.silence, self.silent_after = now - heard, last
            heard = now

        def on_progress(*_):
            nonlocal last
            listen()
            last = algorithm.GetProgressText() or ""
            # Running Python here also gives Ctrl-C its turn.
            if self.stopped:
                algorithm.SetAbortExecute(1)
            if sys.stdout.isatty():
                print(f"  {100 * algorithm.GetProgress():3.0f} % {algorithm.GetProgressText() or '':60}", end="\r", flush=True)
        tags = [(source, source.AddObserver(event, call)) for source, event, call in (
            (algorithm, "ErrorEvent", on_error), (algorithm.GetExecutive(), "ErrorEvent", on_error),
            (algorithm, "ProgressEvent", on_progress))]
        self.catch_messages()
        self.running = algorithm
        proxy.UpdatePipeline()
        listen()
        self.running = None
        for source, tag in tags:
            source.RemoveObserver(tag)
        if self.stopped:
            raise Failed(self.stage, "stopped on request; nothing was written", STOPPED)
        if errors:
            raise Failed(self.stage, plain(errors[0]))
        if "ERROR" in self.messages.GetOutput():
            raise Failed(self.stage, plain(self.messages.GetOutput()))
        for line in self.messages.GetOutput().splitlines():
            if line.strip() and "Warning: In" not in line:
                print(f"  warning: {plain(line)}", file=sys.stderr, flush=True)
        return [algorithm.GetOutputDataObject(port) for port in ports]

    def run_stage(self, title, proxy, port=0, may_be_empty=False):
        self.begin(title)
        output, = self.update(proxy, (port,))
        if output.GetNumberOfPoints() == 0 and not may_be_empty:
            raise Failed(title, "made nothing; is there anything of that material in the image?")
        counts = {"points": output.GetNumberOfPoints()}
        if not output.IsA("vtkImageData"):
            counts["cells"] = output.GetNumberOfCells()
        report = report_of(output, title)
        self.end(**counts, **({"report": report} if report else {}))
        if report and report.get("summary"):
            print(f"  {report['summary']}", flush=True)
        return output

    # The work ----------------------------------------------------------------------------------------------------------

    def run(self, options):
        from lamina_results import Results
        signal.signal(signal.SIGINT, self.stop)
        self.begin("Reading")
        self.results = Results(self, options)
        image = read_image(options.input)
        mask = read_mask(options.mask, image)
        self.grey = read_image(options.grey) if options.grey else None
        self.end(voxels=image.GetNumberOfPoints(), size=" x ".join(str(n) for n in image.GetDimensions()))
        load_plugin()
        labels = self.take_labels(image, mask) if options.labels else self.segment(image, mask, options)
        solid, fluid = self.choose(labels, options)
        surface = self.make_surface(labels, mask, fluid, options)
        mesh = self.fill(surface, solid, fluid, options)
        audit = simple.MeshAudit(Input=mesh, Surface=surface, Image=producer(labels), SurfaceScale=options.scale)
        grid = self.run_stage("Mesh Audit", audit)
        self.results.finish(labels, output_of(surface), grid, solid, fluid)

    def take_labels(self, image, mask):
        self.begin("Labels")
        values = scalars_of(image)
        if values.dtype.kind == "f" and not (np.isfinite(values).all() and (values == np.floor(values)).all()):
            raise Failed("Labels", "the image holds values that are not whole numbers; leave --labels out for a grey image")
        if values.min() < 0 or values.max() > 65535:
            raise Failed("Labels", f"the image holds labels from {values.min():g} to {values.max():g}; "
                         "material ids are 0 to 65535")
        ids = values.astype(np.int32)
        if mask is not None:
            ids = np.where(scalars_of(mask) == 1, ids, 0).astype(np.int32)
        if ids.min() == ids.max():
            raise Failed("Labels", f"every voxel has the label {ids.flat[0]}; there is no interface to mesh")
        labels = vtkImageData()
        labels.CopyStructure(image)
        array = numpy_to_vtk(ids.ravel(), deep=True)
        array.SetName("MaterialIds")
        labels.GetPointData().SetScalars(array)
        self.end(materials=int(np.count_nonzero(np.unique(ids))))
        return labels

    def segment(self, image, mask, options):
        stage = simple.MultimaterialSegmentation(Input=producer(image))
        if mask is not None:
            stage.Mask = producer(mask)
        stage.Thresholds = options.thresholds or []  # none: from the histogram
        stage.OpenAtImageBorder = int("image" in options.open_border)
        stage.OpenAtMaskBorder = int("mask" in options.open_border)
        return self.run_stage("Multimaterial Segmentation", stage)

    def choose(self, labels, options):
        """Which materials are solid and which fluid. What is named must be there; defaults need not."""
        present = [int(m) for m in np.unique(scalars_of_labels(labels)) if m > 0]
        for name, asked in (("--solid", options.solid), ("--fluid", options.fluid)):
            for material in asked or []:
                if material not in present:
                    raise Failed("Materials", f"{name} names material {material}, which the image lacks; "
                                 f"it has {', '.join(map(str, present)) or 'none'}")
        fluid = options.fluid if options.fluid is not None else \
            [m for m in (2,) if m in present and m not in (options.solid or [])]
        solid = [m for m in present if m not in fluid]
        for what, materials in (("solid", solid), ("fluid", fluid)):
            print(f"  {what}: {', '.join(map(str, materials)) or 'none, that part of the mesh stays empty'}", flush=True)
        return solid, fluid

    def make_surface(self, labels, mask, fluid, options):
        cubes = simple.MultimaterialMarchingCubes(Input=producer(labels), OpenMaterials=fluid)
        opened = bool(fluid)
        cubes.OpenAtImageBorder = int(opened and "image" in options.open_border)
        if opened and "mask" in options.open_border:
            cubes.Mask = producer(mask)
            cubes.OpenAtMaskBorder = 1
        if self.grey is not None:
            cubes.GreyImage = producer(self.grey)
        self.run_stage("Multimaterial Marching Cubes", cubes)
        smooth = simple.VolumeConservingSmoothing(Input=cubes, Sweeps=options.smoothing_sweeps)
        self.run_stage("Volume-Conserving Smoothing", smooth)
        for origin, normal, name in options.cut:
            smooth = simple.VesselCut(Input=smooth, Origin=origin, Normal=normal, Name=name, OpenMaterials=fluid)
            self.run_stage("Vessel Cut", smooth)
        size = simple.FeatureSize(Input=smooth, Layers=options.layers, Anisotropy=options.anisotropy,
                                  MinimumSize=options.min_size or 0, MaximumSize=options.max_size or 0,
                                  Gradient=options.gradient)
        self.run_stage("Feature Size", size)
        self.estimate(size, fluid, options)
        refine = simple.SurfaceRefinement(Input=size, MemoryLimit=options.memory or 0)
        self.run_stage("Surface Refinement", refine)
        return refine

    def estimate(self, size, fluid, options):
        """Tell what is to come; end here if the machine cannot hold it."""
        self.begin("Mesh Estimate")
        stage = simple.MeshEstimate(Input=size, FluidMaterials=fluid, Layers=options.layers,
                                    PrismLayers=options.prism_layers, MemoryLimit=options.memory or 0)
        table, = self.update(stage)
        report = report_of(table, self.stage)
        cells = float(f"{report['cells']:.2g}")
        what = f"about {cells:,.0f} cells, {report['memoryMB'] / 1024:.2g} GiB at the peak"
        self.end(estimate=what, report=report)
        if not report["fits"]:
            raise Failed(self.stage, f"the mesh would take {what}, but {report['freeMB'] / 1024:.2g} GiB are free: ask for larger sizes (--min-size, --max-size) or fewer layers, or raise --memory if you know better")

    def fill(self, surface, solid, fluid, options):
        parts = []
        if solid:
            tets = simple.LayeredTetrahedra(Input=surface, SolidMaterials=solid, FluidMaterials=fluid,
                                            Layers=options.layers, Anisotropy=options.anisotropy,
                                            MemoryLimit=options.memory or 0)
            self.run_stage("Layered Tetrahedra", tets)
            parts.append(tets)
        if fluid:
            prisms = simple.PrismLayer(Input=surface, FluidMaterials=fluid, Layers=options.prism_layers,
                                       GrowthRatio=options.growth, MemoryLimit=options.memory or 0)
            self.run_stage("Prism Layer", prisms)
            core = simple.CoreTetrahedra(Input=simple.OutputPort(prisms, 1), MemoryLimit=options.memory or 0)
            self.run_stage("Core Tetrahedra", core)
            parts += [prisms, core]
        mesh = simple.FluidSolidMesh(Input=parts, Surface=surface, Scale=options.scale, Unit=options.unit, Names=options.names,
                                     InterfaceNodes="Doubled" if options.doubled_nodes else "Shared",
                                     FluidMaterials=fluid or [2])
        self.run_stage("Fluid-Solid Mesh", mesh)
        return mesh

    # Results -----------------------------------------------------------------------------------------------------------

    def scratch_folder(self, output):
        """A folder beside the results, so that renaming is all that is left to do at the end."""
        try:
            os.makedirs(output, exist_ok=True)
            self.scratch = tempfile.mkdtemp(prefix=f"{SCRATCH}{os.getpid()}-", dir=output)
        except OSError as error:
            raise Failed("output", f"{output} cannot be written: {error.strerror}; choose another --output") from None
        return self.scratch

    def write(self, data, name):
        path = os.path.join(self.scratch, name)
        writer = WRITERS[os.path.splitext(name)[1]]()
        failures = []
        writer.AddObserver("ErrorEvent", lambda *_: failures.append(1))
        writer.SetFileName(path)
        writer.SetInputData(data)
        prepare(writer)
        written = writer.Write()
        if not written or failures or writer.GetErrorCode() or not os.path.isfile(path):
            raise Failed("Writing", f"{name} could not be written; is the disk full?")

    def clean(self):
        if self.scratch:
            shutil.rmtree(self.scratch, ignore_errors=True)
            self.scratch = None


# Small helpers ----------------------------------------------------------------------------------------------------------

def plain(message):
    """VTK's error text without file, line and address."""
    lines = [line for line in message.splitlines()
             if line.strip() and not line.lstrip().startswith(("ERROR: In", "Warning: In"))]
    text = " ".join(lines)
    return text.split("): ", 1)[1].strip() if text.lstrip().startswith("vtk") and "): " in text else text.strip()


def producer(data):
    source = simple.PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def output_of(proxy, port=0):
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def scalars_of_labels(labels):
    ni, nj, nk = labels.GetDimensions()
    return vtk_to_numpy(labels.GetPointData().GetArray("MaterialIds")).reshape(nk, nj, ni)


def report_of(data, title):
    """What the stage itself has to tell."""
    name = "LaminaReport_" + "".join(c for c in title if c.isalnum())
    field = data.GetFieldData().GetAbstractArray(name)
    return json.loads(field.GetValue(0)) if field else None


def read_mask(path, image):
    """The mask as 0 and 1 on the image's grid."""
    if not path:
        return None
    mask = read_image(path, allow_constant=True)
    if mask.GetDimensions() != image.GetDimensions():
        a, b = (" x ".join(map(str, i.GetDimensions())) for i in (mask, image))
        raise ImageError(f"{path}: the mask has {a} voxels, the image {b}; resample the mask onto the image")
    inside = (scalars_of(mask) == 1).astype(np.uint8)
    if not inside.any():
        raise ImageError(f"{path}: the mask is 1 nowhere; mark the region of interest with 1")
    result = vtkImageData()
    result.CopyStructure(mask)
    array = numpy_to_vtk(inside.ravel(), deep=True)
    array.SetName("Mask")
    result.GetPointData().SetScalars(array)
    return result
