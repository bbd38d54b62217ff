# SPDX-License-Identifier: AGPL-3.0-or-later
"""Lens sheet, film and aperture: the geometry of a frame.

The fields have the names and units of the documents in frames' files. Values are checked when a
frame or a camera is made of them, and when `document` completes them.
"""
import dataclasses
import math
from typing import Any, Dict, Optional, Tuple, Union

from . import _integral

Document = Dict[str, Any]


@dataclasses.dataclass(frozen=True)
class LensSheet:
    """A sheet of equal lenses over a film at their focus.

    arrangement    "lenticular", "square" or "hexagonal"
    pitch_mm       between the axes of neighbouring lenses
    thickness_mm   from the poles of the lenses to the film
    ior            refractive index of the sheet
    slant_degrees  of the lenses, anticlockwise as the viewer sees it; -90 to 90
    offset_mm      (x, y) of lens (0, 0) from the sheet's centre
    """

    arrangement: str = "lenticular"
    pitch_mm: float = 1.27
    thickness_mm: float = 3.08
    ior: float = 1.6
    slant_degrees: float = 0.0
    offset_mm: Tuple[float, float] = (0.0, 0.0)


@dataclasses.dataclass(frozen=True)
class Film:
    """The pixels behind a sheet.

    pixel_pitch_mm  (width, height) of a pixel; Film.of_dpi computes it
    width, height   pixels; None: as many as the image has
    subpixels       "none", "rgb", "bgr", "vrgb", "vbgr", or a dict with "pattern" and "cells", as in
                    frames' documents
    """

    pixel_pitch_mm: Tuple[float, float]
    width: Optional[int] = None
    height: Optional[int] = None
    subpixels: Union[str, Document] = "none"

    @classmethod
    def of_dpi(cls, dpi: float, width: Optional[int] = None, height: Optional[int] = None) -> "Film":
        """A film of `dpi` square pixels an inch."""
        return cls((25.4 / dpi, 25.4 / dpi), width, height)


@dataclasses.dataclass(frozen=True)
class Aperture:
    """The places of the viewer's eyes: a rectangle or an ellipse in front of the sheet, on its axis.

    distance_mm          from the sheet
    width_mm, height_mm  None: the extent whose image fills the lens on the axis; math.inf: no limit
    shape                "rectangle" or "ellipse"
    """

    distance_mm: float
    width_mm: Optional[float] = None
    height_mm: Optional[float] = None
    shape: str = "rectangle"


def document(sheet: LensSheet, film: Film, aperture: Aperture) -> Document:
    """The geometry as the complete document of a file, a dict. Raises ValueError for a value that is
    out of range."""
    return _integral.document(_document(sheet, film, aperture))


def _document(sheet: LensSheet, film: Film, aperture: Aperture, **others: Any) -> Document:
    return {"sheet": _fields(sheet), "film": _fields(film), "aperture": _fields(aperture),
            "encoding": {"kind": "srgb"}, **others}


def _fields(part: Any) -> Document:
    """A part of a document: without what is None, and with null for what has no limit."""
    fields = {f.name: getattr(part, f.name) for f in dataclasses.fields(part)}
    return {name: None if value == math.inf else value
            for name, value in fields.items() if value is not None}


def _sheet(made: Document) -> LensSheet:
    fields = dict(made["sheet"])
    fields["offset_mm"] = tuple(fields["offset_mm"])
    return LensSheet(**fields)


def _film(made: Document) -> Film:
    fields = dict(made["film"])
    fields["pixel_pitch_mm"] = tuple(fields["pixel_pitch_mm"])
    return Film(**fields)


def _aperture(made: Document) -> Aperture:
    fields = dict(made["aperture"])
    for side in ("width_mm", "height_mm"):
        if fields.get(side) is None:
            fields[side] = math.inf
    return Aperture(**fields)
