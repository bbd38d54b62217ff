#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Compares the flicker of lens sheets of several pitches on one printer's pixels (thesis 6.1):

    moire.py FOLDER [--scene SCENE.pov] [--dpi 600] [--pixels 14,14.25,14.5,14.75,15]
             [RENDERER OPTION...]

An eye that moves sideways sees the picture flicker, as it passes from pixel to pixel. If a lens pitch is
a whole number of pixels for the eye, this happens everywhere at once; otherwise in stripes, the moire.
For each number of pixels in a pitch the script renders the scene, replays it with a pupil for eyes side
by side, and takes off the mean over all places where the printer's raster may stand. FOLDER then has
moire.csv and the plot moire.png of three figures, and eyes.png, what the eyes see from top to bottom
and, on the right, its deviation from the mean:

    flicker   rms of the deviation, 1 is full scale
    jumps     how much the flicker of the whole picture varies while the eye moves: the standard
              deviation of the squared deviation's mean, by its mean
    stripes   the same for areas a few mm wide, so that it includes the jumps

The scene's camera is a perspective one; without --scene it is a wall 15 mm behind the sheet.
"""
import argparse
import copy
import csv
import pathlib
import subprocess
import tempfile

import numpy as np

import integral

FINE = 8            # places of the raster: a print's pixel is the mean of so many rendered ones
SIZE_MM = (80, 48)  # of the sheet
ROWS = 24           # of film pixels, which lenticular lenses need not resolve
THICKNESS_MM, IOR = 2.0, 1.56
JUMPS = 2           # pixels that the eye's way passes
GAIN = 8            # of the deviations in eyes.png
SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -400> direction 400*z right 80*x up 48*y }
plane { z, 15 pigment { granite scale 8 } finish { ambient 1 diffuse 0 } }
"""


def numbers(text):
    values = [float(part) for part in text.split(",")]
    if min(values) < 3:
        raise argparse.ArgumentTypeError(f"{text}: at least 3 pixels a lens are expected")
    return values


def render(given, words, pitch_mm, fine_mm, output):
    """The scene's frame behind lenses of this pitch: pixels of fine_mm across."""
    columns = round(SIZE_MM[0] / fine_mm / FINE) * FINE
    camera = (f"lens_sheet {{ lenticular pitch {pitch_mm!r} thickness {THICKNESS_MM} ior {IOR} }} "
              f"film {{ pixel_pitch <{fine_mm!r}, {SIZE_MM[1] / ROWS}> }}")
    command = [given.renderer, f"+I{given.scene}", *words, f"+O{output}", "+FN16", f"+W{columns}",
               f"+H{ROWS}", "-D", f"Integral_Camera={camera}", "Integral_Audit=off"]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    except OSError as error:
        raise SystemExit(f"moire.py: {given.renderer}: {error.strerror}; give povray-integral's path by "
                         "--renderer") from error
    if done.returncode:
        raise SystemExit("\n".join([line for line in done.stderr.splitlines() if line.strip()][-5:]))
    return integral.read(output)


def with_pixels(frame, linear, pixel_mm):
    """A frame of the same sheet with this picture and pixels of this width."""
    metadata = copy.deepcopy(frame.metadata)
    metadata["encoding"] = {"kind": "linear"}
    metadata["film"].update(width=linear.shape[1], height=linear.shape[0],
                            pixel_pitch_mm=[pixel_mm, frame.film.pixel_pitch_mm[1]])
    return integral.Frame(linear, metadata=metadata)


def printed(frame):
    """The print's frame, each of whose pixels is the mean of FINE rendered ones, and a frame of the mean
    light over the FINE places where the printer's raster may stand."""
    linear, fine_mm = frame.linear(), frame.film.pixel_pitch_mm[0]
    rows, columns = linear.shape[:2]
    pixels = linear.reshape(rows, columns // FINE, FINE, -1).mean(axis=2)
    padded = np.pad(linear, ((0, 0), (FINE - 1, FINE - 1), (0, 0)), mode="edge")
    weights = (FINE - np.abs(np.arange(1 - FINE, FINE))) / FINE**2
    mean = sum(weight * padded[:, k:k + columns] for k, weight in enumerate(weights))
    return (with_pixels(frame, pixels, FINE * fine_mm),
            with_pixels(frame, mean.astype(np.float32), fine_mm))


def eye_step(frame, pixel_mm):
    """mm that an eye moves from one pixel of a lens to the next."""
    return frame.aperture.distance_mm * pixel_mm * frame.sheet.ior / frame.sheet.thickness_mm


def seen(frame, eyes, pupil):
    """[eye, y, x, channel] in linear light: a picture element for each lens, without the lenses at the
    ends, which the film does not fill."""
    (width, height), lens = SIZE_MM, frame.sheet.pitch_mm
    lenses = 2 * int(width / lens / 2 - 2) + 1
    return np.stack([integral.replay(frame, (x, 0, frame.aperture.distance_mm), (lenses, ROWS),
                                     pupil=pupil, part=(0, 0, lenses * lens, height),
                                     fit="stretch")[..., :3] for x in eyes])


def encoded(linear):
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear**(1 / 2.4) - 0.055)


