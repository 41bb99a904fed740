# SPDX-License-Identifier: BSD-3-Clause
"""Bad input to Utilities/mesh.sh: exit code, one line that names the cause, nothing left behind. Argument: the sources."""
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time

import numpy as np

ROOT = os.path.abspath(sys.argv[1])
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import files  # noqa: E402

SCRIPT = os.path.join(ROOT, "Utilities", "mesh.sh")
failures = []


def heart(edge=16):
    """Blood in tissue in background, as grey values."""
    grey = np.full((edge, edge, edge), 20, np.int16)
    grey[3:-3, 3:-3, 3:-3] = 85
    grey[6:-6, 6:-6, 6:-6] = 190
    return grey


def run(arguments, limit=None):
    def confine():
        if limit:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    return subprocess.run([SCRIPT] + arguments, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=250,
                          preexec_fn=confine)


def left_behind(output):
    return sorted(os.listdir(output)) if os.path.isdir(output) else []


def judge(name, code, text, output, words):
    lines = [line for line in text.splitlines() if "error" in line.lower()]
    problems = []
    if code <= 0:
        problems.append(f"exit code {code}")
    if len(lines) != 1:
        problems.append(f"{len(lines)} lines with an error")
    problems += [f"'{word}' is not said" for word in words if word not in (lines[0] if lines else "")]
    if "Traceback" in text:
        problems.append("a Python traceback")
    if left_behind(output):
        problems.append(f"left behind: {left_behind(output)}")
    print(f"{'ok' if not problems else 'FAILED'}: {name}: {lines[0] if lines else ''}", flush=True)
    if problems:
        failures.append(name)
        print("   ", "; ".join(problems), "\n", text)


