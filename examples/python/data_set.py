#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Renders a scene as a light field of n x m views with the true depth and disparity of each, in the
layout of the HCI 4D Light Field Benchmark (Honauer and others 2016):

    data_set.py SCENE.pov FOLDER [--views 9x9] [--size 512x512] [--disparity 1.5]
                [--truth-scale 10] [--hdf5 FILE.h5] [RENDERER OPTION...]

FOLDER then has input_Cam000.png (the view from the upper left) to input_Cam080.png,
gt_disp_lowres.pfm and gt_depth_lowres.pfm of the middle view, the same with _CamNNN of each view,
gt_disp_highres.pfm and gt_depth_highres.pfm of the middle view with 10 x 10 values a pixel,
mask_REGION_lowres.png and mask_REGION_highres.png (masks.py), and parameters.cfg. The scene has a perspective camera; the middle view is its picture, without focal
blur, if the camera has the shape of --size. A unit of the scene counts as a metre. Other options, such
as +A0.3 or +L, are the renderer's.
"""
import argparse
import configparser
import datetime
import importlib.util
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

import integral
from masks import write_masks

WINDOW_MM = 100       # width of the sheet, which all views show; any would do
SENSOR_MM = 35        # of parameters.cfg, which states the angle of view as focal length and sensor
FARTHEST_EYES = 0.02  # greatest spacing of the eyes, as a part of the distance, for flat scenes


def pair(text):
    numbers = text.split("x")
    if len(numbers) != 2 or not all(number.isdigit() and int(number) for number in numbers):
        raise argparse.ArgumentTypeError(f"{text}: two numbers are expected, as in 9x9")
    return tuple(int(number) for number in numbers)


def odd_pair(text):
    if any(number % 2 == 0 for number in pair(text)):
        raise argparse.ArgumentTypeError(f"{text}: odd numbers are expected, so that there is a middle "
                                         "view")
    return pair(text)


def positive(text):
    if not text.isdigit() or not 0 < int(text) <= 32:
        raise argparse.ArgumentTypeError(f"{text}: a whole number from 1 to 32 is expected")
    return int(text)


def length(text):
    if not (0 < float(text) < math.inf):
        raise argparse.ArgumentTypeError(f"{text}: a number greater than 0 is expected")
    return float(text)


def fail(message):
    sys.exit(f"data_set.py: {message}")


def options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0], allow_abbrev=False)
    parser.add_argument("scene")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--views", type=odd_pair, default=(9, 9), metavar="CxR",
                        help="views across and up (default: 9x9)")
    parser.add_argument("--size", type=pair, default=(512, 512), metavar="WxH",
                        help="pixels of a view (default: 512x512)")
    parser.add_argument("--disparity", type=length, default=1.5, metavar="PIXELS",
                        help="greatest disparity, from a view to the next, of nine tenths of the "
                        "scene's depths (default: 1.5)")
    parser.add_argument("--truth-scale", type=positive, default=10, metavar="N",
                        help="true depths of the middle view with N x N values a pixel, too; 1: without "
                        "(default: 10, which the benchmark's toolkit expects)")
    parser.add_argument("--hdf5", metavar="FILE.h5", help="write the arrays to this file, too")
    parser.add_argument("--renderer", default="povray-integral", metavar="PROGRAM")
    given, words = parser.parse_known_args()
    if given.hdf5 and not importlib.util.find_spec("h5py"):
        fail("--hdf5 needs the package python3-h5py")
    if given.folder.exists() and (not given.folder.is_dir() or any(given.folder.iterdir())):
        fail(f"{given.folder} is not an empty folder; give a new one")
    return given, words


def warnings_in(text):
    """The renderer's warnings about the scene. Those about the integral camera concern prints. The
    renderer folds warnings: later lines of one begin with a blank."""
    lines, inside = [], False
    for line in text.splitlines():
        if "Warning: " in line:
            inside = "Warning: Integral camera: " not in line
        elif not line.startswith(" ") or not line.strip():
            inside = False
        if inside:
            lines.append(line)
    return "\n".join(lines)


def render(renderer, scene, camera, size, output, words):
    """Renders SCENE to OUTPUT.png and its depths to OUTPUT.exr. Returns the depths, and the warnings."""
    command = [renderer, f"+I{scene}", *words, f"+O{output}.png", f"+W{size[0]}", f"+H{size[1]}",
               "+FN8", "-D", "Integral_Draft=1", f"Integral_Camera={camera}",
               f"Integral_Depth_Image={output}.exr"]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True)
    except OSError as error:
        fail(f"{renderer}: {error.strerror}; give povray-integral's path by --renderer")
    if done.returncode:
        sys.exit("\n".join([line for line in done.stderr.splitlines() if line.strip()][-5:]))
    return integral.read_depths(f"{output}.exr"), warnings_in(done.stderr)


def placed(distances, disparity, width):
    """Where the plane without disparity stands, in scene units from the middle eye, and the spacing
    of the eyes divided by a pixel's width in that plane."""
    near, far = np.percentile(distances, [5, 95], method="lower")
    if not np.isfinite(near):
        fail("the camera sees too few surfaces for a depth")
    plane = 2 / (1 / near + 1 / far)
    step = plane / near - 1
    if step * FARTHEST_EYES * width < disparity:
        print(f"the scene is too flat for a disparity of {disparity:g}: it gets "
              f"{step * FARTHEST_EYES * width:.3g} pixels")
    return plane, min(disparity / max(step, 1e-9), FARTHEST_EYES * width)


