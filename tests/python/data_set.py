# SPDX-License-Identifier: AGPL-3.0-or-later
"""The folder `set` that examples/python/data_set.py made of set.pov: 5 x 3 views of 60 x 48 pixels of
a box whose front is 6 units from the camera, before a wall at 10 units and the sky."""
import configparser
import json
import os
import subprocess
import sys

import numpy as np

import integral
from cases import near, run, same

WIDE, HIGH = 5, 3
sys.path.insert(0, os.path.join(os.environ["TOP"], "examples/python"))
import data_set  # noqa: E402
import masks  # noqa: E402


def pfm(name):
    with open(f"set/{name}.pfm", "rb") as file:
        assert file.readline() == b"Pf\n"
        width, height = map(int, file.readline().split())
        assert float(file.readline()) == -1
        return np.frombuffer(file.read(), "<f4").reshape(height, width)[::-1]


def picture(number):
    return integral.read(f"set/input_Cam{number:03}.png").image.astype(float)


def parameters():
    parser = configparser.ConfigParser()
    parser.read("set/parameters.cfg")
    return {name: value for section in parser.sections() for name, value in parser[section].items()}


def test_a_folder_has_every_file_of_the_layout():
    kinds = [("input_Cam", ".png"), ("gt_disp_lowres_Cam", ".pfm"), ("gt_depth_lowres_Cam", ".pfm")]
    expected = {f"{kind}{number:03}{end}" for kind, end in kinds for number in range(WIDE * HIGH)}
    resolutions = ("lowres", "highres")
    expected |= {f"gt_{what}_{res}.pfm" for what in ("disp", "depth") for res in resolutions}
    # The scene has no curved and no thin surface.
    expected |= {f"mask_{what}_{res}.png" for what in ("discontinuities", "planes") for res in resolutions}
    expected |= {"parameters.cfg"}
    assert set(os.listdir("set")) == expected


def test_the_middle_view_is_the_scene_s_own_picture():
    own = integral.read("perspective.png").image.astype(float)
    assert np.abs(picture(7) - own).max() <= 1
    assert np.abs(picture(6) - own).max() > 50


def test_depths_are_those_of_the_scene_from_the_camera_s_plane():
    depth = pfm("gt_depth_lowres")
    for value, share in ((6, 0.05), (10, 0.3), (np.inf, 0.2)):
        assert (np.abs(depth - value) < 1e-4 if np.isfinite(value) else depth == value).mean() > share
    assert ((np.abs(depth - 10) < 1e-4) | (depth < 8) | np.isinf(depth)).all()
    assert np.array_equal(depth, pfm("gt_depth_lowres_Cam007"))


def expected_depths(width, height):
    """Depths of set.pov along the lines of sight of its camera, by the box's six planes."""
    x, y = np.meshgrid(1.25 * ((np.arange(width) + 0.5) / width - 0.5), 0.5 - (np.arange(height) + 0.5) / height)
    direction, eye = np.stack([x, y, np.ones_like(x)], axis=-1), np.array([1, 2, -4])
    ends = [(np.array(corner) - eye) / direction for corner in ((-1, 0.6, 2), (2.2, 2.4, 3))]
    enters, leaves = np.minimum(*ends).max(axis=-1), np.maximum(*ends).min(axis=-1)
    wall = np.where(eye[1] + 10 * y < 3, 10, np.inf)
    return np.where((enters < leaves) & (enters > 0), enters, wall)


def test_fine_depths_are_those_of_the_scene():
    for name, width, height in (("lowres", 60, 48), ("highres", 240, 192)):
        depth, expected = pfm("gt_depth_" + name), expected_depths(width, height)
        good = (depth == expected) | (np.abs(depth - np.where(np.isinf(expected), 0, expected)) < 1e-4)
        assert depth.shape == expected.shape and good.mean() > 0.999, good.mean()
    assert float(parameters()["depth_map_scale"]) == 4


