#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Changes finished frames as light fields (thesis 5.1, 6.1):

    manipulate.py balance FRAME OUTPUT --patch=X,Y,WIDTH,HEIGHT
    manipulate.py paste FRAME DEPTH.exr OUTPUT --depths=NEAR,FAR --by=COLUMNS,ROWS
    manipulate.py plane FRAME OUTPUT --behind=MM

balance makes a patch of film pixels grey, by a factor for each colour in linear light. paste copies
everything between two depths (mm behind the sheet, negative in front) some lenses to the right and
down; the copy has the same depth, and nearer things hide it. plane moves the sheet to another depth of
the picture, MM behind its old place. paste and plane need lenses that cover whole pixels.
"""
import argparse

import numpy as np

import integral


def numbers(count, kind=float):
    """A reader of so many numbers between commas."""
    def read(text):
        try:
            values = [kind(part) for part in text.split(",")]
        except ValueError:
            values = []
        if len(values) != count or not np.isfinite(values).all():
            what = "whole numbers" if kind is int else "numbers"
            raise argparse.ArgumentTypeError(f"{text}: {count} {what} are expected")
        return values
    return read


def fail(message):
    raise SystemExit(f"manipulate.py: {message}")


def like(frame, linear):
    """A frame of the same geometry whose light is `linear`: floats [y, x, channel]."""
    return integral.Frame(linear, metadata={**frame.metadata, "encoding": {"kind": "linear"}})


def light_field(frame):
    """The frame's light field as a view: what is written to it is written to the frame."""
    field = frame.lightfield()
    if not field.is_view:
        fail("the frame's lenses do not cover whole pixels; render it with such a film")
    return field


def balance(frame, x, y, width, height):
    linear = frame.linear()
    if min(x, y, width - 1, height - 1) < 0 or y + height > len(linear) or x + width > len(linear[0]):
        fail(f"the patch is not inside the frame of {len(linear[0])} x {len(linear)} pixels")
    patch = linear[y:y + height, x:x + width, :3]
    if not (patch.mean(axis=(0, 1)) > 0).all():
        fail("the patch has no light in one of the colours; choose another one")
    means = patch.mean(axis=(0, 1))
    linear[..., :3] *= means.mean() / means
    return like(frame, linear)


def paste(frame, depths, near, far, columns, rows):
    linear = frame.linear()
    if depths.shape != linear.shape[:2] or near > far:
        fail("the depths are of another frame; give its own" if near <= far else
             f"--depths={near:g},{far:g}: the nearer depth comes first")
    depths = np.where(np.isnan(depths), np.inf, depths)
    moved = like(frame, linear)
    old = light_field(like(frame, linear.copy())).samples
    new = light_field(moved).samples
    depth = light_field(like(frame, np.repeat(depths[..., None], 3, axis=2))).samples[..., :1]
    lenses = depth.shape[3], depth.shape[2]
    if abs(columns) >= lenses[0] or abs(rows) >= lenses[1]:
        fail(f"--by={columns},{rows}: the frame has {lenses[0]} x {lenses[1]} lenses")

    def part(array, by):  # the lenses that have a neighbour `by` lenses farther right and down
        (s, t) = by
        height, width = array.shape[2:4]
        return array[:, :, max(0, -t):height - max(0, t), max(0, -s):width - max(0, s)]

    forth, back = (columns, rows), (-columns, -rows)
    seen = (part(depth, forth) >= near) & (part(depth, forth) <= far)
    nearer = part(depth, forth) < part(depth, back)
    target = part(new, back)
    target[...] = np.where(seen & nearer, part(old, forth), target)
    return moved


def plane(frame, behind):
    """Each lens of the new sheet shows, in each direction, the light that crossed the old sheet on
    that ray: interpolated between lenses."""
    linear = frame.linear()
    moved = like(frame, linear)
    old = light_field(like(frame, linear.copy()))
    new = light_field(moved).samples
    pitch = old.s_mm[1] - old.s_mm[0]
    places = np.arange(len(old.s_mm))
    lenticular = old.samples.shape[0] == 1
    for v, u in np.ndindex(new.shape[:2]):
        across, up = old.aperture_mm[v, u] / frame.aperture.distance_mm * behind
        new[v, u] = shifted(old.samples[v, u], 1, places, across / pitch)
        if not lenticular:
            step = old.t_mm[1] - old.t_mm[0]
            new[v, u] = shifted(new[v, u], 0, np.arange(len(old.t_mm)), up / step)
    return moved


def shifted(view, axis, places, by):
    """A view whose row or column k shows what was at k + by; what was outside is the border's."""
    at = np.clip(places + by, 0, len(places) - 1)
    low = np.minimum(at.astype(int), max(0, len(places) - 2))
    part = (at - low).reshape([-1 if k == axis else 1 for k in range(view.ndim)]).astype(view.dtype)
    high = np.minimum(low + 1, len(places) - 1)
    return view.take(low, axis) * (1 - part) + view.take(high, axis) * part


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("balance")
    two = commands.add_parser("paste")
    three = commands.add_parser("plane")
    for command, words in ((one, ["frame", "output"]), (two, ["frame", "depth", "output"]),
                           (three, ["frame", "output"])):
        for word in words:
            command.add_argument(word)
    one.add_argument("--patch", type=numbers(4, int), required=True, metavar="X,Y,W,H")
    two.add_argument("--depths", type=numbers(2), required=True, metavar="NEAR,FAR")
    two.add_argument("--by", type=numbers(2, int), required=True, metavar="COLUMNS,ROWS")
    three.add_argument("--behind", type=numbers(1), required=True, metavar="MM")
    given = parser.parse_args()
    try:
        frame = integral.read(given.frame)
        if frame.metadata is None:
            fail(f"{given.frame} has no geometry; give a frame of povray-integral")
        if given.command == "balance":
            made = balance(frame, *given.patch)
        elif given.command == "paste":
            made = paste(frame, integral.read_depths(given.depth).depth_mm, *given.depths, *given.by)
        else:
            made = plane(frame, *given.behind)
        made.write(given.output)
    except (ValueError, OSError) as error:
        fail(error)


if __name__ == "__main__":
    main()
