#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Install a .deb of Lamina in a clean Debian and run it there: Utilities/test-package.sh DEB FOLDER
# FOLDER keeps the clean Debian and what apt fetched, so that a second run is faster.
set -eu
. "$(dirname -- "$(readlink -f -- "$0")")/clean-debian.sh"
if [ ! -f "$1" ]; then
  echo "skipped: there is no $1; run cpack in the build folder"
  exit 77
fi
deb=$(readlink -f -- "$1")
clean_debian "$2" package
cp "$deb" "$clean/root/lamina.deb"
inside apt-get install -y -q --no-install-recommends /root/lamina.deb
keep_archives

cat >"$clean/root/itself.py" <<'END'
# Neither a path nor LoadPlugin: ParaView and Python find all by themselves.
from paraview.simple import *
import lamina
image = HeartPhantom(Resolution=32)
surface = MultimaterialMarchingCubes(Input=MultimaterialSegmentation(Input=image))
surface.UpdatePipeline()
print("triangles:", surface.GetDataInformation().GetNumberOfCells())
assert surface.GetDataInformation().GetNumberOfCells() > 1000
assert lamina.vtkPrismLayer.__doc__
END
inside pvpython --no-mpi /root/itself.py
inside python3 -c "import lamina; print(lamina.__version__, lamina.vtkMeshAudit().GetClassName())"
inside pvpython --no-mpi /usr/share/lamina/scripts/heart_phantom.py /root/phantom.vti --resolution 36
inside lamina-mesh /root/phantom.vti --output /root/result --layers 2 --prism-layers 2
inside lamina-audit /root/result/mesh.vtu
# Removed, it leaves nothing of its own behind.
inside apt-get remove -y -q lamina
left=$(find "$clean/usr" -iname "*lamina*" -o -name paraview.conf)
if [ -n "$left" ]; then
  echo "FAILED: apt-get remove left files behind: $left"
  exit 1
fi
echo "the package works in a clean Debian"
