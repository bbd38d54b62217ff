# SPDX-License-Identifier: AGPL-3.0-or-later
"""Replays, views, figures and depth: the same as the commands' files."""
import glob
import json
import math

import numpy as np

import integral
from cases import WALL, near, raises, run, same, warns


def test_replay_is_that_of_the_command():
    frame = integral.read("whole.png")
    picture = integral.replay(frame, eye=(20, -3, 250), size=(120, 72))
    same(picture, integral.read("eye.png").image)
    same(integral.replay(frame, (20, -3, 250), (120, 72), threads=1), picture)
    squares = integral.read("squares.png")
    for fit, is_bar in (("contain", True), ("cover", False), ("stretch", False)):
        top = integral.replay(squares, size=(90, 90), fit=fit)[:11]
        assert (top[..., :2] == 0).all() == is_bar, fit
    raises(ValueError, "fit crop: contain, cover or stretch", integral.replay, squares, fit="crop")
    same(integral.replay(squares, size=(90, 60), as_seen=True),
         integral.read("seen.png").image)


def test_replay_refuses_in_words():
    frame = integral.read("whole.png")
    raises(ValueError, "distance must be greater than 0", integral.replay, frame, (0, 0, -1))
    raises(ValueError, "not in front of the eye", integral.replay, frame, (0, 0, 100), focus=-200)
    raises(ValueError, "lens_model hybrid", integral.replay, frame, lens_model="hybrid")
    raises(TypeError, "", integral.replay, frame, eye="left")


def test_numbers_out_of_range_are_refused_before_the_work():
    frame, nan = integral.read("whole.png"), math.nan
    parts, huge = (frame.sheet, frame.film, frame.aperture), 2_000_000_000
    for sentence, call, words in (
            ("eye nan: a number from -1000000000 to 1000000000 is expected", integral.replay, {"eye": (nan, 0, 300)}),
            ("part -1: ", integral.replay, {"part": (0, 0, -1, nan)}),
            ("part nan: ", integral.replay, {"part": (0, 0, 1, nan)}),
            ("size 2000000000: a number from 1 to 32768", integral.replay, {"size": (huge, huge)}),
            ("focus nan: ", integral.replay, {"focus": nan}),
            ("film_gap nan: ", integral.replay, {"film_gap": nan}),
            ("samples 65: a number from 1 to 64", integral.replay, {"samples": 65}),
            ("threads -3: a number from 0 to 1024", integral.replay, {"threads": -3}),
            ("size 2000000000: ", integral.views, {"eyes": True, "size": (huge, huge)}),
            ("number of directions 257: a number from 1 to 256", integral.views, {"grid": (1, 257)}),
            ("grid 0: ", integral.interlace, {"panel": "thesis-lcd", "grid": (0, 1)}),
            ("width -5: a number from 0 to 32768", integral.depth, {"width": -5}),
            ("width 0: a number from 1 to 32768", integral.refocus, {"focus": 0, "pupil": 3, "width": 0}),
            ("width 40000: ", integral.refocus, {"focus": 0, "pupil": 3, "width": 40000}),
            ("pupil -5: a number from 0 to 1000000", integral.refocus, {"focus": 0, "pupil": -5})):
        error = raises(ValueError, sentence, call, frame, **words)
        assert "--" not in str(error), error
    for sentence, words in (("sheet_distance -5: ", {"sheet_distance": -5}),
                            ("parallax nan: ", {"parallax": nan}), ("parallax 0: ", {"parallax": 0}),
                            ("budgets nan: ", {"budgets": nan})):
        raises(ValueError, sentence, integral.fit, [50, 150], *parts, **words)
    for sentence, words in (("depths -5: ", {"depths": [-5, nan]}), ("depths nan: ", {"depths": [5, nan]}),
                            ("pupil -3: ", {"pupil": -3})):
        raises(ValueError, sentence, integral.sheet_figures, *parts, **words)


def test_long_work_reports_and_stops():
    frame = integral.read("squares.png")
    calls = []

    def stop(done, total):
        calls.append((done, total))
        raise KeyboardInterrupt("enough")

    raises(KeyboardInterrupt, "enough", integral.replay, frame, size=(6000, 4500), samples=16,
           progress=stop)
    assert len(calls) == 1 and 0 <= calls[0][0] <= calls[0][1]


def tiles(quilt, columns, rows):
    """The views [row, column, y, x, channel] of a quilt, the lowest row first."""
    h, w = quilt.shape[0] // rows, quilt.shape[1] // columns
    return quilt.reshape(rows, h, columns, w, 3).transpose(0, 2, 1, 3, 4)[::-1]


def test_views_are_those_of_the_command():
    frame = integral.read("whole.png")
    views = integral.views(frame)
    same(views, np.ascontiguousarray(tiles(integral.read(glob.glob("parallel*")[0]).image, 15, 1)))
    # A view is the light field's direction: from the far left, the pixel at the right.
    field = frame.lightfield()
    same(np.ascontiguousarray(field.samples[0, ::-1, :, 2]),  # the film's first lens is cut
         np.ascontiguousarray(views[0, :, :, 3]))
    eyes = integral.views(integral.read("squares.png"), (3, 2), eyes=True, size=(60, 45))
    same(eyes, np.ascontiguousarray(tiles(integral.read(glob.glob("eyes*")[0]).image, 3, 2)))


