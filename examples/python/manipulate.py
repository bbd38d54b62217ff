#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Changes finished frames as light fields (thesis 5.1, 6.1):

    manipulate.py balance FRAME OUTPUT --patch=X,Y,WIDTH,HEIGHT
    manipulate.py match FRAME REFERENCE OUTPUT
    manipulate.py cut FRAME DEPTH.exr OUTPUT OUTPUT_DEPTH.exr --depths=NEAR,FAR [--by=COLUMNS,ROWS]
    manipulate.py paste FRAME DEPTH.exr OUTPUT --depths=NEAR,FAR --by=COLUMNS,ROWS
    manipulate.py plane FRAME OUTPUT --behind=MM
    manipulate.py parallax FRAME OUTPUT --factor=K

balance makes a patch of film pixels grey, by a factor for each colour in linear light. match brings a
frame's colours as near as one 3 x 3 matrix can to those of another frame of the same pixels, as a scan's
to those of the frame that was printed. cut keeps everything between two depths (mm behind the sheet,
negative in front), some lenses farther to the right and down, and makes the rest transparent: integral
combine puts it into another frame. paste copies it within the frame; the copy has the same depth, and
nearer things hide it. plane moves the sheet to another depth of the picture, MM behind its old place.
parallax makes an eye that moves see what K times its way showed before: the picture gets flatter or
deeper. cut, paste, plane and parallax need lenses that cover whole pixels.
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
            raise argparse.ArgumentTypeError(f"{text}: " + (f"{count} {what} are expected" if count > 1
                                                            else "a number is expected"))
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


def match(frame, reference):
    linear, wanted = frame.linear(), reference.linear()[..., :3]
    if linear.shape[:2] != wanted.shape[:2]:
        fail(f"the frames have {linear.shape[1]} x {linear.shape[0]} and {wanted.shape[1]} x "
             f"{wanted.shape[0]} pixels; give frames of one size")
    colours = linear[..., :3].reshape(-1, 3)
    matrix, _, rank, _ = np.linalg.lstsq(colours, wanted.reshape(-1, 3), rcond=1e-4)
    if rank < 3:
        fail("the frame has too few colours for a matrix; balance does with one")
    linear[..., :3] = np.maximum(colours @ matrix, 0).reshape(wanted.shape)
    return like(frame, linear)


def depth_field(frame, depths, near, far):
    """The depths [v, u, t, s, 1] of a frame's light field; infinite where a pixel images nothing."""
    if depths.shape != frame.image.shape[:2] or near > far:
        fail("the depths are of another frame; give its own" if near <= far else
             f"--depths={near:g},{far:g}: the nearer depth comes first")
    depths = np.where(np.isnan(depths), np.inf, depths)
    return light_field(like(frame, np.repeat(depths[..., None], 3, axis=2))).samples[..., :1]


def parts(array, columns, rows):
    """The lenses that have a neighbour so many lenses farther right and down, and these neighbours."""
    height, width = array.shape[2:4]
    if abs(columns) >= width or abs(rows) >= height:
        fail(f"--by={columns},{rows}: the frame has {width} x {height} lenses")
    return (array[:, :, max(0, -t):height - max(0, t), max(0, -s):width - max(0, s)]
            for s, t in ((columns, rows), (-columns, -rows)))


def cut(frame, depths, near, far, columns, rows):
    """The frame of what lies between two depths, transparent elsewhere, and its depths [y, x]."""
    depth = depth_field(frame, depths, near, far)
    linear = frame.linear()[..., :3]
    old = light_field(like(frame, linear)).samples
    moved = like(frame, np.zeros((*linear.shape[:2], 4), np.float32))
    moved_depth = like(frame, np.full_like(linear, np.inf))
    source_depth, _ = parts(depth, columns, rows)
    source, _ = parts(old, columns, rows)
    _, target = parts(light_field(moved).samples, columns, rows)
    _, target_depth = parts(light_field(moved_depth).samples, columns, rows)
    inside = (source_depth >= near) & (source_depth <= far)
    target[...] = np.where(inside, np.concatenate([source, np.ones_like(source[..., :1])], axis=-1), 0)
    target_depth[...] = np.where(inside, source_depth, np.inf)
    return moved, moved_depth.image[..., 0]