def rotation(axes):
    """Euler angles, radians, in the order x, y, z, of a camera that looks along its own -z."""
    x, y, z = (np.array(axis) / np.linalg.norm(axis) * (1, 1, -1) for axis in axes)
    return (np.arctan2(y[2], -z[2]), -np.arcsin(np.clip(x[2], -1, 1)), np.arctan2(x[1], x[0]))


def parameters(scene, metadata, views, size, ratio, disparities, scale):
    """The text fields of parameters.cfg. The world is right-handed: POV-Ray's with z negated."""
    camera = metadata["camera"]
    unit, plane = camera["units_per_mm"], camera["sheet_distance"]
    pixel = WINDOW_MM / size[0] * unit
    axes = [camera[name] for name in "xyz"]
    eye = np.array(camera["origin"]) - np.array(axes[2]) / np.linalg.norm(axes[2]) * plane
    turn = rotation(axes)
    surfaces = disparities[np.isfinite(disparities)]
    return {
        "intrinsics": {
            "focal_length_mm": SENSOR_MM * plane / (pixel * max(size)), "fstop": 100.0,
            "image_resolution_x_px": size[0], "image_resolution_y_px": size[1],
            "sensor_size_mm": float(SENSOR_MM)},
        "extrinsics": {
            "num_cams_x": views[0], "num_cams_y": views[1], "baseline_mm": 1000 * ratio * pixel,
            "focus_distance_m": plane,
            **{f"center_cam_{name}_m": value for name, value in zip("xyz", eye * (1, 1, -1))},
            **{f"center_cam_r{name}_rad": value for name, value in zip("xyz", turn)}},
        "meta": {
            "scene": pathlib.Path(scene).stem, "category": "additional",
            "date": datetime.date.today().isoformat(), "version": integral.__version__,
            "authors": "povray-integral", "contact": "none",
            "disp_min": surfaces.min(), "disp_max": surfaces.max(),
            "frustum_disp_min": -ratio, "frustum_disp_max": surfaces.max(), "depth_map_scale": float(scale)}}


def write_pfm(path, values):
    with open(path, "wb") as file:
        file.write(b"Pf\n%d %d\n-1\n" % values.shape[::-1])
        file.write(np.ascontiguousarray(values[::-1], dtype="<f4").tobytes())


def write_hdf5(path, arrays, attributes):
    import h5py
    with h5py.File(path, "w") as file:
        for name, values in arrays.items():
            file.create_dataset(name, data=values, compression="gzip")
        for section in attributes.values():
            file.attrs.update(section)


def check(metadata):
    if "parallax" in metadata or "projection" in metadata or metadata["render"].get("pseudoscopic"):
        fail("the scene's camera is an integral one with parallax, a projection lens or exchanged "
             "depth; take those words out")


def true_depths(depth_mm, metadata, ratio):
    """Depths in scene units and disparities of depths behind the sheet."""
    distance = metadata["aperture"]["distance_mm"]
    far = distance + depth_mm.astype(float)
    return ((far * metadata["camera"]["units_per_mm"]).astype(np.float32),
            (ratio * (distance / far - 1)).astype(np.float32))


