#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Install what is missing, build, mesh the heart phantom and leave mesh, surface, report and pictures in demo-output.
# LAMINA_DEMO_RESOLUTION sets the phantom's voxels along its longest axis (120).
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
output=$root/demo-output
"$root/Utilities/build.sh"
mkdir -p "$output"
LAMINA_PLUGIN=$(find "$root/build/release/lib" -name Lamina.so | head -n 1)
PYTHONDONTWRITEBYTECODE=1
export LAMINA_PLUGIN PYTHONDONTWRITEBYTECODE
pvpython --no-mpi "$root/Examples/heart_phantom.py" "$output/phantom.vti" --resolution "${LAMINA_DEMO_RESOLUTION:-120}"
"$root/Utilities/mesh.sh" "$output/phantom.vti" --output "$output" --pictures
echo "Pictures: $(cd "$output" && echo *.png)"
