// SPDX-License-Identifier: AGPL-3.0-or-later
// Interlaces views for a panel: interlace.cpp's Interlacer::sample for each subpixel, in the same
// whole numbers. panel_mapping.h and interlace_rows.h explain phases and steps.
precision highp float;
precision highp int;
precision highp sampler2DArray;
precision highp usampler2D;

// A picture of bytes in tiles, row by row.
uniform sampler2DArray quilt, across, shift, up, x, y;
uniform ivec2 quilt_size, quilt_tile;
struct Table {
    ivec2 size; // phases: of pixel p of the panel, those at p modulo the size
    ivec2 tile; // of its picture
    int planes; // bytes of a phase, one below the other; 0: all phases are 0
};
uniform Table across_table, shift_table, up_table, x_table, y_table;

uniform ivec2 panel;          // pixels
uniform ivec4 part_shown;     // left, top, right, bottom: pixels outside are black
uniform bvec2 mirrored;       // the image is sent from right to left, from bottom to top
uniform ivec2 grid, view;     // columns and rows of the quilt, pixels of a view
uniform uvec2 views;          // across, up
uniform bvec2 blends;         // neighbouring views, neighbouring pixels
uniform bool is_separable;    // two rows of a view are blended, and rounded, first
uniform bool has_unseen;      // subpixels whose phase is `unseen` are black
uniform int only_view;        // from all places this view is seen; -1: each from its own
uniform usampler2D light;     // 256 by 1: the value that is blended for a stored one
uniform usampler2D stored;    // 256 by 256: the inverse
out vec4 sent;

const uint unseen = 0xffff8000u;

uvec3 bytes_of(sampler2DArray picture, int width, ivec2 tile_size, ivec2 pixel)
{
    ivec2 tile = pixel / tile_size;
    int tiles_across = (width + tile_size.x - 1) / tile_size.x;
    vec4 texel = texelFetch(picture, ivec3(pixel - tile * tile_size, tile.y * tiles_across + tile.x), 0);
    return uvec3(255.0 * texel.rgb + 0.5);
}

// Phases of a pixel's red, green and blue.
uvec3 phases_at(sampler2DArray picture, Table table, ivec2 pixel)
{
    uvec3 phases = uvec3(0);
    ivec2 place = pixel % table.size;
    for (int plane = 0; plane < table.planes; ++plane)
        phases = (phases << 8) | bytes_of(picture, table.size.x, table.tile, place + ivec2(0, plane * table.size.y));
    return table.planes == 2 ? (phases << 16) + 32768u : phases; // phase_of_high
}

// step_among, for less than 32768 parts.
uint step_among(uint parts, uint phase, bool linear)
{
    uint product = (phase >> 16) * parts + (((phase & 65535u) * parts) >> 16); // 2^16 a part
    if (!linear)
        return (product >> 16) << 8;
    product += 0x8080u;
    if (product >> 16 == 0u)
        return 0u;
    return product >> 16 == parts ? (parts - 1u) << 8 : (product >> 8) - 256u;
}

uint index_of(uint at) { return at >> 8; }
uint weight_of(uint at) { return at & 255u; }

// 256 times the value between two neighbours.
uint blend(uint a, uint b, uint weight) { return a * (256u - weight) + b * weight; }

// The same for numbers in two parts, the upper part and the lower 16 bits.
uvec2 blend_long(uvec2 a, uvec2 b, uint weight)
{
    uvec2 sum = a * (256u - weight) + b * weight;
    return uvec2(sum.x + (sum.y >> 16), sum.y & 65535u);
}

uint value_at(ivec2 pixel, int channel)
{
    uint value = bytes_of(quilt, quilt_size.x, quilt_tile, pixel)[channel];
    return texelFetch(light, ivec2(int(value), 0), 0).r;
}

// 2^16 times a view's value at a place.
uvec2 pixel_of(uint number, uint at_x, uint at_y, int channel)
{
    int row = int(number) / grid.x, column = int(number) - row * grid.x;
    ivec2 place = ivec2(column * view.x, quilt_size.y - (row + 1) * view.y) + ivec2(index_of(at_x), index_of(at_y));
    int right = weight_of(at_x) > 0u ? 1 : 0, below = weight_of(at_y) > 0u ? 1 : 0;
    uvec2 columns;
    for (int side = 0; side < 2; ++side) {
        ivec2 top = place + ivec2(side * right, 0);
        columns[side] = blend(value_at(top, channel), value_at(top + ivec2(0, below), channel), weight_of(at_y));
        if (is_separable)
            columns[side] = (columns[side] + 128u) & ~255u;
    }
    uint value = blend(columns[0], columns[1], weight_of(at_x));
    return uvec2(value >> 16, value & 65535u);
}

// 2^24 times the value in a row of views.
uvec2 line_of(uint row, uint from, uint at_x, uint at_y, int channel)
{
    uint number = row * views.x + index_of(from);
    uint next = number + (weight_of(from) > 0u ? 1u : 0u);
    return blend_long(pixel_of(number, at_x, at_y, channel), pixel_of(next, at_x, at_y, channel), weight_of(from));
}

uint subpixel(uint from, uint height, uint at_x, uint at_y, int channel)
{
    uint row = index_of(height);
    uvec2 value = blend_long(line_of(row, from, at_x, at_y, channel),
                             line_of(row + (weight_of(height) > 0u ? 1u : 0u), from, at_x, at_y, channel), weight_of(height));
    uint rounded = (value.x + 32768u) >> 16;
    return texelFetch(stored, ivec2(rounded & 255u, rounded >> 8), 0).r;
}

void main()
{
    ivec2 pixel = ivec2(int(gl_FragCoord.x), panel.y - 1 - int(gl_FragCoord.y));
    if (mirrored.x)
        pixel.x = panel.x - 1 - pixel.x;
    if (mirrored.y)
        pixel.y = panel.y - 1 - pixel.y;
    sent = vec4(0, 0, 0, 1);
    vec3 values = vec3(0);
    if (any(lessThan(pixel, part_shown.xy)) || any(greaterThanEqual(pixel, part_shown.zw)))
        return;
    uvec3 phases = phases_at(across, across_table, pixel) + phases_at(shift, shift_table, pixel);
    uvec3 heights = phases_at(up, up_table, pixel);
    uvec3 places_x = phases_at(x, x_table, pixel), places_y = phases_at(y, y_table, pixel);
    for (int channel = 0; channel < 3; ++channel) {
        if (has_unseen && phases[channel] == unseen)
            continue;
        uint from = step_among(views.x, phases[channel], blends.x);
        uint height = step_among(views.y, heights[channel], blends.x);
        if (only_view >= 0) {
            height = uint(only_view) / views.x << 8;
            from = uint(only_view) % views.x << 8;
        }
        values[channel] = float(subpixel(from, height, step_among(uint(view.x), places_x[channel], blends.y),
                              step_among(uint(view.y), places_y[channel], blends.y), channel));
    }
    sent.rgb = values / 255.0;
}
