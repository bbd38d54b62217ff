# SPDX-License-Identifier: AGPL-3.0-or-later
"""Quilts with their depths, and plots."""
import glob
import os

import numpy as np

import integral
from cases import near, raises, run, same


def test_a_quilt_of_another_program_is_read_by_its_name():
    numbers = np.arange(12, dtype=np.uint8).reshape(3, 4, 1, 1, 1)     # of 4 x 3 views, the lowest first
    views = np.broadcast_to(20 * numbers, (3, 4, 5, 6, 3))
    picture = views[::-1].transpose(0, 2, 1, 3, 4).reshape(15, 24, 3)
    spare = np.pad(picture, ((2, 0), (0, 3), (0, 0)), constant_values=255)  # above and at the right
    integral.Frame(spare, encoding="srgb").write("other_qs4x3a1.5.png")
    quilt = integral.read_quilt("other_qs4x3a1.5.png")
    same(quilt.views, np.ascontiguousarray(views))
    assert quilt.aspect == 1.5 and quilt.metadata is None and quilt.eyes_mm is None
    assert repr(quilt) == "<integral.Quilt: 4 x 3 views of 6 x 5 pixels>"
    assert quilt.write("written.png") == "written_qs4x3a1.5.png"
    same(integral.read("written_qs4x3a1.5.png").image, np.ascontiguousarray(picture))
    integral.Frame(picture, encoding="srgb").write("nameless.png")
    same(integral.read_quilt("nameless.png", grid=(4, 3)).views, quilt.views)
    raises(ValueError, "does not end in _qsCxRaASPECT", integral.read_quilt, "nameless.png")
    raises(ValueError, "its name states another number of views", quilt.write, "no_qs2x6a1.png")
    raises(ValueError, "[row, column, y, x, channel]", integral.Quilt, picture)


def test_files_of_views_are_a_quilt():
    views = np.random.default_rng(3).integers(0, 256, (2, 2, 4, 7, 3), dtype=np.uint8)
    names = [f"one{number}.tiff" for number in range(4)]
    for name, view in zip(names, views.reshape(4, 4, 7, 3)):
        integral.Frame(view, encoding="srgb").write(name)
    same(integral.read_quilt(names, grid=(2, 2)).views, views)
    raises(ValueError, "4 files are not the 3x1 views", integral.read_quilt, names, grid=(3, 1))


def test_a_quilt_keeps_its_geometry():
    for name, shape in (("eyes", (2, 3, 45, 60, 3)), ("parallel", (1, 15, 90, 9, 3))):
        quilt = integral.read_quilt(glob.glob(name + "_qs*")[0])
        assert quilt.views.shape[:2] == shape[:2], quilt.views.shape
        path = quilt.write(f"{name}-again.png")
        again = integral.read_quilt(path)
        same(again.views, quilt.views)
        assert again.metadata == quilt.metadata and again.metadata["quilt"]
    eyes = integral.read_quilt(glob.glob("eyes_qs*")[0])
    zone = eyes.metadata["quilt"]["eyes"]
    near(eyes.eyes_mm[0, :, 0], np.array([-1, 0, 1]) * zone["width_mm"] / 3, 1e-9)
    near(eyes.eyes_mm[:, 0, 1], np.array([-0.25, 0.25]) * zone["height_mm"], 1e-9)


def test_views_have_the_scene_s_depths():
    # The front of the box is 6 units from the camera: a plane parallel to the sheet.
    quilt = integral.read_quilt(glob.glob("box_qs*")[0], "box.exr")
    assert quilt.depth_mm.shape == quilt.views.shape[:-1] == (2, 3, 48, 60)
    camera, zone = quilt.metadata["camera"], quilt.metadata["quilt"]["eyes"]
    depth = 6 / camera["units_per_mm"] - zone["distance_mm"]
    pixel = 3 * quilt.metadata["film"]["pixel_pitch_mm"][0]  # a view of 3 shows the whole sheet
    front = np.abs(quilt.depth_mm - depth) < 1e-3
    assert front.mean(axis=(2, 3)).min() > 0.04
    # A point at this depth moves across the sheet by depth / (distance + depth) of the eye's way.
    columns = np.array([[np.argwhere(view)[:, 1].mean() for view in row] for row in front])
    way = columns * pixel - quilt.eyes_mm[..., 0] * depth / (zone["distance_mm"] + depth)
    assert np.ptp(way) < pixel / 2 < np.ptp(columns * pixel), way
    raises(ValueError, "not those of this quilt", integral.read_quilt, glob.glob("eyes_qs*")[0], "squares.exr")


def test_a_quilt_with_geometry_is_measured_in_mm():
    quilt = integral.read_quilt(glob.glob("eyes_qs*")[0])
    depth = integral.depth(integral.read_quilt(glob.glob("eyes5_qs*")[0]))
    near(np.nanmedian(depth.depth_mm), 20, 4)
    near(depth.pixel_mm * depth.depth_mm.shape[1], 12, 0.3)
    raises(ValueError, "eyes are for quilts", integral.depth, integral.read("squares.png"), eyes=(1, 1, 1, 1))
    raises(ValueError, "eyes 0: a number from", integral.depth, quilt, eyes=(0, 1, 1, 1))
    raises(ValueError, "the quilt has parallel views", integral.depth,
           integral.read_quilt(glob.glob("parallel_qs*")[0]))


def test_depths_come_back():
    depths = integral.read_depths("squares.exr")
    changed = depths.depth_mm + 3
    changed[0, :5] = np.nan
    integral.write_depths("changed.exr", changed, depths.metadata)
    again = integral.read_depths("changed.exr")
    assert np.array_equal(again.depth_mm, changed, equal_nan=True)
    assert again.metadata == depths.metadata
    raises(ValueError, "an array of shape (90, 120) is expected", integral.write_depths, "no.exr",
           changed[1:], depths.metadata)
    assert not os.path.exists("no.exr")


def test_a_plot_shows_its_points():
    def blue(x):
        integral.plot("plot.png", {"a": ([0, x], [0, 1]), "b": ([0, 4], [2, 2], "dashed")}, "time (s)",
                      "error", log_y=False, x_range=(0, 4), y_range=(0, 2))
        image = integral.read("plot.png").image.astype(int)
        assert image.shape[:2] == (600, 900)
        rows, columns = np.nonzero((image[..., 2] - image[..., 0] > 120) & (np.arange(600)[:, None] > 100))
        return columns.max()

    # The last point of the blue curve moves with its place on an axis of 4.
    one, two, four = blue(1), blue(2), blue(4)
    near((two - one) / (four - two), 0.5, 0.05)
    raises(ValueError, "style wavy: line, points, both or dashed", integral.plot, "no.png", {"a": ([1], [1], "wavy")})
    raises(ValueError, "", integral.plot, "no.bmp", {"a": ([1], [1])})


if __name__ == "__main__":
    run(globals())
