#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Draws a frame's middle view and, below it, the epipolar image of a row of lenses:

    epipolar.py FRAME OUTPUT.png [--row T]

An epipolar image has the lenses of the row across and the directions downwards. A point on the sheet
is an upright line in it; points behind and in front of the sheet lean to opposite sides, the more the
farther they are from the sheet. T counts rows from the top (default: the middle one). The view is
drawn as the array has it: without the shift of lenses that hexagonal and slanted sheets have.
"""
import argparse

import numpy as np

import integral

WIDTH = 1000  # pixels of the picture, about


def epipolar(field, row):
    """[u, s, channel]: the light of a row of lenses in each direction across them."""
    return field.samples[field.samples.shape[0] // 2, :, row]


def drawn(field, row):
    """The picture: view and epipolar image, with a grey line between them."""
    middle = field.samples[field.samples.shape[0] // 2, field.samples.shape[1] // 2]
    across = max(1, round(WIDTH / middle.shape[1]))
    # Behind lenticular lenses a row of the array is a row of film pixels, and a column is a lens.
    share = abs(field.t_mm[1] - field.t_mm[0]) / abs(field.s_mm[1] - field.s_mm[0])
    rows = np.arange(round(middle.shape[0] * across * share)) / (across * share)
    view = middle[np.minimum(rows.astype(int), middle.shape[0] - 1)].repeat(across, axis=1)
    line = np.full((4, *view.shape[1:]), view.max() // 2 if view.dtype.kind == "u" else 0.5)
    lines = epipolar(field, row).repeat(max(1, across // 2), axis=0).repeat(across, axis=1)
    return np.concatenate([view, line.astype(view.dtype), lines])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("frame")
    parser.add_argument("output")
    parser.add_argument("--row", type=int, metavar="T")
    given = parser.parse_args()
    try:
        frame = integral.read(given.frame)
        field = frame.lightfield()
    except (ValueError, OSError) as error:
        parser.error(str(error))
    if min(field.samples.shape[1:4]) < 2:
        parser.error("the frame needs two rows, two lenses and directions that differ sideways")
    rows = field.samples.shape[2]
    row = rows // 2 if given.row is None else given.row
    if not 0 <= row < rows:
        parser.error(f"--row {row}: the rows are 0 to {rows - 1}")
    try:
        integral.Frame(drawn(field, row), encoding=frame.encoding).write(given.output)
    except (ValueError, OSError) as error:
        parser.error(str(error))


if __name__ == "__main__":
    main()
