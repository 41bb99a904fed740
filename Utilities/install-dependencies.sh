#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Install what building, testing and running take (Debian 12; root or sudo). Does nothing where all is there.
# With --all also the programs that the tests labelled external hand our files to.
set -eu
packages="g++ cmake ninja-build ccache clang-format xsltproc paraview paraview-dev python3-paraview libtet1.5-dev libeigen3-dev
  libcgal-dev libglew-dev libpython3-dev libopenmpi-dev openmpi-bin qtbase5-dev qttools5-dev libqt5svg5-dev
  libqt5xmlpatterns5-dev libutfcpp-dev libdouble-conversion-dev libgtest-dev python3-numpy python3-scipy xvfb xauth imagemagick"
case ${1:-} in
  "") ;;
  --all) packages="$packages gmsh python3-gmsh libtbb-dev python3-meshio openfoam calculix-ccx" ;;
  *)
    echo "usage: Utilities/install-dependencies.sh [--all]" >&2
    exit 2
    ;;
esac

missing=""
for package in $packages; do
  state=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  case $state in
    *"ok installed") ;;
    *) missing="$missing $package" ;;
  esac
done
if [ -z "$missing" ]; then
  exit 0
fi
if ! command -v apt-get >/dev/null; then
  echo "install-dependencies.sh: error: apt-get is missing; install by hand:$missing" >&2
  exit 1
fi
as_root=""
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install-dependencies.sh: error: run this as root, or install sudo; missing:$missing" >&2
    exit 1
  fi
  as_root=sudo
fi
echo "Installing:$missing"
$as_root apt-get update -q
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
