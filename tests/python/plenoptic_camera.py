# SPDX-License-Identifier: AGPL-3.0-or-later
"""examples/python/plenoptic.py, on raw pictures by closed form: a camera looks at a painted wall, at a
smaller painted wall before it, and focuses between them."""
import glob
import os
import subprocess
import sys

import numpy as np

import integral
from cases import near, run

PITCH, TURN, SIZE = 9.94, 0.7, (620, 500)    # pixels, degrees, pixels
FOCUS, NEAR, FAR = 1000.0, 850.0, 1200.0     # mm from the main lens
PUPIL, FIELD = 60.0, 300.0                   # mm: the lens's diameter, the width seen at FOCUS


def paint(x, y, wave):
    """Smooth colours, [..., 3] from 0 to 1."""
    return np.stack([0.5 + 0.22 * np.sin(x / wave + phase) + 0.22 * np.cos(y / wave - 2 * phase)
                     for phase in (0, 1, 2)], axis=-1)


def scene(eye, point):
    """The colour that the part `eye` [..., 2] of the main lens sees in the direction of a point in focus;
    x to the right, y up."""
    at = {z: eye + (point - eye) * (z / FOCUS) for z in (NEAR, FAR)}
    front = (np.abs(at[NEAR]) < 60).all(axis=-1)
    return np.where(front[..., None], paint(at[NEAR][..., 0], at[NEAR][..., 1], 5),
                    paint(at[FAR][..., 0] + 70, at[FAR][..., 1], 8))


def raw_picture(hexagonal):
    """The raw picture, and that of a white wall. Each pixel belongs to the micro-image that it is in. The
    optical image is turned by 180 degrees, and the stored picture is that turned back: light of the main
    lens's right part, which a micro-lens images to its left, is stored to the right of its middle."""
    x, y = np.meshgrid(np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2, SIZE[1] / 2 - np.arange(SIZE[1]) - 0.5)
    c, s = np.cos(np.radians(TURN)), np.sin(np.radians(TURN))
    grid = np.stack([c * x + s * y, c * y - s * x], axis=-1) / PITCH      # along the rows of lenses
    tall = np.sqrt(0.75) if hexagonal else 1
    best, lens = np.full(x.shape, np.inf), np.zeros(grid.shape)
    for shift in (0, 0.5) if hexagonal else (0,):     # even rows, odd rows
        row = np.round((grid[..., 1] / tall - 2 * shift) / (2 if hexagonal else 1))
        row = (2 if hexagonal else 1) * row + 2 * shift
        centre = np.stack([np.round(grid[..., 0] - shift) + shift, row * tall], axis=-1)
        off = np.square(grid - centre).sum(axis=-1)
        lens = np.where((off < best)[..., None], centre, lens)
        best = np.minimum(off, best)
    back = np.array([[c, s], [-s, c]])
    place, offset = lens @ back, (grid - lens) @ back       # upright again: in pitches
    light = scene(offset * PUPIL, place * (FIELD * PITCH / SIZE[0]))
    # Round micro-images that nearly touch, darker towards their soft borders; some light strays.
    white = 0.04 + 0.96 * np.clip((0.5 - np.sqrt(best)) / 0.08, 0, 1) * (1 - best)
    return white[..., None] * light, white[..., None].repeat(3, axis=-1)


def made(hexagonal):
    """The frame that the script makes of the raw picture."""
    name = "hexagonal" if hexagonal else "square"
    for what, light in zip(("raw", "white"), raw_picture(hexagonal)):
        integral.Frame(light, encoding="linear").write(f"{what}-{name}.tiff")
    script = os.path.join(os.environ["TOP"], "examples/python/plenoptic.py")
    done = subprocess.run([sys.executable, script, f"raw-{name}.tiff", f"frame-{name}.png", "--pitch", "10",
                           "--white", f"white-{name}.tiff", "--views", f"views-{name}.png",
                           "--integral", os.environ["INTEGRAL"], *([] if hexagonal else ["--square"])],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] in glob.glob(f"views-{name}_qs*.png"), done.stdout
    return integral.read(f"frame-{name}.png")


def errors(frame, order):
    """Errors of the frame's light, sample by sample, in the middle of the picture. `order`: -1 if the
    lens's parts were exchanged."""
    linear = integral.Frame(frame.linear(), metadata={**frame.metadata, "encoding": {"kind": "linear"}})
    field = linear.lightfield((7, 7))
    c, s = np.cos(np.radians(TURN)), np.sin(np.radians(TURN))
    lens = field.poles_mm / frame.sheet.pitch_mm
    inside = (np.abs(lens) < (24, 19)).all(axis=-1)
    part = order * field.aperture_mm / frame.aperture.distance_mm * frame.sheet.thickness_mm / \
        frame.sheet.pitch_mm
    place = lens @ np.array([[c, s], [-s, c]]) * (FIELD * PITCH / SIZE[0])
    expected = scene(part[:, :, None, None] * PUPIL, place[None, None])
    return np.abs(field.samples - expected)[:, :, inside]


def check_frame(hexagonal):
    frame = made(hexagonal)
    assert np.median(errors(frame, 1)) < 0.02 < 0.1 < np.median(errors(frame, -1))
    assert np.percentile(errors(frame, 1), 80) < 0.06, np.percentile(errors(frame, 1), 80)
    return frame


def test_square_micro_lenses():
    # A part of the pupil sees a point at distance z shifted by the part's place times 1 - FOCUS / z.
    frame = check_frame(False)
    depth = integral.depth(frame).depth_mm
    pitches = PUPIL * SIZE[0] / PITCH / FIELD
    for z, (rows, columns) in ((NEAR, (slice(18, 33), slice(24, 39))), (FAR, (slice(4, 12), slice(8, 55)))):
        expected = pitches * (1 - FOCUS / z) * frame.sheet.thickness_mm
        near(np.median(depth[rows, columns]), expected, 0.5)


def test_hexagonal_micro_lenses():
    check_frame(True)


if __name__ == "__main__":
    run(globals())
