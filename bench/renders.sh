# SPDX-License-Identifier: AGPL-3.0-or-later
# Functions for the scripts of this folder, to be sourced. They write three scenes (trivial, 1500
# glass balls with interiors, upstream's chess2), name two sheets, and measure the cost of renders.
# At look_at, the field of a scene's perspective picture is as wide as the film, for any frame size.
# Therefore both cameras see the same mix of objects.
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)
povray=${POVRAY:-$top/build/bin/povray-integral}
export POVINI=$top/tests/povray.ini
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
width=${WIDTH:-600} height=${HEIGHT:-400}

view='#declare Film = image_width*25.4/300;
camera { location <0, 0, -350> look_at 0 angle 2*degrees(atan2(Film/2, 350)) right x*image_width/image_height }'
cat > "$work/trivial.pov" <<SCENE
#version 3.7; global_settings { assumed_gamma 1 }
$view
light_source { <-200, 300, -400> rgb 1 }
sphere { 0, 0.3*Film pigment { rgb <0.8, 0.4, 0.2> } }
plane { -z, -0.8*Film pigment { rgb 0.6 } }
SCENE
cat > "$work/glass.pov" <<SCENE
#version 3.7; global_settings { assumed_gamma 1 max_trace_level 4 }
$view
light_source { <-200, 300, -400> rgb 1 }
plane { -z, -40 pigment { checker rgb 0.9 rgb 0.4 scale 5 } }
#declare R = seed(1);
#for (I, 1, 1500)
  sphere { <(rand(R) - 0.5)*60, (rand(R) - 0.5)*40, (rand(R) - 0.5)*40>, 0.4 + rand(R)
           pigment { rgbt <0.9, 0.95, 1, 0.8> } finish { specular 0.4 } interior { ior 1.3 } }
#end
SCENE
chess=$top/build/share/povray-integral-3.7/scenes/advanced/chess2.pov
sed -e '/blur_samples/d' \
    -e 's/direction <0, 0, 2>/direction z*vlength(<59, 21, -56>)*300\/25.4\/image_height/' \
    "$chess" > "$work/chess2.pov"

sheets=("lenticular pitch 1.27 thickness 3.08 ior 1.6;" "square pitch 1.124 thickness 3.23 ior 1.675;")

# run SCENE CAMERA [WRAPPER...]: renders with the options in $size; the output goes to $work/log.
# CAMERA is "SHEET;OTHER WORDS"; if it is empty, the scene's own camera is used.
run() {
    local scene=$1 camera=$2; shift 2
    "$@" "$povray" +I"$scene" +L"$top/build/share/povray-integral-3.7/scenes/advanced" +O"$work/out.png" -D -V +WT1 \
        ${camera:+"Integral_Camera=lens_sheet { ${camera%%;*} } film { dpi 300 } ${camera#*;}" Integral_Audit=off} "${size[@]}" \
        > "$work/log" 2>&1
}
seconds() { # seconds of CPU, user and system
    local t; TIMEFORMAT='%U %S'; t=$( { time run "$1" "$2"; } 2>&1 ); echo "$t" | awk '{ printf "%.3f", $1 + $2 }'
}
instructions() {
    run "$1" "$2" valgrind --tool=callgrind --callgrind-out-file=/dev/null
    sed -n 's/.*Collected : \([0-9]*\).*/\1/p' "$work/log"
}
# rays: the number of the integral camera's primary rays in the last render.
rays() { sed -n 's/^Rays: *\([0-9]*\) .*/\1/p' "$work/log" | tail -1; }
# per_ray SCENE CAMERA [RAYS]: instructions for each primary ray of a frame of 150 x 100 pixels.
# RAYS is their number for the perspective camera, whose statistics do not count them.
per_ray() {
    local full start n
    size=(+W150 +H100); full=$(instructions "$1" "$2"); n=${3:-$(rays)}
    size=(+W150 +H100 +SC2 +EC2 +SR2 +ER2); start=$(instructions "$1" "$2")
    awk -v f="$full" -v s="$start" -v n="$n" 'BEGIN { printf "%.0f", (f - s) / n }'
}

