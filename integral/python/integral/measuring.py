# SPDX-License-Identifier: AGPL-3.0-or-later
"""Figures of pictures and sheets; depth measured in frames."""
import os
from typing import Any, Dict, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _integral
from .frame import Frame, Progress
from .geometry import Aperture, Document, Film, LensSheet, _document, _sheet
from .quilt import Quilt


class Depth(NamedTuple):
    """Centre view of a frame or a quilt, with its depth: arrays of one height and width.

    depth_mm    [y, x] behind the sheet, negative in front; NaN where nothing is known; None if only
                disparities are known
    disparity   [y, x] pixels from one view to the next: 0 at the sheet, greater for nearer points
    confidence  [y, x] 0 to 1
    colour      [y, x, 3] in the frame's encoding, 1 is full scale
    pixel_mm    the side of a pixel, on the sheet; None if only disparities are known
    """

    depth_mm: Optional[np.ndarray]
    disparity: np.ndarray
    confidence: np.ndarray
    colour: np.ndarray
    pixel_mm: Optional[float]


class DepthFrame(NamedTuple):
    """The true depths that Integral_Depth_Image writes: of the first surface that each pixel shows.

    depth_mm       [y, x] behind the sheet, negative in front; infinite where there is no surface, NaN
                   where the pixel images nothing
    metadata       the document of the frame, or of the quilt with its "quilt"
    eye_distances  from the plane of the scene's eye to the surfaces that it sees, in scene units;
                   infinite where there is none: the distances that `fit` takes
    """

    depth_mm: np.ndarray
    metadata: Document
    eye_distances: np.ndarray


class Fit(NamedTuple):
    """Where a sheet stands in a scene.

    sheet_distance  from the scene's eye, in the unit of the distances
    parallax        mm that the scene's eye moves for each mm of the viewer's
    share           part of the distances within the allowed depth
    """

    sheet_distance: float
    parallax: float
    share: float


def compare(a: Union[Frame, Any], b: Union[Frame, Any], flip: bool = False) -> Document:
    """The figures of `integral compare` for two frames, or arrays [y, x, channel] in sRGB, of one
    size: a dict with "rmse", "psnr" (None for equal pictures), "ssim", "worst_micro_image" and more,
    in the output encoding, where 1 is full scale. `flip` adds FLIP, what a person perceives."""
    return _integral.compare(_frame(a), _frame(b), flip)


def difference(a: Union[Frame, Any], b: Union[Frame, Any], gain: float = 1) -> np.ndarray:
    """|a - b| of each channel as `compare` takes them, times `gain`: an array [y, x, 3]."""
    return _integral.difference(_frame(a), _frame(b), gain)


def _frame(picture: Union[Frame, Any]) -> Frame:
    return picture if isinstance(picture, Frame) else Frame(picture)


def read_depths(path: Union[str, "os.PathLike[str]"]) -> DepthFrame:
    """Reads the true depths of a frame or a quilt, an OpenEXR file. Raises InputError."""
    return DepthFrame(*_integral.read_depths(os.fspath(path)))


def write_depths(path: Union[str, "os.PathLike[str]"], depth_mm: Any, metadata: Document) -> None:
    """Writes depths as the OpenEXR file that `read_depths` reads, and the commands' options.

    depth_mm  [y, x] as of DepthFrame; NaN where a pixel images nothing
    metadata  of the frame or the quilt
    """
    _integral.write_depths(os.fspath(path), np.asarray(depth_mm), metadata)


def depth(picture: Union[Frame, Quilt], quality: str = "good", width: int = 0, *,
          eyes: Optional[Tuple[float, float, float, float]] = None, threads: int = 0,
          progress: Progress = None) -> Depth:
    """Measures the depth of what a frame, or the middle view of a quilt of eyes' views, shows, by the
    multibaseline method of `integral depth`.

    quality  "draft", "good" or "best"
    width    pixels of the map across; 0: about a pixel for each lens, or as many as a view has
    eyes     of a quilt: spacing across, spacing up, distance to the plane without parallax and width
             of a view there, mm. None: the quilt's own; without any, only disparities are known
    """
    if isinstance(picture, Frame):
        if eyes is not None:
            raise ValueError("eyes are for quilts, and the picture is a frame")
        return Depth(*_integral.depth(picture, quality, width, threads, progress))
    return Depth(*_integral.depth_of_views(picture.views, picture.encoding, picture.aspect,
                                           eyes or _eyes_of(picture), quality, width, threads,
                                           progress))


def _eyes_of(quilt: Quilt) -> Optional[Tuple[float, float, float, float]]:
    """The eyes of a quilt with geometry, as `depth` takes them."""
    if quilt.metadata is None:
        return None
    if quilt.eyes_mm is None:
        raise ValueError("the quilt has parallel views; make a frame of them (frame_from_views)")
    rows, columns = quilt.eyes_mm.shape[:2]
    across = np.ptp(quilt.eyes_mm[0, :, 0]) / max(1, columns - 1)
    up = np.ptp(quilt.eyes_mm[:, 0, 1]) / max(1, rows - 1)
    film = quilt.metadata["film"]
    return (across or up, up or across, quilt.metadata["quilt"]["eyes"]["distance_mm"],
            film["width"] * film["pixel_pitch_mm"][0])


def refocus(frame: Frame, focus: float, pupil: float, width: Optional[int] = None,
            quality: str = "good", *, threads: int = 0, progress: Progress = None) -> np.ndarray:
    """The picture [y, x, channel] that a lens takes of what a frame shows, by its measured depth.

    focus  depth in focus, mm behind the sheet (negative: in front)
    pupil  diameter of the lens, mm, before the aperture's centre
    width  pixels across. None: as many as the frame's views have, at least 500
    """
    return _integral.refocus(frame, focus, pupil, width, quality, threads, progress)


def sheet_figures(sheet: LensSheet, film: Film, aperture: Aperture,
                  depths: Sequence[float] = (), pupil: float = 5) -> Document:
    """The figures of `integral sheet --json` before anything is rendered: a dict with the geometry
    and "figures", "depths" (a row for each of `depths`, mm from the sheet) and "sampling".

    pupil  diameter of the eye's pupil, mm
    """
    return _integral.sheet_figures(_document(sheet, film, aperture), list(depths), pupil)


def known_sheets() -> Dict[str, LensSheet]:
    """The lens sheets with names: the thesis's and common commercial ones."""
    return {name: _sheet({"sheet": fields}) for name, fields in _integral.known_sheets().items()}


def fit(distances: Any, sheet: LensSheet, film: Film, aperture: Aperture, budgets: float = 2,
        sheet_distance: Optional[float] = None, parallax: Optional[float] = None) -> Fit:
    """Where a sheet stands in a scene so that nine tenths of a picture lie within `budgets` depth
    budgets of it, as Integral_Fit chooses it.

    distances       of the picture's surfaces from the plane of the scene's eye, in any unit;
                    math.inf where there is no surface
    sheet_distance, parallax  fixed if given; only the other is chosen
    """
    return Fit(*_integral.fit(np.asarray(distances, dtype=float), _document(sheet, film, aperture),
                              budgets, sheet_distance, parallax))
