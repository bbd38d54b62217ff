# SPDX-License-Identifier: AGPL-3.0-or-later
# Shared by the patch queue's scripts (sourced, not run): where things are, what the queue holds, what a tree holds.
# TOP is the repository, BUILD the build folder; both may be set from outside (the tests use other ones).

TOP=${TOP:-$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)}
BUILD=${BUILD:-$TOP/build}
export TOP BUILD LC_ALL=C
. "$TOP/unix/upstream.pin"

tree=$BUILD/povray               # the assembled tree
upstream=$BUILD/pristine         # upstream's tree as unpacked
upstream_sums=$BUILD/pristine.sums
manifest=$BUILD/povray.manifest  # what assembling wrote last: hash in the tree, hash in the queue, path
places='source vfe unix'         # the only folders of upstream's tree that the queue may touch

die() { echo "$(basename "$0"): $*" >&2; exit 1; }

# The series: what serves every camera of POV-Ray, then the integral camera.
series='unix/series.upstream unix/series.camera'

# patches [SERIES]: the patches in order of application, as paths below TOP; of one series or of both.
patches() { (cd "$TOP" && sed -e 's/#.*//' -e 's/[[:space:]]*$//' -e '/^$/d' ${1:-$series}); }

# Patches on disk, listed or not.
patches_on_disk() { (cd "$TOP" && find $places -name '*.patch' 2>/dev/null | sort); }

# Our whole new files for upstream's tree: everything of C++ below source, vfe and unix.
overlay() { (cd "$TOP" && find $places \( -name '*.cpp' -o -name '*.h' \) 2>/dev/null | sort); }

# A hash and a path per file below DIR that the queue may touch: what upstream ships, and C++ files. What upstream's
# prebuild, configure and make write there is left out.
sums() {
    (cd "$1" && find $places -type f ! -name '*.o' ! -name '*.a' ! -name '*.Po' ! -name '*~' ! -name '.*' \
        ! -path source/jversion.h ! -path unix/config.h -print0 2>/dev/null | sort -z | xargs -0r sha256sum) |
        sed 's/^\([0-9a-f]*\) [ *]/\1 /' |
        if [ -f "$upstream_sums" ]; then
            awk 'NR == FNR { shipped[$2]; next } ($2 in shipped) || $2 ~ /\.(cpp|h)$/' "$upstream_sums" -
        else cat; fi
}

sum() { if [ -f "$1" ]; then sha256sum < "$1" | cut -d' ' -f1; else echo absent; fi; }

# Reads "hash path" lines of file $2 into the associative array named $1.
read_sums() {
    local -n into=$1
    local hash path
    while read -r hash path; do into[$path]=$hash; done < "$2"
}

# Reads the manifest into written (path to hash in the tree) and queued (path to hash in the queue).
read_manifest() {
    local hash from path
    [ -f "$manifest" ] || return 0
    while read -r hash from path; do written[$path]=$hash; queued[$path]=$from; done < "$manifest"
}