def grey_png(name):
    with open(f"set/{name}.png", "rb") as file:
        assert file.read(26)[24:] == b"\x08\x00"     # 8 bits, grey: a picture of one channel
    return integral.read(f"set/{name}.png").image[..., 0]


def windows(mask, reach):
    """Whether any value within `reach` is true, by comparing with every one of them."""
    padded = np.pad(mask, reach)
    return np.lib.stride_tricks.sliding_window_view(padded, (2 * reach + 1,) * 2).any(axis=(2, 3))


def test_masks_are_the_regions_of_the_truth():
    fine = expected_depths(240, 192)
    disparity = (1 / np.where(np.isinf(fine), 1e9, fine)) * 14.4 - 1.2   # 1.2 at 6, 0.24 at 10 units
    step = np.zeros(fine.shape, bool)
    for down, right in ((0, 1), (0, -1), (1, 0), (-1, 0)):
        moved = np.roll(disparity, (down, right), axis=(0, 1))
        moved[[0, -1]], moved[:, [0, -1]] = disparity[[0, -1]], disparity[:, [0, -1]]
        step[1:-1, 1:-1] |= np.abs(moved - disparity)[1:-1, 1:-1] > 0.1
    edges = grey_png("mask_discontinuities_highres") > 0
    near_edge = windows(step, 12)
    assert (edges == near_edge).mean() > 0.995, (edges == near_edge).mean()
    low = near_edge.reshape(48, 4, 60, 4).any(axis=(1, 3))
    assert ((grey_png("mask_discontinuities_lowres") > 0) == low).mean() > 0.99
    planes = grey_png("mask_planes_highres")
    assert set(np.unique(planes)) == {0, 255}
    flat = np.isfinite(fine) & ~near_edge & ((fine == 10) | (fine == 6))
    assert (planes[flat] > 0).mean() > 0.97 and (planes[near_edge] > 0).mean() < 0.005


def test_masks_of_shapes():
    # A ball, a rod 3 pixels wide and a slanted plane, as disparities.
    y, x = np.mgrid[:80, :120].astype(float)
    plane = 0.002 * x - 0.001 * y
    ball = 30**2 - (x - 40)**2 - (y - 40)**2
    disparity = np.where(ball > 0, 1 + 0.02 * np.sqrt(np.maximum(ball, 0)), plane)
    rod = (x >= 90) & (x < 93)
    disparity = np.where(rod, 0.5, disparity).astype(np.float32)
    found = masks.masks(disparity, x < 115)
    inside, outside = ball > 400, (ball < -1000) & (np.abs(x - 91) > 12)
    assert found["smooth_surfaces"][inside].all() and not found["smooth_surfaces"][outside].any()
    assert found["planes"][outside & (x < 114)].all() and not found["planes"][inside | (x >= 115)].any()
    same(found["fine"][:, 80:100], rod[:, 80:100])
    same(found["fine_surrounding"][:, 80:105], (windows(rod, 5) & ~rod)[:, 80:105])
    assert not found["fine"][inside].any()


def test_disparities_follow_from_depths_by_the_toolkit_s_formula():
    p = parameters()
    scale = (float(p["baseline_mm"]) / 1000 * float(p["focal_length_mm"]) *
             max(int(p["image_resolution_x_px"]), int(p["image_resolution_y_px"])) /
             float(p["sensor_size_mm"]))
    for number in range(WIDE * HIGH):
        depth, disparity = (pfm(f"gt_{what}_lowres_Cam{number:03}") for what in ("depth", "disp"))
        near(disparity, scale / depth - scale / float(p["focus_distance_m"]), 1e-5)
    surfaces = pfm("gt_disp_lowres")[np.isfinite(pfm("gt_depth_lowres"))]
    near((surfaces.min(), surfaces.max()), (0.24, 1.2), 1e-3)


