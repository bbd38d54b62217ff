# SPDX-License-Identifier: AGPL-3.0-or-later
# For test scripts (sourced, after tap.sh): small scenes for integral batch, in the current folder,
# and figures of its records.
#
#   batch_scenes            writes scenes/one.pov, two.pov, their colours.inc and picture.ppm
#   starts OUTPUT           how often steps were begun, in all
#   state OUTPUT STEP       a step's state by its record
#   frame_words FRAME       a PNG frame's metadata, except the seconds that it took and its error's
#                           figures, since a continued frame is audited in other pixels

batch_scenes() {
    mkdir -p scenes
    echo '#declare Colour = rgb <1, .5, .1>;' > scenes/colours.inc
    printf 'P3\n2 1\n255\n255 0 0 0 0 255\n' > scenes/picture.ppm
    cat > scenes/one.pov <<'POV'
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colours.inc"
#ifndef (Turn) #declare Turn = 0; #end
camera { location <0, 0, -100> look_at 0 angle 20 right x*image_width/image_height }
light_source { <-10, 100, -200>, 1 }
box { -9, 9 rotate y*Turn pigment { Colour } }
plane { z, 40 pigment { image_map { ppm "picture.ppm" } scale 20 } }
POV
    cat > scenes/two.pov <<'POV'
#version 3.7;
global_settings { assumed_gamma 1 }
camera { integral lens_sheet { lenticular pitch 1.27 thickness 3.08 ior 1.6 } film { dpi 300 }
         location <0, 0, -100> look_at 0 angle 20 right x*image_width/image_height }
light_source { <-10, 100, -200>, 1 }
sphere { 0, 9 pigment { rgb <.2, .5, 1> } }
POV
}

starts() { cat "$1"/.integral-batch/steps/*.json | sed -n 's/^ "starts": \([0-9]*\),$/\1/p' | awk '{ sum += $1 } END { print sum + 0 }'; }
state() { sed -n 's/^ "state": "\(.*\)",$/\1/p' "$1/.integral-batch/steps/$2.json"; }
frame_words() { strings -n 20 "$1" | sed -n -e 's/"seconds":[^,}]*//g' -e '/^{"sheet"/,/}}$/p' |
    sed -e ':next' -e 's/\("error":{[^}]*\)"\(rms\|low\|high\|pixels\)":[^,}]*,/\1/;t next'; }
