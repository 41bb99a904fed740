# SPDX-License-Identifier: BSD-3-Clause
"""Propagate Mask held against what it promises: TestMaskPropagation.py CASE [SHARED_DATA].

CASE: phantom (the heart phantom's heart and its blood, drawn on every 12th slice), scan (a CT of a heart)."""
import os
import sys

import masks
import numpy as np

SKIPPED = 77


def show(name, first, row, seconds):
    print(f"{name}, every 12th slice from {first}: nearest {row[0]:.4f}, shape {row[1]:.4f}, registration {row[2]:.4f}, "
          f"automatic {row[3]:.4f}, {seconds:.1f} s", flush=True)


def case_phantom(_):
    grey, truths = masks.phantom(120)
    for name, least in (("heart", 0.985), ("blood", 0.96)):
        for first in (0, 6):
            row, seconds = masks.measure(grey, truths[name], 12, first)
            show(name, first, row, seconds)
            assert row[3] >= least, row
            assert row[3] > max(row[0], row[1]) + 0.02, row
    mask = masks.drawn_on(truths["heart"], 12, 6)
    results = []
    for threads in ("1", "2"):
        os.environ["VTK_SMP_MAX_THREADS"] = threads
        results.append(masks.propagate(grey, mask)[0])
    assert np.array_equal(*results), "the mask depends on the number of threads"


def case_scan(data):
    found = masks.scan(data)
    if not found:
        print(f"skipped: no heart_cta in '{data}' (LAMINA_SHARED_DATA)")
        sys.exit(SKIPPED)
    grey, truths = found
    for first in (0, 6):
        row, seconds = masks.measure(grey, truths["heart"], 12, first)
        show("scan", first, row, seconds)
        assert row[3] >= 0.94, row
        assert row[3] > max(row[0], row[1]) + 0.02, row


def main():
    globals()["case_" + sys.argv[1]](sys.argv[2] if len(sys.argv) > 2 else "")
    print("all holds")


if __name__ == "__main__":
    main()
