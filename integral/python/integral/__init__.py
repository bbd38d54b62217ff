# SPDX-License-Identifier: AGPL-3.0-or-later
"""Integral images as NumPy arrays: frames under lens sheets, their rays, light fields and views.

    import integral
    frame = integral.read("frame.png")              # of povray-integral, with its geometry
    picture = integral.replay(frame, eye=(30, 0, 300))
    field = frame.lightfield()                      # field.samples[v, u, t, s, channel]
    rays = frame.camera().rays([[0.5, 0.5]])        # of the first pixel
    depth_mm = integral.depth(frame).depth_mm

Lengths are in mm, angles in degrees. Pictures are arrays [y, x, channel]. Functions and their
messages are those of the program integral. Invalid values raise ValueError, files that cannot be
read InputError (a ValueError and an OSError), files that cannot be written OutputError (an OSError).
Long work runs on all cores without Python's lock, calls progress(done, total) some times a second,
and ends on Ctrl-C.
"""
from ._integral import InputError, OutputError
from ._integral import version as __version__
from .camera import Camera, Rays
from .frame import Frame, read
from .geometry import Aperture, Film, LensSheet, document
from .light_field import LightField
from .measuring import (Depth, DepthFrame, Fit, compare, depth, difference, fit, known_sheets,
                        read_depths, refocus, sheet_figures, write_depths)
from .quilt import Quilt, read_quilt
from .viewing import frame_from_views, interlace, panel, panel_names, plot, replay, views

__all__ = [
    "Aperture", "Camera", "Depth", "DepthFrame", "Film", "Fit", "Frame", "InputError", "LensSheet",
    "LightField", "OutputError", "Quilt", "Rays", "compare", "depth", "difference", "document", "fit",
    "frame_from_views", "interlace", "known_sheets", "panel", "panel_names", "plot", "read",
    "read_depths", "read_quilt", "refocus", "replay", "sheet_figures", "views", "write_depths",
]
