# SPDX-License-Identifier: AGPL-3.0-or-later
# Sourced by the tests of this layer: tap.sh, the helper programs, and functions for rendering.
. "$(dirname "${BASH_SOURCE[0]}")/../../tap.sh"
scenes=$TOP/tests/render/scenes
oracle=$BUILD/tests/oracle frames=$BUILD/tests/frames
[ -x "$oracle" ] && [ -x "$frames" ] && [ -z "$(find "$TOP/tests/render/helpers" -newer "$oracle" -name "*.[ch]*")$(find "$TOP/tests/render/helpers" -newer "$frames" -name "frames*")" ] ||
    make -s -C "$BUILD/.." build/tests/oracle build/tests/frames > /dev/null
jobs=$((4 * $(nproc 2>/dev/null || echo 2))) # a render of a small frame mostly waits
export scenes oracle frames scratch

# render PROGRAM OUTPUT WIDTHxHEIGHT OPTION...: a frame without display; says what went wrong if it
# fails.
render() {
    local program=$1 output=$2 size=$3 status=0
    shift 3
    "$program" -D +WT1 "+L$scenes" "$@" "+O$output" "+W${size%x*}" "+H${size#*x}" > "$output.said" \
        2>&1 < /dev/null || status=$?
    [ $status = 0 ] || { echo "$program $* fails ($status):"; grep -v '^$' "$output.said" | tail -8; return 1; }
    [ -s "$output" ] || { echo "$program $* writes no $output"; return 1; }
}

# told FILE: the error in a frame's own metadata: rms low high pixels lit_pixels method (audit or
# split-halves); nothing if there is none.
told() {
    grep -ao '"error":{[^}]*}' "$1" | tr ',{}' '\n' | awk -F: '{ gsub(/"/, ""); gsub(/ /, "-"); v[$1] = $2 }
        END { if ("rms" in v) print v["rms"], v["low"], v["high"], v["pixels"], v["lit_pixels"], v["method"] }'
}

# oracle_frame OUTPUT MESH-CAMERA WIDTHxHEIGHT OPTION...: the unmodified program's frame of those
# rays (one row higher: see frames.h). The scene includes camera.inc, which is taken from the folder
# that is made here. oracle_options: for the oracle alone.
oracle_frame() {
    local output=$1 camera=$2 size=$3
    shift 3
    rm -rf "$output.camera"
    mkdir "$output.camera"
    ln "$camera" "$output.camera/camera.inc"
    render "$PRISTINE" "$output" "${size%x*}x$((${size#*x} + 1))" "+L$output.camera" "$@" ${oracle_options:-}
}

# compare_with_oracle NAME SCENE WIDTHxHEIGHT "KEY=VALUE..." OPTION...: renders SCENE, which
# includes camera.inc, by our program and by the oracle, and compares all pixels. The pixels which
# differ have to lie at an edge of what is seen. Leaves NAME.png.
compare_with_oracle() { compare_with_parts "$1" "$2" "$3" "$4" 1 "" -- "${@:5}"; }

# compare_with_parts NAME SCENE SIZE "KEY=VALUE..." WEIGHT "KEY=VALUE..." [WEIGHT "KEY=VALUE..."]...
# -- OPTION...: the same, where our frame should be a mean of several of the oracle's frames, which
# differ by their own keys (see frames oracle).
compare_with_parts() {
    local name=$1 scene=$2 size=$3 keys=$4 status=0 weights=() own=() parts=() k
    shift 4
    while [ "$1" != -- ]; do weights+=("$1") own+=("$2"); shift 2; done
    shift
    mkdir -p "$name.ours"
    "$oracle" camera size=$size $keys > "$name.ours/camera.inc" || return 1
    render "$POVRAY" "$name.png" $size "+L$name.ours" "+I$scene" Integral_Audit=off "$@" ||
        { cat "$name.ours/camera.inc"; return 1; }
    for k in "${!weights[@]}"; do
        "$oracle" mesh "$name$k" size=$size $keys ${own[k]} || return 1
        oracle_frame "$name-oracle$k.png" "$name$k.inc" $size "+I$scene" "$@" || return 1
        parts+=(${weights[k]} "$name-oracle$k.png" "$name$k.mask")
    done
    "$frames" oracle "$name.png" "$name.far" "${parts[@]}" > "$name.counts" || status=1
    if [ $status = 0 ] && [ -s "$name.far" ]; then
        parts=()
        for k in "${!weights[@]}"; do
            "$oracle" around "$name-around$k" "$name.far" size=$size $keys ${own[k]} || return 1
            oracle_frame "$name-around$k.png" "$name-around$k.inc" 33x$(wc -l < "$name.far") "+I$scene" "$@" || return 1
            parts+=(${weights[k]} "$name-around$k.png" "$name$k.mask")
        done
        "$frames" edges "$name.png" "$name.far" "${parts[@]}" > "$name.edges" || status=1
    fi
    grep -h "^not " "$name.counts" "$name.edges" 2>/dev/null || true
    echo "$(tail -1 "$name.counts")$([ ! -e "$name.edges" ] || echo "; $(tail -1 "$name.edges")")"
    return $status
}

# long COMMAND...: under check-long alone.
long() { [ -z "$LONG" ] || "$@"; }

# later NAME COMMAND...: runs the check in the background, $jobs at a time; results prints them in
# order.
later_names=()
later() {
    local name=$1 number=${#later_names[@]}
    shift
    while [ "$(jobs -rp | wc -l)" -ge "$jobs" ]; do wait -n || true; done
    later_names+=("$name")
    { status=0; "$@" > "$scratch/later$number" 2>&1 || status=$?; echo $status > "$scratch/later$number.status"; } &
}

# results: a line of TAP for each; the last output of a check follows its name.
results() {
    local number said
    wait
    for number in "${!later_names[@]}"; do
        said=$(tail -1 "$scratch/later$number" | tr '#' ' ')
        verdict "$(cat "$scratch/later$number.status")" "${later_names[number]}${said:+: $said}" "$scratch/later$number"
    done
    later_names=()
}
