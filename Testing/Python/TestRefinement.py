# SPDX-License-Identifier: BSD-3-Clause
"""What Surface Refinement promises, on every image and surface: TestRefinement.py MEASURE_REFINEMENT SHARED_DATA NAME...

NAME: one of WriteRefinementInputs.py, or figures:NAME to print the figures of one without demanding them."""
import os
import subprocess
import sys
import tempfile

import lamina  # noqa: F401  before any object of the plugin is looked at

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Benchmarks"))
from WriteRefinementInputs import load_plugin, write  # noqa: E402

SKIPPED = 77
OWN = ("phantom60", "phantom120")


def main():
    program, data, *names = sys.argv[1:]
    load_plugin()
    failed, done = [], 0
    for name in names:
        base = name.split(":")[-1]
        if base not in OWN and not os.path.isdir(data):
            print(f"{base}: skipped, as there is no folder {data} (CMake variable LAMINA_SHARED_DATA)")
            continue
        with tempfile.TemporaryDirectory() as folder:
            path = write(base, data, folder)
            measured = subprocess.run([program, path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        print(f"{name}\n{measured.stdout}", flush=True)
        done += 1
        accepted = (0, 2) if name.startswith("figures:") else (0,)
        if measured.returncode not in accepted:
            failed.append(f"{name} (exit code {measured.returncode})")
    if failed:
        sys.exit("FAILED: " + ", ".join(failed))
    return 0 if done else SKIPPED


if __name__ == "__main__":
    sys.exit(main())
