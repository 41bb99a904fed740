#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Where the time of whole runs of Utilities/mesh.sh goes: seconds, share, elements a second and memory of each stage, and
the longest time between two words of its progress.

    python3 BenchmarkPipeline.py [--data SHARED_DATA] [--cases 60,120,240,heart_cta] [--threads 1,2] [--runs N] [--json FILE]
                                 [-- OPTIONS OF mesh.sh]

Numbers are resolutions of the heart phantom. Of several runs the one of the median time of the whole counts. Afterwards: how much
faster each stage is with more threads, and how its time grows with the elements (the slope of the straight line through the
logarithms; 1: in proportion). LAMINA_BUILD_DIR names another build than build/release.
"""
import argparse
import json
import math
import os
import pathlib
import statistics
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Python"))
from WriteFigures import measure, table  # noqa: E402


def inputs(names, data):
    """Name, image (or a resolution of the phantom), options of mesh.sh."""
    for name in names:
        if name.isdigit():
            yield f"phantom {name}", int(name), []
        elif name == "heart_cta":
            folder = pathlib.Path(data or "", "heart_cta")
            if not data or not (folder / "ct.mha").exists():
                print("heart_cta: left out, as there is no --data folder with it")
                continue
            yield name, str(folder / "ct.mha"), ["--mask", str(folder / "mask.mha"), "--thresholds=-20,215"]
        else:
            sys.exit(f"no case {name}: a resolution of the phantom, or heart_cta")


def elements(stage):
    """What a stage makes: cells, or the voxels of an image."""
    return stage.get("cells") or stage.get("voxels") or stage.get("points") or 0


def seconds(report):
    return sum(stage["seconds"] for stage in report["stages"])


def run(image, options, runs):
    """The report of the run whose time is the median."""
    reports = []
    for _ in range(runs):
        with tempfile.TemporaryDirectory() as folder:
            report, why = measure(str(ROOT), folder, image, options)
        if report is None:
            sys.exit(f"mesh.sh failed: {why}")
        reports.append(report)
    middle = statistics.median_low([seconds(report) for report in reports])
    return next(report for report in reports if seconds(report) == middle)


def rate(count, time):
    return f"{count / time:,.0f}" if time >= 0.05 and count else "-"


def tell(name, threads, report):
    whole = seconds(report)
    rows = [[stage["stage"], f"{stage['seconds']:.1f}", f"{100 * stage['seconds'] / whole:.0f} %", f"{elements(stage):,}",
             rate(elements(stage), stage["seconds"]), f"{stage['peakMemoryMB']:,.0f}", f"{stage['longestSilence']:.2f}"] for stage in report["stages"]]
    cells = max(elements(stage) for stage in report["stages"] if stage["stage"] == "Fluid-Solid Mesh")
    rows.append(["all", f"{whole:.1f}", "100 %", f"{cells:,}", rate(cells, whole),
                 f"{max(stage['peakMemoryMB'] for stage in report['stages']):,.0f}",
                 f"{max(stage['longestSilence'] for stage in report['stages']):.2f}"])
    print(f"## {name}, {threads} thread{'s' if threads > 1 else ''}\n")
    print("\n".join(table(["stage", "seconds", "share", "elements", "elements a second", "peak memory so far, MB", "longest silence, s"],
                          rows)), flush=True)


def times(report):
    """Seconds of each stage by name, and of all."""
    return {**{stage["stage"]: stage["seconds"] for stage in report["stages"]}, "all": seconds(report)}


def tell_speedups(name, by_threads):
    few, many = min(by_threads), max(by_threads)
    slow, fast = times(by_threads[few]), times(by_threads[many])
    rows = [[stage, f"{slow[stage]:.1f}", f"{fast[stage]:.1f}", f"{slow[stage] / fast[stage]:.2f}"]
            for stage in slow if stage in fast and fast[stage] >= 0.2]
    print(f"## {name}: {few} thread to {many}\n")
    print("\n".join(table(["stage", f"{few} thread, s", f"{many} threads, s", "times faster"], rows)), flush=True)


def slope(points):
    """Of the straight line that fits the logarithms best."""
    x = [math.log(p[0]) for p in points]
    y = [math.log(p[1]) for p in points]
    across = sum((a - statistics.mean(x)) ** 2 for a in x)
    return sum((a - statistics.mean(x)) * (b - statistics.mean(y)) for a, b in zip(x, y)) / across if across > 0 else math.nan


def tell_growth(reports):
    """Phantoms of several resolutions: seconds against what each stage made."""
    rows = []
    for name in [stage["stage"] for stage in reports[0]["stages"]]:
        points = [(elements(stage), stage["seconds"]) for report in reports for stage in report["stages"]
                  if stage["stage"] == name and elements(stage) and stage["seconds"] >= 0.05]
        if len(points) > 1:
            cost = [1e6 * time / count for count, time in points]
            rows.append([name, ", ".join(f"{c:.2f}" for c in cost), f"{slope(points):.2f}"])
    print("## Growth with the number of elements\n")
    print("\n".join(table(["stage", "microseconds an element", "exponent"], rows)), flush=True)


def main():
    parser = argparse.ArgumentParser(description="Where the time of mesh.sh goes.")
    parser.add_argument("--data", help="the folder of the shared data")
    parser.add_argument("--cases", default="60,120,240,heart_cta")
    parser.add_argument("--threads", default="1,2")
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--json", help="write all reports there")
    parser.add_argument("options", nargs="*", help="of mesh.sh, after --")
    asked = parser.parse_args()
    build = pathlib.Path(os.environ.get("LAMINA_BUILD_DIR", ROOT / "build" / "release"))
    plugins = sorted(build.glob("lib/**/Lamina.so"))
    if not plugins:
        sys.exit(f"no plugin in {build}: build it, or name another build by LAMINA_BUILD_DIR")
    os.environ.setdefault("LAMINA_PLUGIN", str(plugins[0]))  # for the program that writes the phantom
    threads = sorted(int(count) for count in asked.threads.split(","))
    found = {}
    phantoms = []
    for name, image, options in inputs(asked.cases.split(","), asked.data):
        found[name] = {}
        for count in threads:
            found[name][count] = run(image, [*options, "--threads", str(count), *asked.options], asked.runs)
            tell(name, count, found[name][count])
        if len(threads) > 1:
            tell_speedups(name, found[name])
        if isinstance(image, int):
            phantoms.append(found[name][threads[-1]])
    if len(phantoms) > 1:
        tell_growth(phantoms)
    if asked.json:
        pathlib.Path(asked.json).write_text(json.dumps({"cores": os.cpu_count(), "cases": found}, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
