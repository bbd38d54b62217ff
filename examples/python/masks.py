# SPDX-License-Identifier: AGPL-3.0-or-later
"""Regions of a true disparity map in which the HCI 4D Light Field Benchmark's toolkit scores apart.

data_set.py writes them. The benchmark's authors chose their regions scene by scene; these follow from the
disparities alone. Lengths are in pixels of a view; a map may have `scale` x `scale` values a pixel.
"""
import struct
import zlib

import numpy as np

STEP = 0.1        # disparity: a greater difference of neighbours is an edge between surfaces
NEAR_EDGE = 3     # discontinuities: this far from an edge
FLAT = 1e-5       # disparity: the greatest second difference over a pixel on a plane
THIN = 7          # fine structures vanish under a window of this width
AROUND_FINE = 5   # their surroundings


def box(values, radius, combine):
    """The minimum (combine=np.minimum) or maximum of the values in a square around each, 2 radius + 1 wide."""
    for axis in (0, 1):
        values = np.moveaxis(values, axis, 0)
        values = np.concatenate([values[:1]] * radius + [values] + [values[-1:]] * radius)
        width, step = 2 * radius + 1, 1
        while 2 * step <= width:
            values, step = combine(values[:-step], values[step:]), 2 * step
        if step < width:
            values = combine(values[:step - width], values[width - step:])
        values = np.moveaxis(values, 0, axis)
    return values


def edges(disparities):
    """Pixels with a neighbour, right, left, above or below, across an edge."""
    found = np.zeros(disparities.shape, bool)
    for values, marks in ((disparities, found), (disparities.T, found.T)):
        step = np.abs(np.diff(values, axis=0)) > STEP
        marks[1:] |= step
        marks[:-1] |= step
    return found


def bend(disparities, step):
    """The greatest of three second differences over so many values; 0 on a plane."""
    d = np.pad(disparities, step, mode="reflect", reflect_type="odd")
    s, height, width = step, *disparities.shape

    def at(down, right):
        return d[s + down:s + down + height, s + right:s + right + width]

    across = np.abs(at(0, s) - 2 * disparities + at(0, -s))
    down = np.abs(at(s, 0) - 2 * disparities + at(-s, 0))
    mixed = np.abs(at(s, s) - at(s, -s) - at(-s, s) + at(-s, -s)) / 4
    return np.maximum(np.maximum(across, down), mixed)


def masks(disparities, surfaces, scale=1):
    """The regions by the names of their files. `surfaces`: pixels that show a surface."""
    edge = edges(disparities)
    near = box(edge, NEAR_EDGE * scale, np.maximum)
    within = surfaces & ~near
    planes = within & (bend(disparities, scale) < FLAT)
    smooth = box(box(within & ~planes, scale, np.minimum), scale, np.maximum)  # without creases
    thin = THIN * scale // 2
    fine = disparities - box(box(disparities, thin, np.minimum), thin, np.maximum) > STEP
    around = box(fine, AROUND_FINE * scale, np.maximum) & ~fine
    return {"discontinuities": near, "planes": planes, "smooth_surfaces": smooth & within, "fine": fine,
            "fine_surrounding": around}


def reduced(mask, name, scale):
    """The mask of pixels: surfaces need all of a pixel, edges and fine structures any part of it."""
    blocks = mask.reshape(mask.shape[0] // scale, scale, -1, scale)
    return blocks.all(axis=(1, 3)) if name in ("planes", "smooth_surfaces") else blocks.any(axis=(1, 3))


def write_grey_png(path, values):
    """Writes uint8 [y, x] as a grey PNG, which the toolkit reads as an array of two axes."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width = values.shape
    rows = np.pad(values, ((0, 0), (1, 0))).tobytes()     # each begins with 0: it is not filtered
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows, 6)) + chunk(b"IEND", b""))


def write_masks(folder, disparities, surfaces, scale):
    """Writes mask_NAME_lowres.png of a map with scale x scale values a pixel, and mask_NAME_highres.png
    if scale is more than 1. Regions without a pixel get no file: the toolkit then leaves their score out."""
    for name, mask in masks(disparities, surfaces, scale).items():
        for resolution, pixels in (("highres", mask), ("lowres", reduced(mask, name, scale))):
            if pixels.any() and (resolution == "lowres" or scale > 1):
                write_grey_png(folder / f"mask_{name}_{resolution}.png", pixels.astype(np.uint8) * 255)
