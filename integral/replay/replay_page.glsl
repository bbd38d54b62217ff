#version 300 es
// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws a frame as an eye sees it through its lens sheet: replay.cpp's SheetSeen and DiscPoints,
// lens_sheet.cpp's Lattice and refraction.h's extended pinhole, for a graphics processor with
// 32-bit numbers. Coordinates that need more bits are split into a whole part and a fraction by
// replay_drawing.js, which has 64-bit numbers. Lengths in mm, in the sheet frame; "view" is the
// canvas, "film" the frame.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;

uniform sampler2DArray film; // the frame in tiles, row by row; its stored values
uniform ivec2 film_size, tile_size;
uniform sampler2D light; // 256 by 1: linear light of a stored value
uniform vec2 pixel_pitch;
uniform int subpixels; // 0 none, 1 rgb, 2 bgr

uniform int arrangement; // 0 lenticular, 1 square, 2 hexagonal
uniform float pitch, row_spacing; // row_spacing in pitches
uniform vec2 across, along;       // unit vectors
uniform vec2 centre_to_lens;      // from the sheet's centre to lens (0, 0): along `across` and `along`, in pitches
uniform float thickness, n_squared, m; // m: n^2 - 1
uniform float past_focus;              // the film's distance behind the lenses' focus, in thicknesses

// Coordinates of the left edges of the view's columns, and of the upper edges of its rows. Texel
// (i, 0): whole part and fraction of the column's or row's share of the lattice coordinate along
// `across` (in pitches), then along `along` (in row spacings). Texel (i, 1): whole part and
// fraction of the film's pixel coordinate; then mm in the sheet frame.
uniform sampler2D columns, rows;
uniform vec2 view_pixel; // mm
uniform int view_height;
uniform ivec2 corner; // the view's lower left pixel on the canvas

uniform vec2 eye;
uniform float eye_distance;
uniform float pupil_radius, spot_radius; // spot: where a point of a lens gathers light on the film
uniform float sideways; // from a pupil point offset by v from the pupil's centre, the point in
                        // focus is seen through the sheet point offset by `sideways` v
uniform int samples;    // across and down
uniform bool raw;       // show the film without lenses

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

// Linear light, premultiplied, of a pixel of the film.
vec4 light_of(ivec2 pixel)
{
    ivec2 tile = pixel / tile_size;
    int tiles_across = (film_size.x + tile_size.x - 1) / tile_size.x;
    vec4 stored = texelFetch(film, ivec3(pixel - tile * tile_size, tile.y * tiles_across + tile.x), 0);
    ivec3 value = ivec3(255.0 * stored.rgb + 0.5);
    vec3 linear = vec3(texelFetch(light, ivec2(value.r, 0), 0).r, texelFetch(light, ivec2(value.g, 0), 0).r,
                       texelFetch(light, ivec2(value.b, 0), 0).r);
    return vec4(stored.a * linear, stored.a);
}

// Each colour channel from its own nearest stripe. `part`: fraction of the film's pixel coordinate
// across, in [0, 1).
vec4 stripes_at(ivec2 pixel, float part)
{
    float shift = subpixels == 1 ? 1.0 / 3.0 : -1.0 / 3.0; // subpixel_shift of blue; red's is the opposite
    int last = film_size.x - 1;
    vec4 red = light_of(ivec2(clamp(pixel.x + int(floor(part + shift)), 0, last), pixel.y));
    vec4 green = light_of(pixel);
    vec4 blue = light_of(ivec2(clamp(pixel.x + int(floor(part - shift)), 0, last), pixel.y));
    return vec4(red.r, green.g, blue.b, (red.a + green.a + blue.a) / 3.0);
}

// The light that the point `from` of the eye's pupil receives from a place in a pixel of the view.
// `inside`: the place, in [0, 1) from the pixel's upper left; `aside`: offset from the film point.
vec4 seen(ivec2 view, vec2 inside, vec2 from, vec2 aside)
{
    vec4 column = texelFetch(columns, ivec2(view.x, 0), 0), row = texelFetch(rows, ivec2(view.y, 0), 0);
    vec4 column_place = texelFetch(columns, ivec2(view.x, 1), 0), row_place = texelFetch(rows, ivec2(view.y, 1), 0);
    // From another point of the pupil, the point in focus is seen through another point of the
    // sheet.
    vec2 moved = vec2(inside.x, -inside.y) * view_pixel + sideways * (from - eye);
    vec2 film_step = moved;
    if (!raw) {
        vec2 part = column.yw + row.yw + vec2(dot(across, moved), dot(along, moved) / row_spacing) / pitch;
        vec2 carry = floor(part);
        vec2 to_pole = to_nearest_pole(column.xz + row.xz + carry, part - carry);
        // A film out of focus is met where the line from the lens's point to the focus crosses it.
        film_step += (1.0 + past_focus) * film_point_seen(to_pole, from - vec2(column_place.z, row_place.z) - moved) + aside;
    }
    vec2 pixel = vec2(column_place.y, row_place.y) + vec2(film_step.x, -film_step.y) / pixel_pitch;
    vec2 carry = floor(pixel);
    vec2 place = vec2(column_place.x, row_place.x) + carry;
    if (any(lessThan(place, vec2(0))) || any(greaterThanEqual(place, vec2(film_size))))
        return vec4(0);
    return subpixels == 0 ? light_of(ivec2(place)) : stripes_at(ivec2(place), pixel.x - carry.x);
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

// DiscPoints::point about 0: its coordinates are in units of 2^-32 and wrap around at 1.
vec2 disc_point(float radius, uvec2 bits, uvec2 steps, int index)
{
    const float unit = 1.0 / 4294967296.0, turn = 6.28318530717958647692;
    uvec2 coordinates = bits + uint(index) * steps;
    float r = radius * sqrt(unit * float(coordinates.x)), angle = turn * unit * float(coordinates.y);
    return r * vec2(cos(angle), sin(angle));
}
const uvec2 roberts_steps = uvec2(3242174889u, 2447445414u), richtmyer_steps = uvec2(1779033704u, 3144134278u);

float srgb_from_linear(float v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055; }

void main()
{
    ivec2 view = ivec2(gl_FragCoord.xy) - corner;
    view.y = view_height - 1 - view.y;
    uvec2 pupil_bits = random_bits(uvec2(0, view.x), uint(view.y)), spot_bits = random_bits(uvec2(1, view.x), uint(view.y));
    vec3 total = vec3(0);
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
            int index = j * samples + i;
            vec2 from = eye, aside = vec2(0);
            if (pupil_radius > 0.0 && !raw)
                from += disc_point(pupil_radius, pupil_bits, roberts_steps, index);
            if (spot_radius > 0.0)
                aside = disc_point(spot_radius, spot_bits, richtmyer_steps, index);
            total += seen(view, (vec2(i, j) + 0.5) / float(samples), from, aside).rgb;
        }
    vec3 linear = min(total / float(samples * samples), 1.0);
    shown = vec4(floor(255.0 * vec3(srgb_from_linear(linear.r), srgb_from_linear(linear.g), srgb_from_linear(linear.b)) + 0.5) / 255.0, 1);
}
