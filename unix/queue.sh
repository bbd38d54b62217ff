# SPDX-License-Identifier: AGPL-3.0-or-later
# Functions shared by the scripts of the patch queue; to be sourced. Defines the folders, the list
# of patches and files in the queue, and checksums of a tree. TOP is the repository, BUILD the build
# folder; tests set both to other folders.

TOP=${TOP:-$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)}
BUILD=${BUILD:-$TOP/build}
export TOP BUILD LC_ALL=C
. "$TOP/unix/upstream.pin"

tree=$BUILD/povray               # the assembled tree
upstream=$BUILD/pristine         # upstream's tree as unpacked
upstream_sums=$BUILD/pristine.sums
manifest=$BUILD/povray.manifest  # files of the last assembly: hash in the tree, hash in the queue, path
places='source vfe unix'         # the only folders of upstream's tree that the queue may touch

die() { echo "$(basename "$0"): $*" >&2; exit 1; }

# The series, in order: changes for all of POV-Ray's cameras, then the integral camera.
series='unix/series.upstream unix/series.camera'

# patches [SERIES]: prints the patches of one series, or of both, in order of application, as paths
# relative to TOP.
patches() { (cd "$TOP" && sed -e 's/#.*//' -e 's/[[:space:]]*$//' -e '/^$/d' ${1:-$series}); }

# Prints all patches on disk, whether or not a series lists them.
patches_on_disk() { (cd "$TOP" && find $places -name '*.patch' 2>/dev/null | sort); }

# Prints our new files for upstream's tree: all C++ files in source, vfe and unix.
overlay() { (cd "$TOP" && find $places \( -name '*.cpp' -o -name '*.h' \) 2>/dev/null | sort); }

# sums DIR: prints hash and path of each file in DIR that the queue may change: files that upstream
# ships, and C++ files. Files that upstream's prebuild, configure and make write there are left out.
sums() {
    (cd "$1" && find $places -type f ! -name '*.o' ! -name '*.a' ! -name '*.gch' ! -name '*.Po' ! -name '*~' ! -name '.*' \
        ! -path source/jversion.h ! -path unix/config.h -print0 2>/dev/null | sort -z | xargs -0r sha256sum) |
        sed 's/^\([0-9a-f]*\) [ *]/\1 /' |
        if [ -f "$upstream_sums" ]; then
            awk 'NR == FNR { shipped[$2]; next } ($2 in shipped) || $2 ~ /\.(cpp|h)$/' "$upstream_sums" -
        else cat; fi
}

sum() { if [ -f "$1" ]; then sha256sum < "$1" | cut -d' ' -f1; else echo absent; fi; }

# read_sums ARRAY FILE: reads the "hash path" lines of FILE into the associative array ARRAY.
read_sums() {
    local -n into=$1
    local hash path
    while read -r hash path; do into[$path]=$hash; done < "$2"
}

# Reads the manifest into the associative arrays written (hash in the tree) and queued (hash in the
# queue), by path.
read_manifest() {
    local hash from path
    [ -f "$manifest" ] || return 0
    while read -r hash from path; do written[$path]=$hash; queued[$path]=$from; done < "$manifest"
}
