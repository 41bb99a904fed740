#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Mesh one image: Utilities/mesh.sh INPUT --output DIR [options]. Paths are relative to where you are.
# LAMINA_BUILD_DIR names another build than build/release.
set -u
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
build=${LAMINA_BUILD_DIR:-$root/build/release}
plugin=$(find "$build/lib" -name Lamina.so 2>/dev/null | head -n 1)
if [ -z "$plugin" ]; then
  echo "mesh.sh: error: no plugin in $build; build it: cd $root && cmake --preset release && cmake --build --preset release" >&2
  exit 3
fi
if ! command -v pvpython >/dev/null; then
  echo "mesh.sh: error: pvpython is missing; run Utilities/install-dependencies.sh" >&2
  exit 3
fi
LAMINA_PLUGIN=$plugin
PYTHONDONTWRITEBYTECODE=1
export LAMINA_PLUGIN PYTHONDONTWRITEBYTECODE
# One process, so no MPI (it would write files of its own).
exec pvpython --no-mpi "$root/Examples/image_to_mesh.py" "$@"