def figures_of(deviations, columns):
    """flicker, jumps and stripes of deviations [eye, y, x, channel]; areas have so many columns."""
    power = np.square(deviations).mean(axis=(1, 3))
    sums = np.cumsum(np.pad(power, ((0, 0), (1, 0))), axis=1)
    areas = (sums[:, columns:] - sums[:, :-columns]) / columns
    whole = power.mean(axis=1)
    mean = np.square(areas.mean(axis=0)).mean()
    return {"flicker": np.sqrt(whole.mean()), "jumps": whole.std() / whole.mean(),
            "stripes": np.sqrt(areas.var(axis=0).mean() / mean)}


def experiment(given, words, distance, pixels, scratch):
    """The figures of one pitch; what the eyes see, and its deviation: the middle row."""
    pixel = 25.4 / given.dpi
    pitch = pixels * pixel / (1 + THICKNESS_MM / (IOR * distance))  # an eye sees `pixels` of them
    frame = render(given, words, pitch, pixel / FINE, f"{scratch}/frame.png")
    of_print, of_mean = printed(frame)
    way = JUMPS * eye_step(frame, pixel)
    eyes = (np.arange(given.eyes) / given.eyes - 0.5) * way
    pictures, means = (encoded(seen(one, eyes, given.pupil)) for one in (of_print, of_mean))
    deviations = pictures - means
    figures = integral.sheet_figures(of_print.sheet, of_print.film, of_print.aperture)["figures"]
    moire = figures["moire_pitch_mm"] or np.inf
    row = {"pixels": pixels, "pitch_mm": pitch, "moire_mm": moire if moire < 1e4 else np.inf,
           **figures_of(deviations, max(1, round(given.area / pitch)))}
    middle = ROWS // 2
    return row, (pictures[:, middle], np.clip(0.5 + GAIN * deviations[:, middle], 0, 1))


def write(folder, rows, pictures, given):
    with open(folder / "moire.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(rows[0])
        table.writerows([f"{value:.6g}" for value in row.values()] for row in rows)
    x = [row["pixels"] for row in rows]
    curves = {label: (x, [factor * row[name] for row in rows])
              for name, label, factor in (("flicker", "flicker x 10", 10), ("jumps", "jumps", 1),
                                          ("stripes", f"stripes ({given.area:g} mm)", 1))}
    integral.plot(folder / "moire.png", curves, "pixels in a lens pitch, as the eye sees it", "",
                  "Flicker and its unevenness against lens pitch",
                  f"{given.dpi:g} dpi, an eye that moves sideways, pupil {given.pupil:g} mm",
                  y_range=(0, None))
    width = min(left.shape[1] for left, _ in pictures)
    sides = [np.concatenate([np.pad(halves[side][:, :width].repeat(3, axis=0), ((0, 6), (0, 3), (0, 0)),
                                    constant_values=1) for halves in pictures]) for side in (0, 1)]
    shown = np.round(255 * np.hstack(sides)).astype(np.uint8).repeat(4, axis=1)
    integral.Frame(shown, encoding="srgb").write(folder / "eyes.png")


def options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0], allow_abbrev=False)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--scene", help="a scene with a perspective camera (default: a wall)")
    parser.add_argument("--dpi", type=float, default=600, help="the printer's (default: 600)")
    parser.add_argument("--pixels", type=numbers, metavar="N,N...",
                        default=[14 + k / 16 for k in range(17)],
                        help="pixels in a lens pitch, as the eye sees it (default: 14 to 15 in sixteenths)")
    parser.add_argument("--eyes", type=int, default=32, metavar="N", help="places of the eye (default: 32)")
    parser.add_argument("--pupil", type=float, default=4, metavar="MM", help="(default: 4)")
    parser.add_argument("--area", type=float, default=5, metavar="MM",
                        help="width of the areas for the stripes (default: 5)")
    parser.add_argument("--renderer", default="povray-integral", metavar="PROGRAM")
    return parser.parse_known_args()


def main():
    given, words = options()
    rows, pictures = [], []
    with tempfile.TemporaryDirectory() as scratch:
        if not given.scene:
            given.scene = f"{scratch}/wall.pov"
            pathlib.Path(given.scene).write_text(SCENE)
        try:
            distance = render(given, words, 1, SIZE_MM[0] / 160, f"{scratch}/look.png") \
                .aperture.distance_mm
            for pixels in given.pixels:
                row, picture = experiment(given, words, distance, pixels, scratch)
                print(", ".join(f"{name} {value:.4g}" for name, value in row.items()), flush=True)
                rows.append(row)
                pictures.append(picture)
            given.folder.mkdir(parents=True, exist_ok=True)
            write(given.folder, rows, pictures, given)
        except (ValueError, OSError) as error:
            raise SystemExit(f"moire.py: {error}") from error


if __name__ == "__main__":
    main()
