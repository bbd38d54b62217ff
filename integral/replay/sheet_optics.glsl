#version 300 es
// SPDX-License-Identifier: AGPL-3.0-or-later
// Optics of a lens sheet for a graphics processor with 32-bit numbers, the beginning of
// replay_page.glsl and live_view.glsl: lens_sheet.cpp's Lattice, refraction.h's extended pinhole and
// the random numbers of sample_points.h. Coordinates that need more bits are split into a whole part
// and a fraction by replay_drawing.js, which has 64-bit numbers. Lengths in mm, in the sheet frame;
// "view" is the canvas, "film" the frame.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;

uniform ivec2 film_size;
uniform vec2 pixel_pitch;
uniform int subpixels; // 0 none, 1 rgb, 2 bgr

uniform int arrangement; // 0 lenticular, 1 square, 2 hexagonal
uniform float pitch, row_spacing; // row_spacing in pitches
uniform vec2 across, along;       // unit vectors
uniform vec2 centre_to_lens;      // from the sheet's centre to lens (0, 0): along `across` and `along`, in pitches
uniform float thickness, n_squared, m; // m: n^2 - 1

// Coordinates of the left edges of the view's columns, and of the upper edges of its rows. Texel
// (i, 0): whole part and fraction of the column's or row's share of the lattice coordinate along
// `across` (in pitches), then along `along` (in row spacings). Texel (i, 1): whole part and
// fraction of the film's pixel coordinate; then mm in the sheet frame.
uniform sampler2D columns, rows;
uniform vec2 view_pixel; // mm
uniform int view_height;
uniform ivec2 corner; // the view's lower left pixel on the canvas
uniform float eye_distance;
uniform int samples; // across and down

out vec4 shown;

const float tie = 1e-6; // pitches; smaller differences are within single precision's rounding

// The rule for two poles at equal distance: returns whether to take the first. `difference` is the
// first minus the second. All from the sheet's centre, along `across` and `along`, in pitches.
bool preferred(vec2 first, vec2 second, vec2 difference)
{
    float nearer = dot(difference, first + second) / (length(first) + length(second));
    if (abs(nearer) > tie)
        return nearer < 0.0;
    vec2 on_sheet = difference.x * across + difference.y * along;
    return abs(on_sheet.x) > tie ? on_sheet.x < 0.0 : on_sheet.y < 0.0;
}

// The vector from a point of the sheet to the pole (lenticular: the axis) of the nearest lens, mm.
// The point's lattice coordinates are whole + part, part in [0, 1).
vec2 to_nearest_pole(vec2 whole, vec2 part)
{
    vec2 best, best_pole;
    float least = 1e30;
    for (int j = 0; j < (arrangement == 0 ? 1 : 2); ++j) {
        float row = whole.y + float(j);
        float shift = arrangement == 2 && (int(row) & 1) == 1 ? 0.5 : 0.0;
        float first = floor(part.x - shift) + shift;
        for (int i = 0; i < 2; ++i) {
            float column = first + float(i);
            vec2 away = vec2(column - part.x, (float(j) - part.y) * row_spacing);
            vec2 pole = vec2(whole.x + column, row * row_spacing) + centre_to_lens;
            if (arrangement == 0) {
                away.y = 0.0;
                pole.y = 0.0;
            }
            float distance = length(away);
            if (distance < least - tie || (distance < least + tie && preferred(pole, best_pole, away - best))) {
                best = away;
                best_pole = pole;
            }
            least = min(least, distance);
        }
    }
    return pitch * (best.x * across + best.y * along);
}

// The vector from a point of the sheet to the film point that the eye sees there, mm. With v from
// the point to the eye, and d the eye's distance, offset_from_direction is t v/(|v, d| sqrt(m +
// (d/|v, d|)^2)) = t v/sqrt(m v^2 + n^2 d^2).
vec2 film_point_seen(vec2 to_pole, vec2 to_eye)
{
    return to_pole - (thickness / sqrt(m * dot(to_eye, to_eye) + n_squared * eye_distance * eye_distance)) * to_eye;
}

// The upper left corner of a pixel of the view.
struct ViewCorner {
    vec2 lattice_whole, lattice_part; // lattice coordinates
    vec2 film_whole, film_part;       // pixel coordinates of the film
    vec2 place;                       // mm
};

ViewCorner view_corner(ivec2 view)
{
    vec4 column = texelFetch(columns, ivec2(view.x, 0), 0), row = texelFetch(rows, ivec2(view.y, 0), 0);
    vec4 column_place = texelFetch(columns, ivec2(view.x, 1), 0), row_place = texelFetch(rows, ivec2(view.y, 1), 0);
    return ViewCorner(column.xz + row.xz, column.yw + row.yw, vec2(column_place.x, row_place.x),
                      vec2(column_place.y, row_place.y), vec2(column_place.z, row_place.z));
}

// to_nearest_pole from the point at `offset` (mm) from a corner.
vec2 to_nearest_pole(ViewCorner from, vec2 offset)
{
    vec2 part = from.lattice_part + vec2(dot(across, offset), dot(along, offset) / row_spacing) / pitch;
    vec2 carry = floor(part);
    return to_nearest_pole(from.lattice_whole + carry, part - carry);
}

// The view's pixel that is drawn, counted from the upper left.
ivec2 drawn_pixel()
{
    ivec2 view = ivec2(gl_FragCoord.xy) - corner;
    return ivec2(view.x, view_height - 1 - view.y);
}

// random_bits of sample_points.h: 64-bit numbers as (high, low).
uvec2 sum(uvec2 a, uvec2 b)
{
    uint low = a.y + b.y;
    return uvec2(a.x + b.x + uint(low < a.y), low);
}

uvec2 product(uvec2 a, uvec2 b)
{
    uint a0 = a.y & 0xffffu, a1 = a.y >> 16, b0 = b.y & 0xffffu, b1 = b.y >> 16;
    uint p01 = a0 * b1, p10 = a1 * b0, middle = (a0 * b0 >> 16) + (p01 & 0xffffu) + (p10 & 0xffffu);
    uint carried = a1 * b1 + (p01 >> 16) + (p10 >> 16) + (middle >> 16);
    return uvec2(carried + a.x * b.y + a.y * b.x, a.y * b.y);
}

uvec2 folded(uvec2 v, int by) { return v ^ uvec2(v.x >> by, v.y >> by | v.x << (32 - by)); }

uvec2 scrambled(uvec2 v)
{
    v = sum(v, uvec2(0x9e3779b9u, 0x7f4a7c15u));
    v = product(folded(v, 30), uvec2(0xbf58476du, 0x1ce4e5b9u));
    v = product(folded(v, 27), uvec2(0x94d049bbu, 0x133111ebu));
    return folded(v, 31);
}

uvec2 random_bits(uvec2 seed, uint value) { return scrambled(seed ^ scrambled(uvec2(0, value))); }

float srgb_from_linear(float v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055; }

vec4 encoded(vec3 linear)
{
    linear = min(linear, 1.0);
    return vec4(floor(255.0 * vec3(srgb_from_linear(linear.r), srgb_from_linear(linear.g), srgb_from_linear(linear.b)) + 0.5) / 255.0, 1);
}
