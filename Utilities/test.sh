#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Install what is missing, build, run the quick tests; with --all the long ones too, which also write docs/figures.md.
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
label="-L quick"
case ${1:-} in
  "") ;;
  --all)
    label=""
    "$root/Utilities/install-dependencies.sh" --all
    ;;
  *)
    echo "usage: Utilities/test.sh [--all]" >&2
    exit 2
    ;;
esac
"$root/Utilities/build.sh" ${LAMINA_SHARED_DATA:+-DLAMINA_SHARED_DATA="$LAMINA_SHARED_DATA"}
cd "$root/build/release"
status=0
# shellcheck disable=SC2086
xvfb-run -a -n $((100 + $$ % 800)) -s "-screen 0 1400x900x24 -noreset" ctest $label --output-on-failure -j "$(nproc)" || status=$?
exit $status
