#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Draw all pictures of docs/filters anew, those of stages and those of their properties: Utilities/draw-pages.sh [FOLDER] [PAGE ...].
# Look at them before they are kept.
set -eu
LAMINA_COMMAND=draw-pages.sh
here=$(dirname -- "$(readlink -f -- "$0")")
. "$here/lamina-run.sh"
lamina_find
PYTHONPATH=$(dirname -- "$LAMINA_PLUGIN")${PYTHONPATH:+:$PYTHONPATH}
PYTHONDONTWRITEBYTECODE=1
export PYTHONPATH PYTHONDONTWRITEBYTECODE
for script in draw-pages.py draw-effects.py draw-gallery.py; do
  xvfb-run -a -n $((100 + $$ % 800)) -s "-screen 0 1280x1024x24 -noreset" pvpython --no-mpi "$here/$script" "$@"
done
