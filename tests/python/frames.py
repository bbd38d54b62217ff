# SPDX-License-Identifier: AGPL-3.0-or-later
"""Frames: their files, arrays, geometry and errors."""
import copy
import json
import math
import pathlib
import pickle
import os
import struct
import subprocess
import warnings
import zlib

import numpy as np

import integral
from cases import near, raises, run, same, warns


def sentence_of(*words):
    """What the command says, without its own name."""
    said = subprocess.run([os.environ["INTEGRAL"], *words], capture_output=True, text=True).stderr
    return said.split(": ", 1)[1].strip()


def test_a_file_becomes_arrays_and_geometry():
    frame = integral.read(pathlib.Path("whole.png"))
    assert frame.image.shape == (90, 150, 3) and frame.image.dtype == np.uint16
    assert frame.encoding == "srgb" and not frame.premultiplied
    assert frame.sheet == integral.LensSheet("lenticular", 1.27, 3.08, 1.6)
    near(frame.film.pixel_pitch_mm, (25.4 / 300, 25.4 / 300), 1e-15)
    assert (frame.film.width, frame.film.height) == (150, 90)
    near(frame.aperture.distance_mm, 300, 1e-9)
    assert frame.metadata["render"]["scene"] == "whole.pov"
    linear = frame.linear()
    stored = frame.image / 65535
    near(linear, np.where(stored <= 0.04045, stored / 12.92, ((stored + 0.055) / 1.055) ** 2.4), 2e-6)


def test_a_frame_comes_back_from_every_format():
    frame = integral.read("squares.png")
    for name in ("copy.png", "copy.tiff"):
        frame.write(name)
        again = integral.read(name)
        same(again.image, frame.image)
        assert again.metadata == frame.metadata
    frame.write("copy.exr")
    again = integral.read("copy.exr")
    assert again.encoding == "linear" and again.image.dtype == np.float32
    near(again.image, frame.linear(), 2e-6)
    assert {**again.metadata, "encoding": 0} == {**frame.metadata, "encoding": 0}


def test_arrays_of_any_strides_become_frames():
    rng = np.random.default_rng(2)
    large = rng.integers(0, 256, (40, 60, 4), dtype=np.uint8)
    geometry = (integral.LensSheet("square", 1, 2, 1.5), integral.Film.of_dpi(300),
                integral.Aperture(250, math.inf, 80))
    for image in (large[::2, ::-1, :3], large.transpose(1, 0, 2)[..., ::-1],
                  np.asfortranarray(large), large[..., :3] / 255):
        frame = integral.Frame(image, *geometry)
        height, width = image.shape[:2]
        assert (frame.film.width, frame.film.height) == (width, height)
        assert frame.aperture == integral.Aperture(250, math.inf, 80)
        frame.write("array.tiff")
        again = integral.read("array.tiff").image
        if image.dtype == np.uint8:
            same(again, np.ascontiguousarray(image))
            assert np.shares_memory(frame.image, image)
        else:
            near(again, image, 1e-7)
    assert json.loads(json.dumps(frame.metadata))["aperture"]["width_mm"] is None
    for kind in ("u2", "f4"):
        values = (large[..., :3] / 255 if kind == "f4" else large[..., :3]).astype("<" + kind)
        for order in "<>":
            integral.Frame(values.astype(order + kind), *geometry).write(f"order{kind}.tiff")
            same(integral.read(f"order{kind}.tiff").image, values.astype(kind))


def test_frames_pickle_and_copy():
    frame = integral.read("round.png")
    for again in (pickle.loads(pickle.dumps(frame)), copy.copy(frame), copy.deepcopy(frame)):
        same(again.image, frame.image)
        assert again.metadata == frame.metadata and again.encoding == frame.encoding
    assert "round" not in repr(frame) and "150 x 120 x 3 uint16" in repr(frame)


def test_errors_are_the_commands_sentences():
    error = raises(integral.InputError, sentence_of("sheet", "nowhere.png"), integral.read,
                   "nowhere.png")
    assert isinstance(error, ValueError) and isinstance(error, OSError)
    pathlib.Path("words.png").write_text("not a picture")
    raises(ValueError, sentence_of("replay", "words.png", "-o", "no.png"), integral.read, "words.png")
    frame = integral.read("whole.png")
    error = raises(integral.OutputError, "nowhere/frame.png", frame.write, "nowhere/frame.png")
    assert isinstance(error, OSError) and not isinstance(error, ValueError)
    raises(OSError, "end it in .png, .exr or .tiff", frame.write, "frame.bmp")


def test_notices_about_files_are_warnings():
    pair = pathlib.Path("pair.mpo").read_bytes()  # a JPEG, and another
    pathlib.Path("cut.jpg").write_bytes(pair[:pair.index(b"\xff\xd9") - 100])
    frame = warns("Premature end of JPEG file", integral.read, "cut.jpg")
    assert frame.metadata is None and frame.image.shape == (360, 600, 3)
    # Those of a call that fails come with it, not with the next; its error goes first.
    whole = integral.read("whole.png")
    geometry = copy.deepcopy(whole.metadata)
    geometry["film"]["width"] = 7
    pathlib.Path("narrow.json").write_text(json.dumps(geometry))
    png, profile = pathlib.Path("whole.png").read_bytes(), b"iCCPx\0\0" + zlib.compress(b"none")
    profile = struct.pack(">I", len(profile) - 4) + profile + struct.pack(">I", zlib.crc32(profile))
    for name, kind in (("always.png", "always"), ("error.png", "error")):
        pathlib.Path(name).write_bytes(png[:33] + profile + png[33:])  # behind IHDR
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter(kind)
            raises(integral.InputError, "7x90", integral.read, name, "narrow.json")
            assert len(caught) == (kind == "always"), (kind, caught)
            whole.linear()
        assert len(caught) == (kind == "always"), (kind, caught)


def test_wrong_arrays_and_values_are_refused_in_words():
    image = np.zeros((4, 6, 3), np.uint8)
    raises(ValueError, "an array of shape (4, 6) is no picture", integral.Frame, image[..., 0])
    raises(ValueError, "an array of shape (0, 6, 3) is no picture", integral.Frame, image[:0])
    raises(ValueError, "an array of int64 is no picture", integral.Frame, image.astype(np.int64))
    raises(ValueError, 'encoding log: "srgb", "linear" or a gamma', integral.Frame, image,
           encoding="log")
    raises(ValueError, "belong together", integral.Frame, image, integral.LensSheet())
    raises(ValueError, "the geometry is of a frame of 7x4 pixels, the image has 6x4", integral.Frame,
           image, integral.LensSheet(), integral.Film.of_dpi(300, 7, 4), integral.Aperture(300))
    raises(ValueError, "sheet.pitch_mm", integral.Frame, image, integral.LensSheet(pitch_mm="wide"),
           integral.Film.of_dpi(300), integral.Aperture(300))
    raises(ValueError, "the frame has no geometry", integral.replay, integral.Frame(image))
    raises(ValueError, "the frame has no geometry", lambda: integral.Frame(image).sheet)
    assert integral.Frame(image, encoding=1.8).encoding == 1.8


def test_everything_public_is_explained():
    for name in integral.__all__:
        thing = getattr(integral, name)
        assert thing.__doc__ and len(thing.__doc__) > 30, name
        assert thing.__module__.startswith("integral"), (name, thing.__module__)
        for member, value in vars(thing).items() if isinstance(thing, type) else ():
            if not member.startswith("_") and callable(value):
                assert value.__doc__, (name, member)


run(globals())
