#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Install what is missing and build the release preset. A second run builds nothing.
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
"$root/Utilities/install-dependencies.sh"
cd "$root"
mkdir -p build
if ! cmake --preset release "$@" >build/configure.log 2>&1; then
  cat build/configure.log >&2
  echo "build.sh: error: configuring failed, see above" >&2
  exit 1
fi
cmake --build --preset release
