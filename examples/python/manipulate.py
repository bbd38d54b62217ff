#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Changes finished frames as light fields (thesis 5.1, 6.1):

    manipulate.py balance FRAME OUTPUT --patch X,Y,WIDTH,HEIGHT
    manipulate.py paste FRAME DEPTH.exr OUTPUT --depths NEAR,FAR --by COLUMNS,ROWS
    manipulate.py plane FRAME OUTPUT --behind MM

balance makes a patch of film pixels grey, by a factor for each colour in linear light. paste copies
what lies between two depths (mm behind the sheet, negative in front) to lenses farther right and
down, at its own depth and hidden by what is nearer. plane moves the sheet's plane through the
picture: what was MM behind the sheet comes to lie on it. The last two need lenses of whole pixels.
"""
import argparse

import numpy as np

import integral


def numbers(count, kind=float):
    def parse(text):
        values = [kind(part) for part in text.split(",")]
        if len(values) != count:
            raise argparse.ArgumentTypeError(f"{text}: {count} numbers are expected")
        return values
    return parse


def like(frame, linear):
    """A frame of the same geometry whose light is `linear`: floats [y, x, channel]."""
    return integral.Frame(linear, metadata={**frame.metadata, "encoding": {"kind": "linear"}})


def light_field(frame):
    """The frame's light field as a view: what is written to it is written to the frame."""
    field = frame.lightfield()
    if not field.is_view:
        raise SystemExit("manipulate.py: the frame's lenses do not cover whole pixels")
    return field


def balance(frame, x, y, width, height):
    linear = frame.linear()
    patch = linear[y:y + height, x:x + width, :3]
    if patch.size == 0 or not (patch.mean(axis=(0, 1)) > 0).all():
        raise SystemExit("manipulate.py: the patch has no light in one of the colours")
    means = patch.mean(axis=(0, 1))
    linear[..., :3] *= means.mean() / means
    return like(frame, linear)


def paste(frame, depths, near, far, columns, rows):
    linear = frame.linear()
    depths = np.where(np.isnan(depths), np.inf, depths)
    moved = like(frame, linear)
    old = light_field(like(frame, linear.copy())).samples
    new = light_field(moved).samples
    depth = light_field(like(frame, np.repeat(depths[..., None], 3, axis=2))).samples[..., :1]

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
    """A direction's ray meets the plane `behind` the sheet beside the place where it left its lens:
    there the light of the lenses around is interpolated."""
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
    three.add_argument("--behind", type=float, required=True, metavar="MM")
    given = parser.parse_args()
    frame = integral.read(given.frame)
    if given.command == "balance":
        made = balance(frame, *given.patch)
    elif given.command == "paste":
        made = paste(frame, integral.read_depths(given.depth).depth_mm, *given.depths, *given.by)
    else:
        made = plane(frame, given.behind)
    made.write(given.output)


if __name__ == "__main__":
    main()
