# SPDX-License-Identifier: BSD-3-Clause
# Read by test-package.sh and test-plain-vtk.sh: a small clean Debian in a folder.
#
#   clean_debian FOLDER NAME    make FOLDER/NAME anew from FOLDER/base (made at the first call); sets `clean`
#   inside COMMAND ...          run a command in it
#   keep_archives               keep what apt fetched for the next run
#
# Takes root and debootstrap, or LAMINA_DEBOOTSTRAP, the program; ends with 77 without them.

clean_debian() {
  debootstrap=${LAMINA_DEBOOTSTRAP:-debootstrap}
  if [ "$(id -u)" -ne 0 ] || ! command -v "$debootstrap" >/dev/null; then
    echo "skipped: a clean Debian takes root and debootstrap"
    exit 77
  fi
  mkdir -p "$1/archives"
  folder=$(readlink -f -- "$1")
  base=$folder/base
  clean=$folder/$2
  if [ ! -f "$base/made" ]; then
    rm -rf "$base"
    "$debootstrap" --variant=minbase bookworm "$base"
    touch "$base/made"
  fi
  umount "$clean/proc" 2>/dev/null || true
  rm -rf "$clean"
  cp -a "$base" "$clean"
  cp /etc/resolv.conf "$clean/etc/"
  mount -t proc proc "$clean/proc"
  trap 'umount "$clean/proc" 2>/dev/null || true' EXIT
  cp "$folder"/archives/*.deb "$clean/var/cache/apt/archives/" 2>/dev/null || true
  inside apt-get update -q
}

inside() { chroot "$clean" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }

keep_archives() { cp -u "$clean"/var/cache/apt/archives/*.deb "$folder/archives/" 2>/dev/null || true; }
