#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Build the filters against Debian's plain VTK, without ParaView, in a clean Debian, and run their tests there:
# Utilities/test-plain-vtk.sh FOLDER. FOLDER is that of test-package.sh, or another.
set -eu
here=$(dirname -- "$(readlink -f -- "$0")")
. "$here/clean-debian.sh"
clean_debian "$1" plain-vtk
inside apt-get install -y -q --no-install-recommends g++ cmake ninja-build libvtk9-dev python3-vtk9 python3-numpy libtet1.5-dev \
  libeigen3-dev libcgal-dev libgtest-dev nlohmann-json3-dev
keep_archives
mkdir "$clean/src"
tar cf - -C "$here/.." --exclude=./build --exclude=./.git --exclude=./demo-output . | tar xf - -C "$clean/src"
inside sh -c "cd /src && cmake --preset vtk && cmake --build --preset vtk"
inside sh -c "cd /src/build/vtk && ctest --output-on-failure -R 'Filter|Python' && cmake --install . --prefix /opt/lamina"
inside sh -c "rm -rf /src && mv /opt/lamina /opt/moved && PYTHONPATH=/opt/moved/lib/lamina python3 - " <"$here/../Testing/Python/TestPackage.py"
echo "the filters work over plain VTK"