def test_a_frame_comes_back_from_its_views():
    frame = integral.read("whole.png")
    again = integral.frame_from_views(integral.views(frame), frame.sheet, frame.film, frame.aperture)
    same(again.image, frame.image)
    same(again.image, integral.read("back.png").image)
    assert again.sheet == frame.sheet
    squares = integral.read("squares.png")
    eyes = integral.views(squares, (10, 10), eyes=True, size=(120, 90))
    of_eyes = integral.frame_from_views(eyes, squares.sheet, squares.film, squares.aperture, eyes=True)
    assert integral.compare(of_eyes, squares)["psnr"] > 60
    raises(ValueError, "an array [row, column, y, x, channel]", integral.frame_from_views, eyes[0],
           squares.sheet, squares.film, squares.aperture)
    raises(ValueError, "give the frame's pixels", integral.frame_from_views, eyes, squares.sheet,
           integral.Film.of_dpi(254), squares.aperture)


def test_figures_are_those_of_the_commands():
    a, b = integral.read("whole.png"), integral.read("nearer.png")
    with open("compared.json") as file:
        expected = json.load(file)
    assert expected.pop("passed") and integral.compare(a, b) == expected
    stored = [f.image.astype(float) / 65535 for f in (a, b)]
    near(integral.compare(a, b)["rmse"], math.sqrt(((stored[0] - stored[1]) ** 2).mean()), 1e-8)
    near(integral.difference(a, b) / 65535, np.abs(stored[0] - stored[1]), 2e-5)
    assert integral.compare(a, a)["psnr"] is None
    raises(ValueError, "pixels", integral.compare, a, integral.read("round.png"))
    with open("figures.json") as file:
        expected = json.load(file)
    figures = integral.sheet_figures(a.sheet, a.film, a.aperture)
    assert figures["figures"] == expected["figures"]


def test_depth_is_the_walls_and_the_commands():
    frame = integral.read("whole.png")
    depth = integral.depth(frame)
    known = np.isfinite(depth.depth_mm)
    assert depth.depth_mm.shape == depth.confidence.shape == depth.colour.shape[:2]
    with open("depth.pfm", "rb") as file:
        assert file.readline() == b"Pf\n"
        width, height = map(int, file.readline().split())
        assert float(file.readline()) < 0
        stored = np.frombuffer(file.read(), "<f4").reshape(height, width)[::-1]
    assert np.array_equal(depth.depth_mm, stored, equal_nan=True)
    assert known.any() and abs(np.median(depth.depth_mm[known]) - WALL) < 4
    raises(ValueError, "quality perfect: draft, good or best", integral.depth, frame, "perfect")
    same(integral.refocus(frame, 20, 30, width=200), integral.read("focus.png").image)


def test_a_fit_puts_the_ends_on_the_budget():
    # Section 8 of doc/optics.md, once more: near and far are seen a budget from the sheet.
    sheet = integral.LensSheet("lenticular", 0.635, 1.7, 1.56)
    film, aperture = integral.Film.of_dpi(720), integral.Aperture(400)
    budget = integral.sheet_figures(sheet, film, aperture)["figures"]["depth_budget_mm"]
    distances = np.linspace(50, 150, 2001)
    found = integral.fit(distances, sheet, film, aperture, budgets=2)
    near_end, far_end = np.percentile(distances, (5, 95))
    beta, ratio = 2 * budget / 400, far_end / near_end
    c = (ratio * (1 - beta) - (1 + beta)) / (beta * ((1 + beta) + ratio * (1 - beta)))
    near(found.parallax, 1 / (1 + c), 1e-3)
    k = found.parallax
    near(found.sheet_distance, near_end * (k + beta * (1 - k)) / (k * (1 - beta)), 0.1)
    near(found.share, 0.9, 0.01)
    fixed = integral.fit(distances, sheet, film, aperture, sheet_distance=100)
    assert fixed.sheet_distance == 100 and fixed.parallax <= 1
    raises(ValueError, "distances must be greater than 0", integral.fit, [1, -1], sheet, film, aperture)
    raises(ValueError, "no distance is finite", integral.fit, [math.inf], sheet, film, aperture)


def test_a_panel_gets_the_commands_image():
    frame = integral.read("squares.png")
    image = warns("it has black bars above and below", integral.interlace, frame,
                  "looking-glass-go", (9, 1))
    same(image.image, integral.read("panel.png").image)
    assert "looking-glass-go" in integral.panel_names()
    assert integral.panel("looking-glass-go")["panel"]["width"] == image.image.shape[1]
    raises(ValueError, "no panel has this name", integral.panel, "no-such-panel")
    views = np.zeros((1, 4, 60, 80, 3), np.uint8)
    views[0, :, :, :, 0] = np.arange(4)[:, None, None] * 60 + 20
    red = integral.interlace(views, "thesis-lcd").image
    assert set(np.unique(red[..., 1:])) == {0} and len(np.unique(red[..., 0])) > 4


def test_known_sheets_have_names():
    sheets = integral.known_sheets()
    assert len(sheets) > 5 and all(isinstance(s, integral.LensSheet) for s in sheets.values())


run(globals())
