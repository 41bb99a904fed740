# SPDX-License-Identifier: BSD-3-Clause
"""Measure Propagate Mask and print the table of docs/filters/propagate-mask.md.

    PYTHONPATH=PLUGIN_FOLDER:Testing/Python LAMINA_PLUGIN=PLUGIN_FOLDER/Lamina.so \
        pvpython MeasureMaskPropagation.py [SHARED_DATA] [--resolution N]...

Masks are drawn on every 6th, 12th and 20th slice, from the first slice on and from half a step on; Dice coefficients are
the mean of both. Exits 1 if the promises (see TestMaskPropagation.py) do not hold at every 12th slice.
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "Python"))
import masks  # noqa: E402  needs the path above


def images(data, resolutions):
    """Title, grey image, true mask, the Dice coefficient promised at every 12th slice."""
    for resolution in resolutions:
        grey, truths = masks.phantom(resolution)
        for name, truth in truths.items():
            yield f"phantom {resolution}, {name}", grey, truth, 0.97 if name == "heart" else 0.0
    found = masks.scan(data)
    if found:
        yield "heart_cta", found[0], found[1]["heart"], 0.92
    else:
        print(f"skipped: no heart_cta in '{data}' (LAMINA_SHARED_DATA)", flush=True)


def main():
    parser = argparse.ArgumentParser(description="Measure Propagate Mask.")
    parser.add_argument("data", nargs="?", default="")
    parser.add_argument("--resolution", type=int, action="append")
    options = parser.parse_args()
    broken = 0
    print("| image, mask | drawn | nearest slice | shape interpolation | registration | Propagate Mask | seconds |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    for title, grey, truth, least in images(options.data, options.resolution or [240, 120]):
        for step in (6, 12, 20):
            rows, seconds = zip(*(masks.measure(grey, truth, step, first) for first in (0, step // 2)))
            mean = [sum(column) / len(column) for column in zip(*rows)]
            numbers = " | ".join(f"{value:.4f}" for value in mean)
            print(f"| {title} | every {step}th | {numbers} | {max(seconds):.1f} |", flush=True)
            broken += step == 12 and any(row[3] < max(least, row[0], row[1]) for row in rows)
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()
