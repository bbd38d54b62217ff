#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Makes a frame of the raw picture of a plenoptic camera, with its micro-lenses focused on the main lens:

    plenoptic.py RAW FRAME --pitch PIXELS [--white WHITE] [--square] [--f-number 4]
                 [--views QUILT.png] [--turn DEGREES] [RECTIFY OPTION...]

RAW is an upright picture in colour (developed from the sensor's mosaic), PIXELS about the distance of its
micro-images, within 4%, in a hexagonal or square grid. WHITE is such a picture of a white wall, by which
RAW is divided; without it, dark borders between micro-images may hide their places. `integral rectify` finds their places and turn. The
raw picture is the frame that an eye in the main lens's place would see, with depth turned round; the
script puts its views in the opposite order, so that the frame shows near things in front. The f-number
scales the depths. Other options are rectify's. A raw pixel counts as 0.1 mm.
"""
import argparse
import os
import subprocess
import tempfile

import numpy as np

import integral

PIXEL_MM = 0.1
DARKEST = 0.02  # of the white picture's light: what is darker is not divided by less
FAR = 1000      # the main lens's distance, in pitches: the micro-images' spread is rectify's to find


def fail(message):
    raise SystemExit(f"plenoptic.py: {message}")


def evened(raw, white):
    """The raw picture in linear light, divided by that of a white wall."""
    light, wall = raw.linear()[..., :3], white.linear()[..., :3]
    if light.shape != wall.shape:
        fail("the white picture has another size than the raw one")
    full = np.percentile(wall, 99.5, axis=(0, 1))
    return integral.Frame(light * (full / np.maximum(wall, DARKEST * full)).astype(np.float32),
                          encoding="linear")


def rectified(given, words, raw, output):
    """The frame of a raw picture: its depth is turned round."""
    micro_image = given.pitch * PIXEL_MM
    distance = FAR * micro_image
    pitch = micro_image / (1 + given.f_number * micro_image / distance)
    command = [given.integral, "rectify", raw, "-o", output, "--scan-dpi", f"{25.4 / PIXEL_MM}",
               "--arrangement", "square" if given.square else "hexagonal", "--pitch", f"{pitch!r}",
               "--thickness", f"{given.f_number * pitch!r}", "--ior", "1", "--distance", f"{distance!r}",
               "--pixel-pitch", f"{pitch / round(given.pitch)!r}", *words]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    except OSError as error:
        fail(f"{given.integral}: {error.strerror}; give the program's path by --integral")
    if done.returncode:
        raise SystemExit(done.stderr.strip())
    print(done.stdout + done.stderr, end="")
    return integral.read(output)


def turned_round(frame):
    """The views in the opposite order, and a frame of them: near things stand in front of the sheet."""
    views = integral.views(frame)[::-1, ::-1]
    made = integral.frame_from_views(views, frame.sheet, frame.film, frame.aperture,
                                     encoding=frame.encoding)
    return views, made


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0], allow_abbrev=False)
    parser.add_argument("raw")
    parser.add_argument("frame")
    parser.add_argument("--pitch", type=float, required=True, metavar="PIXELS")
    parser.add_argument("--white", metavar="WHITE", help="a raw picture of a white wall")
    parser.add_argument("--square", action="store_true", help="a square grid, not a hexagonal one")
    parser.add_argument("--f-number", type=float, default=4, metavar="N",
                        help="of the micro-lenses (default: 4)")
    parser.add_argument("--views", metavar="QUILT.png", help="write the views, a pixel for each lens")
    parser.add_argument("--integral", default="integral", metavar="PROGRAM")
    given, words = parser.parse_known_args()
    if not 3 <= given.pitch <= 1000 or not 0.5 <= given.f_number <= 100:
        parser.error("a pitch from 3 to 1000 pixels and an f-number from 0.5 to 100 are expected")
    try:
        with tempfile.TemporaryDirectory() as scratch:
            raw = given.raw
            if given.white:
                raw = os.path.join(scratch, "evened.tiff")
                evened(integral.read(given.raw), integral.read(given.white)).write(raw)
            views, frame = turned_round(rectified(given, words, raw, os.path.join(scratch, "raw.png")))
        frame.write(given.frame)
        if given.views:
            print(integral.Quilt(views, encoding=frame.encoding).write(given.views))
    except (ValueError, OSError) as error:
        fail(error)


if __name__ == "__main__":
    main()
