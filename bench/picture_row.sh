# SPDX-License-Identifier: AGPL-3.0-or-later
# Functions that put pictures side by side, for the scripts that make the pages' pictures. They use
# $povray, and write to the current folder.

# run COMMAND...: hides its output; if it fails, prints the output's end and ends the script.
run() { "$@" > said 2>&1 || { tail -n 20 said >&2; exit 1; }; }

rectangle() { # FILE LEFT LOWER WIDTH HEIGHT of the picture into the unit square
    echo "polygon { 5, 0, x, x+y, y, 0 pigment { image_map { png \"$1\" once ${smooth:+interpolate 2} } translate <-($2), -($3), 0>"
    echo "  scale <1/($4), 1/($5), 1> } finish { ambient 0 diffuse 0 emission 1 } $6 }"
}

# picture_row OUTPUT WIDTH HEIGHT FILE...: the pictures in a row as .png or .jpg, each of this size;
# FILE@ is a part of it, enlarged. With `smooth` set, large pictures are averaged.
picture_row() {
    local output=$1 width=$2 height=$3 file part k=0 format=+FN8
    [ "${output%.jpg}" = "$output" ] || format=+FJ80
    shift 3
    {
        echo '#version 3.7; global_settings { assumed_gamma 1.0 } background { rgb 1 }'
        echo "camera { orthographic location <$#/2, .5, -1> direction z right ($# + ($# - 1)*.03 + .0001)*x up y }"
        for file in "$@"; do
            part='0 0 1 1'
            [ "$file" = "${file%@}" ] || part='.45 .45 .1 .1'
            rectangle "${file%@}" $part "translate ($k*1.03 - ($# - 1)*.015)*x"
            k=$((k + 1))
        done
    } > row.pov
    run "$povray" +Irow.pov "+O$output" $format +W$((width * $# + 6 * ($# - 1))) +H$height -D -GA \
        $([ -n "${smooth:-}" ] && echo +A0.01 +R4 || echo -A)
}
