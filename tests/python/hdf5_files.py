# SPDX-License-Identifier: AGPL-3.0-or-later
"""examples/python/hdf5.py: light fields out to HDF5 files and in from them."""
import glob
import json
import os
import sys

import h5py
import numpy as np

import integral
from cases import colour_of_wall, near, raises, run, same, WALL

sys.path.insert(0, os.path.join(os.environ["TOP"], "examples/python"))
import hdf5  # noqa: E402


def test_a_frame_comes_back_from_an_array_file():
    frame = integral.read("squares.png")
    hdf5.write(frame, "squares.h5")
    with h5py.File("squares.h5") as file:
        same(file["LF"][3, 4, 5, 6], frame.image[5 * 10 + 3, 5 + 6 * 10 + 4])   # lenses of 10 x 10
        near(np.diff(file["s_mm"]), 1.0, 1e-9)
    again = hdf5.read("squares.h5")
    same(again.image, frame.image)
    assert again.metadata == frame.metadata
    with h5py.File("squares.h5", "r+") as file:
        file["LF"][3, 4, 5, 6] = 7
    expected = frame.image.copy()
    expected[5 * 10 + 3, 5 + 6 * 10 + 4] = 7
    same(hdf5.read("squares.h5").image, expected)
    broken = integral.read("broken.png")
    hdf5.write(broken, "broken.h5")
    same(hdf5.read("broken.h5").image, broken.image)


def test_views_of_eyes_become_a_frame():
    # Views of the tests' wall from 9 x 9 eyes, by similar triangles; the rendered frame to compare with.
    frame = integral.read("squares.png")
    zone = integral.read_quilt(glob.glob("eyes_qs*")[0]).metadata["quilt"]["eyes"]
    eye = [(np.arange(9) - 4) / 9 * zone[side] for side in ("width_mm", "height_mm")]
    x, y = (np.arange(120) - 59.5) * 0.1, (44.5 - np.arange(90)) * 0.1
    far = 1 + WALL / zone["distance_mm"]
    across = eye[0][:, None] + (x - eye[0][:, None]) * far                  # [u, x]
    up = -eye[1][:, None] + (y + eye[1][:, None]) * far                     # [v, y]: from above first
    light = np.zeros((9, 9, 90, 120, 3))
    light[..., :2] = colour_of_wall(*np.broadcast_arrays(across[None, :, None, :], up[:, None, :, None]))
    encoded = np.where(light <= 0.0031308, 12.92 * light, 1.055 * np.maximum(light, 0)**(1 / 2.4) - 0.055)
    with h5py.File("views.h5", "w") as file:
        file["LF"] = np.round(255 * encoded).astype(np.uint8)
    with open("squares.json", "w") as file:
        json.dump({name: frame.metadata[name] for name in ("sheet", "film", "aperture")}, file)
    made = hdf5.read("views.h5", "squares.json")
    middle = slice(10, 80), slice(15, 105)
    error = np.abs(made.image[middle] / 255 - frame.image[middle] / 65535)
    assert error.max() < 0.006, error.max()
    raises(SystemExit, "give --sheet", hdf5.read, "views.h5")


if __name__ == "__main__":
    run(globals())