def paste(frame, depths, near, far, columns, rows):
    depth = depth_field(frame, depths, near, far)
    linear = frame.linear()
    moved = like(frame, linear)
    old = light_field(like(frame, linear.copy())).samples
    source_depth, own_depth = parts(depth, columns, rows)
    source, _ = parts(old, columns, rows)
    _, target = parts(light_field(moved).samples, columns, rows)
    seen = (source_depth >= near) & (source_depth <= far) & (source_depth < own_depth)
    target[...] = np.where(seen, source, target)
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


def parallax(frame, factor):
    """Each direction shows the light of the direction `factor` times as far from the middle:
    interpolated between directions; beyond the outermost one, that one."""
    linear = frame.linear()
    moved = like(frame, linear)
    old = light_field(like(frame, linear.copy())).samples
    new = light_field(moved).samples
    for axis in (0, 1):
        places = np.arange(old.shape[axis])
        middle = (len(places) - 1) / 2
        old = shifted(old, axis, places, (factor - 1) * (places - middle)) if len(places) > 1 else old
    new[...] = old
    return moved


def shifted(view, axis, places, by):
    """A view whose row or column k shows what was at k + by (a number, or one for each k); what was
    outside is the border's."""
    at = np.clip(places + by, 0, len(places) - 1)
    low = np.minimum(at.astype(int), max(0, len(places) - 2))
    part = (at - low).reshape([-1 if k == axis else 1 for k in range(view.ndim)]).astype(view.dtype)
    high = np.minimum(low + 1, len(places) - 1)
    return view.take(low, axis) * (1 - part) + view.take(high, axis) * part


def options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    commands = parser.add_subparsers(dest="command", required=True)
    words = {"balance": "frame output", "match": "frame reference output",
             "cut": "frame depth output output_depth", "paste": "frame depth output",
             "plane": "frame output", "parallax": "frame output"}
    by_name = {name: commands.add_parser(name) for name in words}
    for name, command in by_name.items():
        for word in words[name].split():
            command.add_argument(word)
        if "depth" in words[name]:
            command.add_argument("--depths", type=numbers(2), required=True, metavar="NEAR,FAR")
            command.add_argument("--by", type=numbers(2, int), required=name == "paste", default=(0, 0),
                                 metavar="COLUMNS,ROWS")
    by_name["balance"].add_argument("--patch", type=numbers(4, int), required=True, metavar="X,Y,W,H")
    by_name["plane"].add_argument("--behind", type=numbers(1), required=True, metavar="MM")
    by_name["parallax"].add_argument("--factor", type=numbers(1), required=True, metavar="K")
    return parser.parse_args()


def make(given):
    frame = integral.read(given.frame)
    if frame.metadata is None:
        fail(f"{given.frame} has no geometry; give a frame of povray-integral")
    if given.command in ("cut", "paste"):
        depths = integral.read_depths(given.depth)
        made = (cut if given.command == "cut" else paste)(frame, depths.depth_mm, *given.depths, *given.by)
        if given.command == "cut":
            made, depth = made
            integral.write_depths(given.output_depth, depth, depths.metadata)
    elif given.command == "balance":
        made = balance(frame, *given.patch)
    elif given.command == "match":
        made = match(frame, integral.read(given.reference))
    elif given.command == "plane":
        made = plane(frame, *given.behind)
    else:
        made = parallax(frame, *given.factor)
    made.write(given.output)


def main():
    try:
        make(options())
    except (ValueError, OSError) as error:
        fail(error)


if __name__ == "__main__":
    main()
