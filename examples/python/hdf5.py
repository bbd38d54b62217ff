#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Exchanges light fields with HDF5 files (package python3-h5py):

    hdf5.py write FRAME FILE.h5
    hdf5.py read FILE.h5 FRAME [--sheet SHEET.json]

write stores a frame's light field LF[v, u, t, s, channel], its axes in mm, its picture image[y, x,
channel] and its document: `read` makes the same frame of it, with what LF has become if each lens covers
whole pixels; otherwise LF is interpolated, and stays what it was. A file without the document is one of views LF[v, u, y, x, channel], as data_set.py
--hdf5 and the tools of the HCI 4D Light Field Benchmark write: v = 0 is the row from above, u = 0 the
column from the left. `read` then makes a frame for the sheet and film of --sheet (`integral sheet --json`),
whose eyes see the views from equal parts of its viewing zone.
"""
import argparse
import json

import numpy as np

import integral

try:
    import h5py
except ImportError:
    raise SystemExit("hdf5.py: the package python3-h5py is missing; install it") from None

AXES = ("u_mm", "v_mm", "s_mm", "t_mm", "aperture_mm", "poles_mm")


def fail(message):
    raise SystemExit(f"hdf5.py: {message}")


def write(frame, path):
    field = frame.lightfield()
    with h5py.File(path, "w") as file:
        file.create_dataset("LF", data=field.samples, compression="gzip")
        file.create_dataset("image", data=frame.image, compression="gzip")
        for name in AXES:
            file[name] = getattr(field, name)
        file.attrs["integral"] = json.dumps(frame.metadata)
        file.attrs["is_view"] = field.is_view
    return field


def frame_of_light_field(samples, image, attributes):
    """The frame whose light field was written."""
    frame = integral.Frame(image, metadata=json.loads(attributes["integral"]))
    if attributes["is_view"]:
        frame.lightfield().samples[...] = samples
    return frame


def frame_of_views(samples, sheet_path):
    """The frame that shows views from above and from the left."""
    if sheet_path is None:
        fail("the file has views; give --sheet FILE.json for the frame's sheet and film")
    with open(sheet_path) as file:
        document = json.load(file)
    film = document["film"]
    blank = integral.Frame(np.zeros((film["height"], film["width"], 3), np.uint8), metadata=document)
    return integral.frame_from_views(samples[::-1], blank.sheet, blank.film, blank.aperture, eyes=True)


def read(path, sheet_path=None):
    with h5py.File(path, "r") as file:
        if "LF" not in file or file["LF"].ndim != 5:
            fail(f"{path} has no light field LF of five axes")
        samples, attributes = file["LF"][:], dict(file.attrs)
        if "integral" in attributes:
            return frame_of_light_field(samples, file["image"][:], attributes)
    return frame_of_views(samples, sheet_path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("write")
    one.add_argument("frame")
    one.add_argument("file")
    two = commands.add_parser("read")
    two.add_argument("file")
    two.add_argument("frame")
    two.add_argument("--sheet", metavar="SHEET.json")
    given = parser.parse_args()
    try:
        if given.command == "write":
            field = write(integral.read(given.frame), given.file)
            print(f"{given.file}: LF{list(field.samples.shape)} of {field.samples.dtype}")
        else:
            frame = read(given.file, given.sheet)
            frame.write(given.frame)
            print(f"{given.frame}: {frame!r}")
    except (ValueError, OSError, KeyError) as error:
        fail(error)


if __name__ == "__main__":
    main()
