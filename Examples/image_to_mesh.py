#!/usr/bin/env pvpython
# SPDX-License-Identifier: BSD-3-Clause
"""From one 3-D image to one fluid-solid mesh: labels.vti, surface.vtp, mesh.vtu and report.json.

    Utilities/mesh.sh INPUT --output DIR [options]

runs this file under pvpython with the built plugin; `--help` lists the options. Lengths are in the image's unit.
"""
import argparse
import math
import os
import sys


class Parser(argparse.ArgumentParser):
    def error(self, message):
        if "--thresholds" in message and "expected one argument" in message:
            message += "; negative values need an equals sign: --thresholds=-20,215"
        if "--cut" in message and "expected one argument" in message:
            message += "; negative values need an equals sign: --cut=-1,0,5,0,0,1"
        fail("options", message, code=2)


def fail(stage, message, code=1):
    """End with one line: which stage, what, where, what to do."""
    text = " ".join(str(message).split())
    sys.stdout.flush()
    with open(2, "w", closefd=False) as terminal:  # pvpython's own stderr may lead elsewhere
        print(f"image_to_mesh: error: {stage}: {text}", file=terminal)
    sys.exit(code)


def numbers(text):
    try:
        values = [float(word) for word in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a list of numbers such as 50,110,150")
    if not all(math.isfinite(value) for value in values):
        raise argparse.ArgumentTypeError(f"'{text}' holds a value that is not finite")
    return values


def ids(text):
    try:
        values = [int(word) for word in text.split(",")] if text else []
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a list of material ids such as 1,3")
    if any(not 1 <= value <= 65535 for value in values):
        raise argparse.ArgumentTypeError(f"'{text}': material ids are 1 to 65535 (0 is background)")
    return values


def real(least, inclusive, what):
    def convert(text):
        try:
            value = float(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"'{text}' is not a number")
        if not math.isfinite(value) or value < least or (value == least and not inclusive):
            raise argparse.ArgumentTypeError(f"{text} is out of range: {what}")
        return value
    return convert


def whole(least):
    def convert(text):
        try:
            value = int(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"'{text}' is not a whole number")
        if value < least:
            raise argparse.ArgumentTypeError(f"{text} is out of range: it must be at least {least}")
        return value
    return convert


def borders(text):
    words = [word for word in text.split(",") if word]
    for word in words:
        if word not in ("image", "mask"):
            raise argparse.ArgumentTypeError(f"'{word}' is not a border: say image, mask or both")
    return words


def cut(text):
    """Origin, normal and name of a plane that cuts a vessel off."""
    words = text.split(",")
    if len(words) not in (6, 7):
        raise argparse.ArgumentTypeError(f"'{text}': give the plane's origin and normal, and perhaps a name: X,Y,Z,NX,NY,NZ,NAME")
    values = numbers(",".join(words[:6]))
    return values[:3], values[3:], words[6].strip() if len(words) > 6 else ""


def formats(text):
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    from lamina_export import FORMATS
    words = [word for word in text.lower().split(",") if word]
    for word in words:
        if word not in FORMATS:
            raise argparse.ArgumentTypeError(f"'{word}' is not a format: say one or more of {', '.join(FORMATS)}")
    return words


def parse(arguments):
    positive = real(0, False, "it must be positive")
    p = Parser(prog=os.environ.get("LAMINA_COMMAND", "mesh.sh"), description="From one 3-D image to one fluid-solid mesh.", allow_abbrev=False)
    p.add_argument("input", help=".vti .mha .mhd .nrrd .nhdr .nii .nii.gz")
    p.add_argument("--output", required=True, metavar="DIR", help="folder of the results")
    p.add_argument("--labels", action="store_true", help="INPUT holds material ids already")
    p.add_argument("--thresholds", type=numbers, metavar="A,B[,C]",
                   help="three: other, tissue, disputed, blood; two: other, tissue, blood (default: from the histogram)")
    p.add_argument("--mask", metavar="FILE", help="region of interest: where it is not 1, the material is 0")
    p.add_argument("--grey", metavar="FILE", help="scan of the same size (or INPUT itself): the surface cuts where its values say")
    p.add_argument("--solid", type=ids, metavar="IDS", help="solid materials (default 1, and all that are not fluid)")
    p.add_argument("--fluid", type=ids, metavar="IDS", help="fluid materials (default 2)")
    p.add_argument("--layers", type=whole(1), default=6, help="layers across a solid's wall (6)")
    p.add_argument("--anisotropy", type=positive, default=2.0, help="edge along the wall over layer thickness (2)")
    p.add_argument("--prism-layers", type=whole(1), default=5, help="layers of prisms in a fluid (5)")
    p.add_argument("--growth", type=positive, default=1.2, help="thickness of a prism over the one before it (1.2)")
    p.add_argument("--min-size", type=positive, help="least feature size (from the voxel size)")
    p.add_argument("--max-size", type=positive, help="largest feature size (from the voxel size)")
    p.add_argument("--gradient", type=positive, default=0.3, help="largest slope of the sizes (0.3)")
    p.add_argument("--smoothing-sweeps", type=whole(0), default=20, help="sweeps of smoothing (20)")
    p.add_argument("--scale", type=positive, default=1.0, help="factor on the coordinates of surface and mesh (1)")
    p.add_argument("--open-border", type=borders, default=[], metavar="image,mask", help="where fluids stay open")
    p.add_argument("--cut", type=cut, action="append", default=[], metavar="X,Y,Z,NX,NY,NZ[,NAME]",
                   help="cut a vessel off by a plane (origin, normal towards what goes); may be repeated")
    p.add_argument("--unit", default="", help="unit of length after --scale, for the files' heads (mm)")
    p.add_argument("--names", default="", metavar="LIST", help="such as \"1=tissue; 2=blood; wall_tissue_1=epicardium\"")
    p.add_argument("--doubled-nodes", action="store_true", help="fluid and solid with coincident nodes of their own")
    p.add_argument("--export", type=formats, default=[], metavar="NAME,...", help="formats of solvers, beside mesh.vtu")
    p.add_argument("--pictures", action="store_true", help="PNG pictures beside the results")
    p.add_argument("--threads", type=whole(1), help="threads (all cores)")
    p.add_argument("--memory", type=positive, metavar="GIB", help="memory that may be taken (what is free)")
    options = p.parse_args(arguments)
    check(p, options)
    return options


def check(p, o):
    """What options say about each other, before any work."""
    if o.labels and o.thresholds:
        p.error("--labels and --thresholds exclude each other: labels are taken as they are")
    if o.thresholds is not None:
        if len(o.thresholds) not in (2, 3):
            p.error(f"--thresholds has {len(o.thresholds)} values: give two or three")
        if any(a >= b for a, b in zip(o.thresholds, o.thresholds[1:])):
            p.error(f"--thresholds are out of order: {','.join(f'{t:g}' for t in o.thresholds)} must ascend")
    both = sorted(set(o.solid or []) & set(o.fluid or []))
    if both:
        p.error(f"material {both[0]} is named both in --solid and in --fluid")
    if o.min_size and o.max_size and o.min_size > o.max_size:
        p.error(f"--min-size {o.min_size:g} is above --max-size {o.max_size:g}")
    if "mask" in o.open_border and not o.mask:
        p.error("--open-border mask needs --mask FILE")
    if os.path.exists(o.output) and not os.path.isdir(o.output):
        p.error(f"--output {o.output} is a file, not a folder")


def main():
    options = parse(sys.argv[1:])
    if options.threads:
        # Read by VTK and by the filters when the first loop starts.
        os.environ["VTK_SMP_MAX_THREADS"] = str(options.threads)
        os.environ.setdefault("VTK_SMP_BACKEND_IN_USE", "STDThread" if options.threads > 1 else "Sequential")
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    from lamina_guard import guarded
    guarded(lambda tell: work(options, tell), options.output)


def work(options, tell):
    from lamina_images import ImageError
    from lamina_pipeline import Failed, Pipeline
    pipeline = Pipeline(tell)
    try:
        pipeline.run(options)
    except ImageError as error:
        fail("Reading", error)
    except Failed as error:
        fail(error.stage, error, error.code)
    except MemoryError:
        fail(pipeline.stage, "out of memory; use a coarser image or a larger --min-size")
    finally:
        pipeline.clean()


if __name__ == "__main__":
    main()
