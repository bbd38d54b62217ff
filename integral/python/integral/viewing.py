# SPDX-License-Identifier: AGPL-3.0-or-later
"""Pictures that eyes see of frames; frames of views; images for panels."""
import os
import warnings
from typing import Any, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _integral
from .frame import Encoding, Frame, Progress
from .geometry import Aperture, Document, Film, LensSheet, document

Range = Tuple[Optional[float], Optional[float]]


def replay(frame: Frame, eye: Optional[Tuple[float, float, float]] = None,
           size: Optional[Tuple[int, int]] = None, *, fit: str = "contain",
           part: Optional[Tuple[float, float, float, float]] = None, samples: Optional[int] = None,
           pupil: float = 0, focus: float = 0, film_gap: float = 0, lens_blur: float = 0,
           lens_model: str = "extended_pinhole", as_seen: bool = False, raw_draft: bool = False,
           threads: int = 0, progress: Progress = None) -> np.ndarray:
    """Returns the picture that an eye sees of a frame through its lens sheet, as `integral replay`
    makes it: an array [y, x, channel] of the frame's type, encoding and channels. The sheet fills the picture; it is
    black where no light of the film reaches the eye.

    eye         (x, y, distance) in mm: to the right of the sheet's centre, above it, and in front of
                it (> 0). None: the aperture's centre, which sees the scene's perspective picture
    size        (width, height) in pixels; None: 1000 on the longer side
    fit         of the sheet, where the size has another shape: "contain" (with bars), "cover" or
                "stretch"
    part        (x, y, width, height) in mm: only this part of the sheet, by its middle and size
    samples     samples x samples in each pixel, 1 to 64. None: 3; with a pupil or blur 8
    pupil       diameter of the eye's pupil, mm; 0: every depth is sharp
    focus       depth in focus, mm behind the sheet (negative: in front)
    film_gap    mm by which the film lies behind the lenses' focus
    lens_blur   diameter of the spot on the film from which a point of a lens gathers light, mm
    lens_model  "extended_pinhole", "pinhole" or "full" (aberrations of the curved surface)
    as_seen     a person's pupil, the spread of printed dots and the lenses' blur, where not given
    raw_draft   show a draft's own pixels, not the finer pixels of the print
    """
    return _integral.replay(frame, eye, size, fit, part, samples, pupil, focus, film_gap, lens_blur,
                            lens_model, as_seen, raw_draft, threads, progress)


def views(frame: Frame, grid: Optional[Tuple[int, int]] = None, eyes: bool = False,
          size: Optional[Tuple[int, int]] = None, *, threads: int = 0,
          progress: Progress = None) -> np.ndarray:
    """The views of a frame, an array [row, column, y, x, channel]: column 0 is seen from the far
    left, row 0 from the lowest eye. Lenticular lenses have views in one direction only.

    grid  numbers of columns and rows. None: the film's pixels behind a lens, rounded
    eyes  False: parallel views, of infinitely distant eyes, with a pixel for each lens; True: what
          eyes see that are spread over the viewing zone
    size  (width, height) of views of eyes, in pixels. None: 500 on the longer side
    """
    return _integral.views(frame, grid, eyes, size, threads, progress)


def frame_from_views(views: Any, sheet: LensSheet, film: Film, aperture: Aperture,
                     eyes: bool = False, *, encoding: Encoding = "srgb", threads: int = 0,
                     progress: Progress = None) -> Frame:
    """The frame that shows views [row, column, y, x, channel] through a sheet: the inverse of
    `views`. The film needs its width and height in pixels. Parallel views need a pixel for each lens
    (as from `views`), views of eyes (`eyes`) any size."""
    made = document(sheet, film, aperture)
    image = _integral.frame_from_views(np.asarray(views), made, encoding, eyes, threads, progress)
    return Frame(image, encoding=encoding, metadata=made)


def interlace(pictures: Union[Frame, Any], panel: str, grid: Optional[Tuple[int, int]] = None, *,
              fit: str = "contain", encoding: Encoding = "srgb", threads: int = 0, progress: Progress = None) -> Frame:
    """The image that a light-field panel is sent, as `integral lcd` makes it.

    pictures  a frame, or views of eyes [row, column, y, x, channel]
    panel     a name of `panel_names()`, or the path of a panel's description or calibration (.json)
    grid      numbers of views (columns, rows) to take of a frame. None: the panel's pixels behind a
              lens, rounded. A frame that was rendered for the panel is passed through
    fit       of pictures whose shape is not the panel's: "contain" (with bars), "cover" or "stretch"
    encoding  of views
    """
    frame, given = (pictures, None) if isinstance(pictures, Frame) else (None, np.asarray(pictures))
    made, notices = _integral.interlace(frame, given, encoding, panel, grid, fit, threads,
                                         progress)
    for notice in notices:
        warnings.warn(notice, stacklevel=2)
    return Frame._of(*made)


def plot(path: Union[str, "os.PathLike[str]"], curves: Mapping[str, Sequence[Any]], x: str = "",
         y: str = "", title: str = "", subtitle: str = "", *, log_x: bool = False,
         log_y: bool = False, x_range: Range = (None, None), y_range: Range = (None, None)) -> None:
    """Draws curves as FILE.svg or FILE.png, in the style of the commands' plots.

    curves   {label: (x, y)} or {label: (x, y, style)}; style: "line", "points", "both" (the default)
             or "dashed". Points that are not finite are left out
    x, y     labels of the axes: quantity and unit, as "distance (mm)"
    x_range, y_range  ends of the axes; None: so that all points fit
    """
    made = [(label, [float(v) for v in curve[0]], [float(v) for v in curve[1]],
             curve[2] if len(curve) > 2 else "both") for label, curve in curves.items()]
    _integral.plot(os.fspath(path), made, (x, log_x, *x_range), (y, log_y, *y_range), title,
                   subtitle)


def panel(name: str) -> Document:
    """The description of a panel: of a name of `panel_names()`, or of a file (.json)."""
    return _integral.panel(name)


def panel_names() -> List[str]:
    """The names of the panels that are known."""
    return _integral.panel_names()
