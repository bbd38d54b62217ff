#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Finds edges in a frame as straight lines of its epipolar images (thesis 5.1):

    edges.py FRAME PICTURE.png [--csv FILE.csv] [--least 0.05]

An edge of the scene is a line in the epipolar image of a row of lenses: it moves from direction to
direction, the faster the farther it is from the sheet. For each slope the script adds the change of
brightness along the lines of that slope (a Hough transform of edges), and takes the lines on which it adds
up. PICTURE shows them on the middle view: red in front of the sheet, blue behind it. FILE.csv has for
each line the row of lenses, the place at the middle view in mm, the depth in mm behind the sheet, the
strength (change of brightness from a lens to the next, 1 is full scale) and the coherence (1: all
directions see the same change). Edges along the rows of lenses make no lines and are not found.
"""
import argparse
import csv

import numpy as np

import integral

STEEPEST, STEP = 2, 0.05       # slopes that are searched: lenses from one direction to the next
FINE = 4                       # places that are searched between two lenses
COHERENT = 0.5                 # the least coherence


def brightness(frame):
    """The frame's light field [u, t, s] of the directions in the middle height, as a person sees it."""
    light = np.clip(frame.linear()[..., :3] @ np.float32([0.2126, 0.7152, 0.0722]), 0, 1) ** (1 / 2.2)
    metadata = {**frame.metadata, "encoding": {"kind": "linear"}}
    field = integral.Frame(light[..., None].repeat(3, axis=2), metadata=metadata).lightfield()
    return field.samples[field.samples.shape[0] // 2, ..., 0], field


def sheared(changes, by):
    """Row u of an epipolar image, moved by by[u] lenses to the left, at FINE places a lens; 0 beyond the
    ends."""
    places = np.arange(FINE * (changes.shape[-1] - 1) + 1) / FINE + by[:, None]
    low = np.floor(places).astype(int)
    part = (places - low).astype(np.float32)

    def at(k):
        inside = (k >= 0) & (k < changes.shape[-1])
        return np.where(inside, np.take_along_axis(changes, np.clip(k, 0, changes.shape[-1] - 1), 1), 0)

    return at(low) * (1 - part) + at(low + 1) * part


def peak(below, at, above):
    """Where a parabola through three values has its maximum: -0.5 to 0.5 beside the middle one."""
    bend = below - 2 * at + above
    return np.clip(np.where(bend < 0, 0.5 * (below - above) / np.minimum(bend, -1e-9), 0), -0.5, 0.5)


def lines_of(image, directions, least):
    """(place, slope, strength, coherence) arrays of an epipolar image [u, s]: places between lenses in
    the direction 0, slopes in lenses a unit of the directions [u]."""
    changes = np.pad(np.diff(image, axis=1), ((0, 0), (1, 1)))
    changes = 0.25 * changes[:, :-2] + 0.5 * changes[:, 1:-1] + 0.25 * changes[:, 2:]
    slopes = np.arange(-STEEPEST, STEEPEST + STEP / 2, STEP)
    moved = [sheared(changes, slope * directions) for slope in slopes]
    sums = np.abs([one.mean(axis=0) for one in moved])
    squares = np.array([np.square(one).mean(axis=0) for one in moved])
    best = np.clip(sums.argmax(axis=0), 1, len(slopes) - 2)
    s = np.arange(sums.shape[1])
    strength = sums[best, s]
    coherence = strength**2 / np.maximum(squares[best, s], 1e-12)
    padded = np.pad(strength, FINE)
    around = np.lib.stride_tricks.sliding_window_view(padded, 2 * FINE + 1).max(axis=1)
    found = np.nonzero((strength >= least) & (coherence >= COHERENT) & (strength == around))[0]
    k = best[found]
    slope = slopes[k] + STEP * peak(sums[k - 1, found], sums[k, found], sums[k + 1, found])
    beside = padded[found + FINE - 1], padded[found + FINE], padded[found + FINE + 1]
    place = (found + peak(*beside)) / FINE + 0.5
    return place, slope, strength[found], coherence[found]


def eye_step(field):
    """mm between two directions on the aperture, the unit of slopes."""
    return np.diff(field.u_mm).mean()


def depth_of(slopes, field, frame):
    """mm behind the sheet of lines of these slopes."""
    # A lens at s sees, in the direction u, what is at s - u z / distance in the depth z.
    return frame.aperture.distance_mm * slopes * (field.s_mm[1] - field.s_mm[0]) / eye_step(field)


def edges_of(frame, least=0.05):
    """Rows (t, place_mm, depth_mm, strength, coherence), the middle view, and the places in it, in lenses."""
    views, field = brightness(frame)
    if min(views.shape) < 3:
        raise ValueError("the frame needs at least 3 directions, rows and lenses")
    rows, places, middle = [], [], len(views) // 2
    for t in range(views.shape[1]):
        place, slope, strength, coherence = lines_of(views[:, t], field.u_mm / eye_step(field), least)
        mm = np.interp(place, np.arange(len(field.s_mm)), field.s_mm)
        depth = depth_of(slope, field, frame)
        rows += [(t, *values) for values in zip(mm, depth, strength, coherence)]
        places += list(place + slope * field.u_mm[middle] / eye_step(field))
    return rows, views[middle], places


def picture(rows, view, places):
    """The middle view in grey, with the edges in colours."""
    scale = max(1, 900 // view.shape[1])
    tall = max(1, round(scale * 900 / scale / view.shape[1])) if view.shape[0] < view.shape[1] else 1
    shown = 0.6 * view[..., None].repeat(3, axis=2).repeat(scale, axis=1).repeat(tall, axis=0)
    depths = np.array([row[2] for row in rows])
    farthest = np.percentile(np.abs(depths), 95) if len(depths) else 1
    for (t, _, depth, *_), place in zip(rows, places):
        part = np.clip(depth / max(farthest, 1e-9), -1, 1)
        x = min(int((place + 0.5) * scale), shown.shape[1] - 1)
        shown[t * tall:(t + 1) * tall, max(0, x - 1):x + 2] = (
            (1, 1 + part, 1 + part) if part < 0 else (1 - part, 1 - part, 1))
    return shown


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("frame")
    parser.add_argument("picture")
    parser.add_argument("--csv", metavar="FILE.csv")
    parser.add_argument("--least", type=float, default=0.05, metavar="STRENGTH",
                        help="the weakest edge (default: 0.05)")
    given = parser.parse_args()
    try:
        frame = integral.read(given.frame)
        if frame.metadata is None:
            parser.error(f"{given.frame} has no geometry; give a frame of povray-integral")
        rows, view, places = edges_of(frame, given.least)
        shown = np.round(255 * np.clip(picture(rows, view, places), 0, 1)).astype(np.uint8)
        integral.Frame(shown, encoding="srgb").write(given.picture)
        if given.csv:
            with open(given.csv, "w", newline="") as file:
                table = csv.writer(file)
                table.writerow(["row", "place_mm", "depth_mm", "strength", "coherence"])
                table.writerows((row[0], *(f"{value:.5g}" for value in row[1:])) for row in rows)
        print(f"{len(rows)} edges in {view.shape[0]} rows")
    except (ValueError, OSError) as error:
        parser.error(str(error))


if __name__ == "__main__":
    main()
