# SPDX-License-Identifier: BSD-3-Clause
# Read by the commands beside it, in the source tree and where they are installed: finds the plugin and the scripts.
#
#   lamina_run COMMAND SCRIPT [ARGUMENTS]    run SCRIPT of Examples under pvpython with the plugin; COMMAND is what messages say
#   lamina_find                              set LAMINA_PLUGIN and `scripts`, the folder of the scripts
#
# Expects `here`, the folder of the command. LAMINA_BUILD_DIR names another build than build/release.

lamina_first() {
  for candidate in "$@"; do
    if [ -f "$candidate" ]; then
      printf '%s\n' "$candidate"
      return 0
    fi
  done
  return 1
}

lamina_find() {
  root=$(CDPATH= cd -- "$here/.." && pwd)
  if [ -f "$root/CMakePresets.json" ]; then
    build=${LAMINA_BUILD_DIR:-$root/build/release}
    scripts=$root/Examples
    advice="no plugin in $build; build it: cd $root && cmake --preset release && cmake --build --preset release"
  else
    build=$root
    scripts=$root/share/lamina/scripts
    advice="no plugin in $build/lib; install it again"
  fi
  # Debian's packages have a folder of the machine's kind in lib.
  LAMINA_PLUGIN=$(lamina_first "$build"/lib/paraview-*/plugins/Lamina/Lamina.so \
    "$build"/lib/*/paraview-*/plugins/Lamina/Lamina.so) || {
    echo "$LAMINA_COMMAND: error: $advice" >&2
    exit 3
  }
  export LAMINA_COMMAND LAMINA_PLUGIN
}

lamina_run() {
  LAMINA_COMMAND=$1
  script=$2
  shift 2
  lamina_find
  if ! command -v pvpython >/dev/null; then
    echo "$LAMINA_COMMAND: error: pvpython is missing; install ParaView (Debian: paraview python3-paraview) and put it on PATH" >&2
    exit 3
  fi
  PYTHONDONTWRITEBYTECODE=1
  export PYTHONDONTWRITEBYTECODE
  # One process, so no MPI (it would write files of its own).
  exec pvpython --no-mpi "$scripts/$script" "$@"
}
