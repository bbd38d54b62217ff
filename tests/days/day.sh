# SPDX-License-Identifier: AGPL-3.0-or-later
# For the scripts of this folder (sourced): a day of one user, from a wish in words to the checked
# result. Each command that the user types is given with `step`, as typed, and counted: a day has at
# most six, and none that needs a calculator. Checks of the result are not steps.
. "${TOP:-$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)}/tests/tap.sh"
PATH=$BUILD/bin:$PATH
cd "$scratch"
most_steps=6 steps=0

# step "what it is for" COMMAND...
step() {
    steps=$((steps + 1))
    check "$@"
}
# The scene that the user has: one of POV-Ray's own, not edited.
samples=$BUILD/povray/distribution/scenes
end_of_day() {
    is "at most $most_steps commands" "$((steps <= most_steps))" 1
    finish
}
# value FILE.json KEY...: what the document holds there
value() {
    perl -MJSON::PP -e '
        local $/; open my $file, "<", shift; my $at = decode_json(<$file>);
        $at = ref $at eq "ARRAY" ? $at->[$_] : $at->{$_} for @ARGV; print "$at\n"' "$@"
}
# about NAME GOT EXPECTED PART: equal within the fraction PART
about() {
    is "$1" "$(awk -v a="$2" -v b="$3" -v p="$4" 'BEGIN { d = a - b; print ((d < 0 ? -d : d) <= p * b) ? "about " b : a }')" \
        "about $3"
}