def render_all(given, words, scratch):
    """The views from above and from the left [v, u, y, x, channel], their depths, the depths of the middle
    view with more values, and the quilt's metadata and ratio: the greatest disparity, of no distance."""
    views, size, scale = given.views, given.size, given.truth_scale
    sheet = "lens_sheet { square pitch 1 thickness 3 ior 1.5 }"
    # The scene's own eye measures distances, wherever the sheet is.
    look, _ = render(given.renderer, given.scene, f"{sheet} film {{ pixel_pitch {WINDOW_MM / 100} }}",
                     (100, max(1, round(100 * size[1] / size[0]))), os.path.join(scratch, "look"),
                     [*words, "+Q0", "-A"])
    check(look.metadata)
    plane, ratio = placed(look.eye_distances, given.disparity, size[0])
    given.folder.mkdir(parents=True, exist_ok=True)
    step = ratio * WINDOW_MM / size[0]

    def quilt(grid, pixels, name, options):
        """Renders a grid of views with so many times the pixels."""
        camera = (f"{sheet} sheet_distance {plane!r} capture_aperture <{grid[0] * step!r}, "
                  f"{grid[1] * step!r}> film {{ pixel_pitch "
                  f"<{WINDOW_MM / (pixels * grid[0] * size[0])!r}, "
                  f"{WINDOW_MM / (pixels * size[0] * grid[1])!r}> }}")
        output = os.path.join(scratch, "{}_qs{}x{}a{:.5g}".format(name, *grid, size[0] / size[1]))
        _, warnings = render(given.renderer, given.scene, camera,
                             (pixels * grid[0] * size[0], pixels * grid[1] * size[1]), output,
                             [*words, *options, f"Integral_Quilt={grid[0]}x{grid[1]}"])
        return integral.read_quilt(output + ".png", output + ".exr"), warnings

    print(f"rendering {views[0] * views[1]} views of {size[0]} x {size[1]} pixels", flush=True)
    all_views, warnings = quilt(views, 1, "all", [])
    if warnings:
        print(warnings, file=sys.stderr)
    fine = all_views.depth_mm[views[1] // 2, views[0] // 2]
    if scale > 1:
        print(f"rendering true depths of {scale * size[0]} x {scale * size[1]} pixels", flush=True)
        fine = quilt((1, 1), scale, "fine", ["+Q0", "-A"])[0].depth_mm[0, 0]
    return all_views, fine, ratio


def make_data_set():
    given, words = options()
    views, size, scale = given.views, given.size, given.truth_scale
    with tempfile.TemporaryDirectory() as scratch:
        quilt, fine, ratio = render_all(given, words, scratch)
    pictures = quilt.views[::-1, ..., :3]
    depths, disparities = true_depths(quilt.depth_mm[::-1], quilt.metadata, ratio)
    fine_depth, fine_disparity = true_depths(fine, quilt.metadata, ratio)
    surfaces = np.where(np.isfinite(depths), disparities, np.nan)
    config = parameters(given.scene, quilt.metadata, views, size, ratio, surfaces, scale)

    for number in range(views[0] * views[1]):
        at = divmod(number, views[0])
        picture = integral.Frame(pictures[at], encoding=quilt.encoding)
        picture.write(given.folder / f"input_Cam{number:03}.png")
        write_pfm(given.folder / f"gt_disp_lowres_Cam{number:03}.pfm", disparities[at])
        write_pfm(given.folder / f"gt_depth_lowres_Cam{number:03}.pfm", depths[at])
    middle = views[1] // 2, views[0] // 2
    truth = {"disp_lowres": disparities[middle], "depth_lowres": depths[middle]}
    if scale > 1:
        truth.update(disp_highres=fine_disparity, depth_highres=fine_depth)
    for name, values in truth.items():
        write_pfm(given.folder / f"gt_{name}.pfm", values)
    write_masks(given.folder, fine_disparity, np.isfinite(fine_depth), scale)
    with open(given.folder / "parameters.cfg", "w") as file:
        parser = configparser.ConfigParser()
        parser.read_dict(config)
        parser.write(file)
    if given.hdf5:
        write_hdf5(given.hdf5, {"LF": pictures, "disparity": disparities, "depth_m": depths, **truth},
                   config)
    print(f"{given.folder}: disparities of surfaces from {config['meta']['disp_min']:.3f} to "
          f"{config['meta']['disp_max']:.3f} pixels")


def main():
    try:
        make_data_set()
    except (ValueError, OSError) as error:
        fail(error)


if __name__ == "__main__":
    main()
