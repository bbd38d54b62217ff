# SPDX-License-Identifier: AGPL-3.0-or-later
# For test scripts (sourced): prints TAP, makes a scratch folder and removes it at the end.
#
#   . "${TOP:-$(cd "$(dirname "$0")/../.." && pwd)}/tests/tap.sh"
#   check "it runs" program arguments...         passes if the command succeeds; its output is shown otherwise
#   fails "it refuses" STATUS 'pattern' command  passes if it exits with STATUS and its output matches the pattern
#   is "it counts" "$got" "$wanted"              passes if both are the same
#   check "they exist" every command LIST...     the command succeeds with each word of the list, which is not empty
#   finish                                       prints the plan; the last line of every script
#
# A name that begins with "... " goes on with the last one that does not, which is printed before it:
# a failure says what failed.
#
# TOP, BUILD, POVRAY, PRISTINE, INTEGRAL are set as tests/run sets them, so that a script runs alone
# too.

TOP=${TOP:-$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)}
BUILD=${BUILD:-$TOP/build}
POVRAY=${POVRAY:-$BUILD/bin/povray-integral}
PRISTINE=${PRISTINE:-$TOP/tests/unmodified}
INTEGRAL=${INTEGRAL:-$BUILD/bin/integral}
POVINI=${POVINI:-$TOP/tests/povray.ini}
POVINC=${POVINC:-$BUILD/share/povray-integral-3.7/include}
LONG=${LONG:-}
export TOP BUILD POVRAY PRISTINE INTEGRAL POVINI POVINC LONG

scratch=$(mktemp -d "${TMPDIR:-/tmp}/integral-test.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
tap_count=0
tap_subject=

# verdict STATUS NAME [EXPLANATION-FILE]
verdict() {
    local name=$2
    case $name in "... "*) name="$tap_subject $name" ;; *) tap_subject=$name ;; esac
    tap_count=$((tap_count + 1))
    if [ "$1" = 0 ]; then echo "ok $tap_count - $name"; return; fi
    echo "not ok $tap_count - $name"
    [ -z "${3:-}" ] || tail -n 20 "$3" | sed 's/^/# /'
}

check() {
    local name=$1 status=0
    shift
    "$@" > "$scratch/.said" 2>&1 || status=$?
    [ $status = 0 ] || echo "exit status $status" >> "$scratch/.said"
    verdict $status "$name" "$scratch/.said"
}

fails() {
    local name=$1 wanted=$2 pattern=$3 status=0 bad=0
    shift 3
    "$@" > "$scratch/.said" 2>&1 || status=$?
    grep -qE -e "$pattern" "$scratch/.said" || bad=1
    [ $status = "$wanted" ] || bad=1
    echo "exit status $status, wanted $wanted and output that matches: $pattern" >> "$scratch/.said"
    verdict $bad "$name" "$scratch/.said"
}

is() {
    printf 'got    %s\nwanted %s\n' "$2" "$3" > "$scratch/.said"
    if [ "$2" = "$3" ]; then verdict 0 "$1"; else verdict 1 "$1" "$scratch/.said"; fi
}

every() {
    local command=$1 word
    shift
    [ $# -gt 0 ] || { echo "nothing was found to check: the list is empty"; return 1; }
    for word in "$@"; do "$command" "$word" || { echo "not so: $word"; return 1; }; done
}

skip() {   # skip NAME REASON
    tap_count=$((tap_count + 1))
    echo "ok $tap_count - $1 # SKIP $2"
}

skip_all() { echo "1..0 # SKIP $*"; exit 0; }

finish() { echo "1..$tap_count"; }