def table(folder):
    edge = heart().shape[0]
    size = f"{edge} {edge} {edge}"
    good = files.meta(folder, "good.mha", data=heart(), sizes=size)
    labels = files.meta(folder, "labels.mha", data=np.digitize(heart(), [50, 150]).astype(np.int16), sizes=size)
    one = files.meta(folder, "one.mha", data=heart() * 0 + 1, sizes=size)
    negative = files.meta(folder, "negative.mha", data=heart() - 100, sizes=size)
    other = files.meta(folder, "other.mha")
    flat = files.meta(folder, "flat.mha", data=files.sample()[:1], sizes="6 5 1")
    colours = files.meta(folder, "rgb.mha", data=files.sample().tobytes() * 3, extra="ElementNumberOfChannels = 3\n")
    cut = files.shortened(good, 0.5, "cut.mha")
    text = files.write(folder, "text.nrrd", "no image")
    fraction = files.vti(folder, "fraction.vti", data=heart().astype(float) + 0.5)
    return [
        ("no file", ["missing.mha"], ["missing.mha", "no such file"]),
        ("not an image", [text], ["not an NRRD"]),
        ("2-D", [flat], ["2-D"]),
        ("components", [colours], ["3 components"]),
        ("constant", [one], ["constant", "every voxel is 1"]),
        ("truncated", [cut], ["truncated"]),
        ("labels of one value", [one, "--labels"], ["every voxel is 1"]),
        ("negative labels", [negative, "--labels"], ["-80"]),
        ("labels with fractions", [fraction, "--labels"], ["not whole numbers"]),
        ("order", [good, "--thresholds", "50,150,110"], ["out of order"]),
        ("range", [good, "--thresholds", "50,110,1500"], ["1500", "20 to 190"]),
        ("malformed thresholds", [good, "--thresholds", "50,x"], ["not a list of numbers"]),
        ("one threshold", [good, "--thresholds", "50"], ["two or three"]),
        ("negative threshold", [good, "--thresholds", "-20,215"], ["--thresholds=-20,215"]),
        ("labels and thresholds", [labels, "--labels", "--thresholds", "50,150"], ["exclude each other"]),
        ("mask of another size", [good, "--mask", other], ["6 x 5 x 4", "16 x 16 x 16"]),
        ("scan of another size", [good, "--grey", other], ["6 x 5 x 4", "16 x 16 x 16"]),
        ("no mask", [good, "--mask", "nowhere.mha"], ["nowhere.mha", "no such file"]),
        ("min size", [good, "--min-size", "0"], ["--min-size", "positive"]),
        ("max size", [good, "--max-size", "-1"], ["--max-size", "positive"]),
        ("min above max", [good, "--min-size", "3", "--max-size", "2"], ["above"]),
        ("layers", [good, "--layers", "0"], ["--layers", "at least 1"]),
        ("prism layers", [good, "--prism-layers", "0"], ["--prism-layers", "at least 1"]),
        ("growth", [good, "--growth", "0"], ["--growth", "positive"]),
        ("gradient", [good, "--gradient", "0"], ["--gradient", "positive"]),
        ("no memory", [good, "--memory", "0.001"], ["Mesh Estimate", "cells", "0.001 GiB are free"]),
        ("tiny sizes", [good, "--min-size", "0.0001", "--max-size", "0.0002"], ["Mesh Estimate", "larger sizes"]),
        ("scale", [good, "--scale", "nan"], ["--scale"]),
        ("unknown solid", [labels, "--labels", "--solid", "7"], ["--solid", "7", "1, 2"]),
        ("unknown fluid", [labels, "--labels", "--fluid", "9"], ["--fluid", "9", "1, 2"]),
        ("both", [labels, "--labels", "--solid", "1", "--fluid", "1"], ["both"]),
        ("border", [good, "--open-border", "sky"], ["sky"]),
        ("malformed cut", [good, "--cut", "1,2,3"], ["--cut", "origin and normal"]),
        ("negative cut", [good, "--cut", "-1,2,3,0,0,1"], ["--cut=-1,0,5,0,0,1"]),
        ("cut that misses", [good, "--cut", "99,99,99,0,0,1"], ["Vessel Cut", "misses the surface"]),
        ("border without mask", [good, "--open-border", "mask"], ["--mask"]),
        ("unknown format", [good, "--export", "abaqus,stl"], ["'stl' is not a format", "openfoam"]),
        ("names", [good, "--names", "1tissue"], ["1tissue", "not understood"]),
        ("unknown option", [good, "--frobnicate"], ["--frobnicate"]),
    ]


def stopped(folder):
    """Ctrl-C while the stages run."""
    image = files.meta(folder, "large.mha", data=heart(64), sizes="64 64 64")
    output = os.path.join(folder, "out-stopped")
    job = subprocess.Popen([SCRIPT, image, "--output", output], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                           start_new_session=True)
    text = ""
    while "Multimaterial" not in text:
        line = job.stdout.readline()
        if not line:
            break
        text += line
    os.killpg(job.pid, signal.SIGINT)
    since = time.monotonic()
    text += job.communicate(timeout=60)[0]
    judge("Ctrl-C", job.returncode, text, output, ["stopped on request"])
    if time.monotonic() - since > 10:
        failures.append("Ctrl-C took long")


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for number, (name, arguments, words) in enumerate(table(folder)):
            output = os.path.join(folder, f"out{number}")
            result = run(arguments + ["--output", output])
            judge(name, result.returncode, result.stdout, output, words)
        good = os.path.join(folder, "good.mha")
        result = run([good, "--output", good])
        judge("output is a file", result.returncode, result.stdout, "", ["is a file"])
        output = os.path.join(folder, "out-full")
        small = files.meta(folder, "small.mha", data=heart(14), sizes="14 14 14")
        result = run([small, "--output", output], limit=20000)
        judge("full disk", result.returncode, result.stdout, output, ["disk full"])
        stopped(folder)
    if failures:
        sys.exit(f"failed: {', '.join(failures)}")


if __name__ == "__main__":
    main()
