# SPDX-License-Identifier: AGPL-3.0-or-later
"""examples/python: epipolar images, manipulations and the moire of a wall 20 mm behind the sheet."""
import argparse
import math
import os
import subprocess
import sys

import numpy as np

import integral
from cases import WALL, near, raises, run

sys.path.insert(0, os.path.join(os.environ["TOP"], "examples/python"))
import edges  # noqa: E402
import epipolar  # noqa: E402
import error_time  # noqa: E402
import manipulate  # noqa: E402
import moire  # noqa: E402


def test_lines_of_an_epipolar_image_lean_with_depth():
    frame = integral.read("squares.png")
    field = manipulate.like(frame, frame.linear()).lightfield()
    lines = epipolar.epipolar(field, 4)[..., 0]
    # The wall's red grows by 1 in 200 mm, at the place where the ray meets it.
    slope = -np.diff(lines, axis=0) / np.diff(field.u_mm)[:, None] * frame.aperture.distance_mm
    near(slope * 200, np.full(slope.shape, WALL), 1)
    drawn = epipolar.drawn(frame.lightfield(), 4)
    assert drawn.dtype == np.uint16 and 900 < drawn.shape[1] < 1100


def test_a_balanced_patch_is_grey_and_as_bright_as_before():
    frame = integral.read("squares.png")
    raises(SystemExit, "no light in one of the colours", manipulate.balance, frame, 10, 20, 30, 25)
    raises(SystemExit, "not inside the frame of 120 x 90", manipulate.balance, frame, 100, 20, 30, 25)
    linear = frame.linear() + np.float32([0, 0, 0.1])        # the wall has no blue
    balanced = manipulate.balance(manipulate.like(frame, linear), 10, 20, 30, 25).linear()
    before = linear[20:45, 10:40].mean(axis=(0, 1))
    near(balanced[20:45, 10:40].mean(axis=(0, 1)), np.full(3, before.mean()), 2e-5)
    near(balanced[60, 100] / linear[60, 100], before.mean() / before, 1e-5)


def test_a_wall_to_which_the_plane_moves_looks_alike_from_everywhere():
    frame = integral.read("squares.png")
    field = manipulate.like(frame, frame.linear()).lightfield()
    moved = manipulate.plane(frame, WALL).lightfield().samples
    # Directions whose rays meet the wall at most 3 lenses beside their own: the others reach the border.
    u, v = (np.abs(mm) * WALL / frame.aperture.distance_mm < 3 for mm in (field.u_mm, field.v_mm))
    before, after = (np.ptp(samples[v][:, u, 3:-3, 3:-3, :2], axis=(0, 1))
                     for samples in (field.samples, moved))
    assert before.min() > 0.01 and after.max() < 1e-3, (before.min(), after.max())
    raises(SystemExit, "do not cover whole pixels", manipulate.plane, integral.read("broken.png"), 1)


def test_a_part_is_pasted_at_its_depth_behind_what_is_nearer():
    frame = integral.read("squares.png")
    depths = np.full(frame.image.shape[:2], WALL)
    lens = round(1 / frame.film.pixel_pitch_mm[0])
    depths[2 * lens:4 * lens, 3 * lens:5 * lens] = 5           # two lenses by two show something near
    depths[5 * lens:6 * lens, 6 * lens:7 * lens] = -1          # and one something nearer still
    pasted = manipulate.paste(frame, depths, 0, 10, 3, 3).linear()
    expected = frame.linear()
    expected[5 * lens:7 * lens, 6 * lens:8 * lens] = expected[2 * lens:4 * lens, 3 * lens:5 * lens]
    expected[5 * lens:6 * lens, 6 * lens:7 * lens] = frame.linear()[5 * lens:6 * lens, 6 * lens:7 * lens]
    near(pasted, expected, 1e-6)
    raises(SystemExit, "the nearer depth comes first", manipulate.paste, frame, depths, 9, 1, 1, 1)
    raises(SystemExit, "the frame has 11 x 9 lenses", manipulate.paste, frame, depths, 0, 1, 12, 0)
    raises(SystemExit, "of another frame", manipulate.paste, frame, depths[1:], 0, 1, 1, 0)
    back = manipulate.paste(frame, depths, 0, 10, -3, -2).linear()
    assert np.abs(back - frame.linear())[:2 * lens, :2 * lens].max() > 1e-3


def test_colours_of_another_frame_are_matched():
    rng = np.random.default_rng(5)
    frame = integral.read("squares.png")
    colours = rng.uniform(0.05, 0.6, (90, 120, 3)).astype(np.float32)
    matrix = np.float32([[0.9, 0.1, 0], [0.05, 0.7, 0.1], [-0.02, 0.2, 0.8]])
    matched = manipulate.match(manipulate.like(frame, colours), manipulate.like(frame, colours @ matrix))
    near(matched.linear(), colours @ matrix, 1e-5)
    raises(SystemExit, "too few colours", manipulate.match, frame, frame)     # the wall has no blue
    raises(SystemExit, "120 x 90 and 120 x 89 pixels", manipulate.match, frame,
           integral.Frame(colours[1:], encoding="linear"))


