#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Mesh one image: Utilities/mesh.sh INPUT --output DIR [options]; installed it is called lamina-mesh. Paths are relative to
# where you are. LAMINA_BUILD_DIR names another build than build/release.
set -u
here=$(dirname -- "$(readlink -f -- "$0")")
common=$here/lamina-run.sh
[ -f "$common" ] || common=$here/../share/lamina/lamina-run.sh
. "$common"
lamina_run "$(basename -- "$0")" image_to_mesh.py "$@"
