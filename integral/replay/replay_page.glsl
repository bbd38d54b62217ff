// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws a frame as an eye sees it through its lens sheet: replay.cpp's SheetSeen and DiscPoints.
// Continues sheet_optics.glsl.

uniform sampler2DArray film; // the frame in tiles, row by row; its stored values
uniform ivec2 tile_size;
uniform sampler2D light; // 256 by 1: linear light of a stored value
uniform float past_focus; // the film's distance behind the lenses' focus, in thicknesses

uniform vec2 eye;
uniform float pupil_radius, spot_radius; // spot: where a point of a lens gathers light on the film
uniform float sideways; // from a pupil point offset by v from the pupil's centre, the point in
                        // focus is seen through the sheet point offset by `sideways` v
uniform bool raw;       // show the film without lenses

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
    ViewCorner at = view_corner(view);
    // From another point of the pupil, the point in focus is seen through another point of the
    // sheet.
    vec2 moved = vec2(inside.x, -inside.y) * view_pixel + sideways * (from - eye);
    vec2 film_step = moved;
    // A film out of focus is met where the line from the lens's point to the focus crosses it.
    if (!raw)
        film_step += (1.0 + past_focus) * film_point_seen(to_nearest_pole(at, moved), from - at.place - moved) + aside;
    vec2 pixel = at.film_part + vec2(film_step.x, -film_step.y) / pixel_pitch;
    vec2 carry = floor(pixel);
    vec2 place = at.film_whole + carry;
    if (any(lessThan(place, vec2(0))) || any(greaterThanEqual(place, vec2(film_size))))
        return vec4(0);
    return subpixels == 0 ? light_of(ivec2(place)) : stripes_at(ivec2(place), pixel.x - carry.x);
}

// DiscPoints::point about 0: its coordinates are in units of 2^-32 and wrap around at 1.
vec2 disc_point(float radius, uvec2 bits, uvec2 steps, int index)
{
    const float unit = 1.0 / 4294967296.0, turn = 6.28318530717958647692;
    uvec2 coordinates = bits + uint(index) * steps;
    float r = radius * sqrt(unit * float(coordinates.x)), angle = turn * unit * float(coordinates.y);
    return r * vec2(cos(angle), sin(angle));
}
const uvec2 roberts_steps = uvec2(3242174889u, 2447445414u), richtmyer_steps = uvec2(1779033704u, 3144134278u);

void main()
{
    ivec2 view = drawn_pixel();
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
    shown = encoded(total / float(samples * samples));
}