def test_parallax_is_multiplied():
    # A lens at s sees, in the direction u, the wall's place s - u WALL / distance.
    frame = integral.read("squares.png")
    field = manipulate.like(frame, frame.linear()).lightfield()
    u = field.u_mm[None, :, None, None]
    for factor in (0, 0.5, 1.3):
        made = manipulate.parallax(frame, factor).lightfield().samples[..., 0]
        place = field.s_mm - factor * u * WALL / frame.aperture.distance_mm
        inside = np.abs(field.u_mm) * factor < np.abs(field.u_mm).max()
        error = np.abs(made - (place + 100) / 200)[:, inside][..., 3:-3]
        assert error.max() < 2e-3 < np.ptp(place[:, inside]) / 200 + (factor == 0), error.max()


def test_an_object_is_cut_out_and_put_into_another_frame():
    # The rod moved by three lenses looks through every lens as it did through the third one beside it.
    frame, depths = integral.read("rod0.png"), integral.read_depths("rod0.exr")
    made, depth = manipulate.cut(frame, depths.depth_mm, -20, 0, 3, 0)
    assert made.image.shape == (60, 300, 4)
    made.write("rod-cut.png")
    integral.write_depths("rod-cut.exr", depth, depths.metadata)
    subprocess.run([os.environ["INTEGRAL"], "combine", "empty.png", "rod-cut.png", "-o", "rod-joined.png",
                    "--depth", "empty.exr,rod-cut.exr"], check=True)
    joined, moved, still = (integral.read(name).image.astype(float) / 65535
                            for name in ("rod-joined.png", "rod3.png", "rod0.png"))
    differs = np.abs(joined - moved).max(axis=2) > 0.01
    assert differs.mean() < 0.005 < 0.1 < (np.abs(still - moved).max(axis=2) > 0.01).mean(), differs.mean()


def test_edges_are_lines_of_epipolar_images():
    # Stripes on a wall 20 mm behind the sheet, and a dark rod 8 mm in front of it.
    rows, view, _ = edges.edges_of(integral.read("rod0.png"))
    _, place, depth, strength, coherence = np.transpose(rows)
    assert view.shape == (3, 15) and (coherence > 0.5).all() and (strength > 0.05).all()
    for x, z in ((-3, -8), (2, -8)):
        near(sorted(np.abs(place - x))[:3], 0, 0.3)
        near(depth[np.abs(place - x) < 0.3], z, 1.5)
    rows, _, _ = edges.edges_of(integral.read("empty.png"))
    _, place, depth, _, _ = np.transpose(rows)
    for x in (-4, 0, 4):
        near(sorted(np.abs(place - x))[:3], 0, 0.3)
    near(depth, WALL, 2.5)


def test_slopes_and_targets_of_tables():
    with open("table.csv", "w") as file:
        file.write("setting,error,seconds,processor_seconds\none ray a pixel,0.5,0.9,1\n")
        for name, factor in (("+A0.3 +AM2", 0.1), ("pixel_samples 2 beam_samples 2", 0.2)):
            file.writelines(f"{name},{factor / math.sqrt(time)},{time},{2 * time}\n" for time in (16, 1, 4))
    lines = error_time.read_table("table.csv", "seconds")
    near(error_time.slope(lines["+A"]), -0.5, 1e-9)
    near(error_time.seconds_for(lines["+A"], 0.04), 6.25, 1e-9)
    near(error_time.seconds_for(error_time.read_table("table.csv", "processor_seconds")["+A"], 0.04), 12.5, 1e-9)
    assert error_time.seconds_for(lines["+A"], 0.02) is None
    near(error_time.seconds_for(lines["+A"], 0.2), 1, 0)


def test_the_pixels_steps_are_a_sawtooth():
    # A wall whose red grows evenly: an eye sees a step of the pixel's spread at the wall, and deviates
    # from the mean by a sawtooth, whose square varies by its mean times sqrt(4/5). Lenses half a pixel
    # apart leave only its even harmonics, a quarter.
    pixel, distance, pixels = 25.4 / 200, 300, 8
    moire.FINE, moire.SIZE_MM, moire.ROWS = 16, (80, 4), 4
    given = argparse.Namespace(renderer=os.environ["POVRAY"], scene="evenly.pov")
    for extra, jumps in ((0, math.sqrt(0.8)), (0.5, math.sqrt(0.8) / 4)):
        pitch = (pixels + extra) * pixel / (1 + moire.THICKNESS_MM / (moire.IOR * distance))
        frame = moire.render(given, [], pitch, pixel / moire.FINE, "pixels.png")
        near(frame.aperture.distance_mm, distance, 0.1)
        of_print, of_mean = moire.printed(frame)
        near(of_print.film.pixel_pitch_mm[0], pixel, 1e-9)
        eyes = (np.arange(64) + 0.5) / 64 * moire.JUMPS * moire.eye_step(frame, pixel)
        red = (moire.seen(of_print, eyes, 0) - moire.seen(of_mean, eyes, 0))[..., :1]
        figures = moire.figures_of(red, 8)
        spread = WALL * moire.IOR * pixel / moire.THICKNESS_MM
        near(figures["flicker"] / (spread / 200 / math.sqrt(12)), 1, 0.05)
        near(figures["jumps"], jumps, 0.04)
        near(figures["stripes"], jumps, 0.04)


if __name__ == "__main__":
    run(globals())