def test_the_camera_s_angle_and_place_are_stated():
    p = {name: float(value) for name, value in parameters().items()
         if name.startswith(("center", "focal", "sensor"))}
    near(p["sensor_size_mm"] / p["focal_length_mm"], 1.25, 1e-9)   # right / direction
    near([p[f"center_cam_{axis}_m"] for axis in "xyz"], (1, 2, 4), 1e-9)
    near([p[f"center_cam_r{axis}_rad"] for axis in "xyz"], (0, 0, 0), 1e-9)


def test_angles_of_a_turned_camera_give_its_axes():
    angle = 0.3
    c, s = np.cos(angle), np.sin(angle)
    # POV-Ray's camera turned to its right about y, and looking down.
    for axes, expected in ((((c, 0, -s), (0, 1, 0), (s, 0, c)), (0, -angle, 0)),
                           (((1, 0, 0), (0, c, s), (0, -s, c)), (-angle, 0, 0))):
        near(data_set.rotation(axes), expected, 1e-12)


def test_a_point_moves_by_its_disparity_to_the_left_and_downwards():
    box = {n: np.argwhere(np.abs(pfm(f"gt_depth_lowres_Cam{n:03}") - 6) < 1e-4).mean(axis=0)
           for n in range(WIDE * HIGH)}
    middle = WIDE * HIGH // 2
    for number, (y, x) in box.items():
        row, column = divmod(number, WIDE)
        near((y - box[middle][0], x - box[middle][1]), (-1.2 * (row - 1), -1.2 * (column - 2)), 0.5)


def test_python_measures_the_command_s_map():
    views = np.array([integral.read(f"set/input_Cam{number:03}.png").image for number in range(WIDE * HIGH)])
    quilt = integral.Quilt(views.reshape(HIGH, WIDE, 48, 60, 3)[::-1])
    names = [f"set/input_Cam{number:03}.png" for number in range(WIDE * HIGH)]
    for eyes, words in ((None, []), ((2, 3, 400, 100), ["--eyes", "2,3,400,100"])):
        subprocess.run([os.environ["INTEGRAL"], "depth", *names, "--views", f"{WIDE}x{HIGH}", "--top-first",
                        "-o", "set/map.pfm", *words], capture_output=True, check=True)
        found, expected = integral.depth(quilt, eyes=eyes), pfm("map")
        os.remove("set/map.pfm")
        assert (found.depth_mm is None) == (eyes is None)
        assert np.array_equal(found.disparity if eyes is None else found.depth_mm, expected, equal_nan=True)
        if eyes is None:
            surfaces = np.isfinite(pfm("gt_depth_lowres"))
            error = np.abs(found.disparity - pfm("gt_disp_lowres"))[surfaces]
            assert (error < 0.07).mean() > 0.85, (error < 0.07).mean()


def test_an_array_file_has_the_same_values():
    import h5py
    with h5py.File("set.h5") as file:
        assert file["LF"].shape == (HIGH, WIDE, 48, 60, 3) and file.attrs["num_cams_x"] == WIDE
        same(file["LF"][2, 1], integral.read("set/input_Cam011.png").image)
        same(file["disparity"][2, 1], pfm("gt_disp_lowres_Cam011").astype(np.float32))
        same(file["depth_m"][0, 4], pfm("gt_depth_lowres_Cam004").astype(np.float32))
        for name in ("disp_lowres", "depth_lowres", "disp_highres", "depth_highres"):
            same(file[name][:], pfm("gt_" + name).astype(np.float32))


def test_integral_depth_finds_the_truth():
    views = [f"set/input_Cam{number:03}.png" for number in range(WIDE * HIGH)]
    said = subprocess.run([os.environ["INTEGRAL"], "depth", *views, "--views", f"{WIDE}x{HIGH}",
                           "--top-first", "--truth", "set/gt_disp_lowres.pfm", "--border", "8",
                           "--json"], capture_output=True, text=True, check=True).stdout
    textured = json.loads(said)["scores"]["texture"]
    assert textured["pixels"] > 300 and textured["bad_0.07"] < 1, textured


if __name__ == "__main__":
    run(globals())
