# SPDX-License-Identifier: AGPL-3.0-or-later
"""Frames: pictures with the geometry that maps their pixels to rays."""
import copy
import os
from typing import Any, Callable, Optional, Tuple, Union

import numpy as np

from . import _integral
from .camera import Camera
from .geometry import Aperture, Document, Film, LensSheet, _aperture, _document, _film, _sheet
from .light_field import LightField

Encoding = Union[str, float]
Progress = Optional[Callable[[int, int], Any]]


class Frame:
    """A picture, and its geometry if known.

    image          array [y, x, channel] of uint8 or uint16 (full scale = 1) or float32 samples, with
                   3 channels (red, green, blue) or 4 (and alpha). It may be written to, or replaced
                   by an array of the same height and width.
    encoding       of the samples: "srgb", "linear", or the gamma of a power law (a number). None:
                   the metadata's, or else sRGB
    premultiplied  whether the colours have been multiplied by alpha, in linear light
    metadata       the document of the frame's file, a dict, with "sheet", "film", "aperture" and,
                   for rendered frames, "camera" (the sheet's place in the scene), "parallax" and
                   "render"; None for a picture without geometry

    Frame(image, sheet, film, aperture) makes a frame of an array of any strides. uint8, uint16 and
    float32 arrays are not copied; other floats become float32. `metadata` may stand in place of sheet, film and aperture. Frames
    can be pickled and copied.
    """

    def __init__(self, image: Any, sheet: Optional[LensSheet] = None, film: Optional[Film] = None,
                 aperture: Optional[Aperture] = None, *, encoding: Optional[Encoding] = None,
                 premultiplied: bool = False, metadata: Optional[Document] = None):
        image = np.asarray(image)
        if image.dtype.kind == "f":
            image = image.astype(np.float32, copy=False)
        parts = [part for part in (sheet, film, aperture) if part is not None]
        if parts and (len(parts) < 3 or metadata is not None):
            raise ValueError("sheet, film and aperture belong together, or metadata in their place")
        if parts:
            metadata = _document(sheet, film, aperture)  # type: ignore[arg-type]
        self.image, self.premultiplied = image, premultiplied
        self.encoding, self.metadata = _integral.complete(image, encoding, metadata)

    @classmethod
    def _of(cls, image: np.ndarray, encoding: Encoding, premultiplied: bool,
            metadata: Optional[Document]) -> "Frame":
        frame = cls.__new__(cls)
        frame.image, frame.encoding, frame.premultiplied = image, encoding, premultiplied
        frame.metadata = metadata
        return frame

    def __reduce__(self) -> Any:
        return Frame._of, (self.image, self.encoding, self.premultiplied, self.metadata)

    def __copy__(self) -> "Frame":
        return Frame._of(self.image, self.encoding, self.premultiplied, copy.copy(self.metadata))

    def __repr__(self) -> str:
        height, width, channels = self.image.shape
        text = f"{width} x {height} x {channels} {self.image.dtype}, {self.encoding}"
        if self.metadata is not None:
            sheet = self.sheet
            text += f"; {sheet.arrangement} lenses of {sheet.pitch_mm:.4g} mm"
        return f"<integral.Frame: {text}>"

    def _geometry(self) -> Document:
        if self.metadata is None:
            raise ValueError("the frame has no geometry; give it sheet, film and aperture")
        return self.metadata

    @property
    def sheet(self) -> LensSheet:
        """The lens sheet. Raises ValueError for a picture without geometry."""
        return _sheet(self._geometry())

    @property
    def film(self) -> Film:
        """The film. Raises ValueError for a picture without geometry."""
        return _film(self._geometry())

    @property
    def aperture(self) -> Aperture:
        """The capture aperture. Raises ValueError for a picture without geometry."""
        return _aperture(self._geometry())

    def camera(self, space: str = "sheet") -> Camera:
        """The camera that made the frame. `space`: "sheet" for the sheet frame in mm, as the viewer
        sees it, or "scene" for the scene that was rendered, in its units and with its parallax."""
        return Camera._of(self._geometry(), space)

    def linear(self) -> np.ndarray:
        """The image in linear light: float32 [y, x, channel], not premultiplied, 1 is full scale."""
        return _integral.linear(self)

    def lightfield(self, directions: Optional[Tuple[int, int]] = None, threads: int = 0,
                    progress: Progress = None) -> LightField:
        """The frame as L[v, u, t, s, channel], with the axes in mm: see LightField.

        directions  numbers of u and v, 1 to 4096; None: the film's pixels behind a lens, rounded
        """
        place, samples, axes = _integral.light_field(self, directions, threads, progress)
        if place is not None:
            column, row, v, u, t, s = place
            part = self.image[row:row + t * v, column:column + s * u]
            samples = part.reshape(t, v, s, u, -1).transpose(1, 3, 0, 2, 4)  # a view
        u_mm, v_mm, s_mm, t_mm, aperture_mm, poles_mm = axes
        return LightField(samples, place is not None, u_mm, v_mm, s_mm, t_mm, aperture_mm, poles_mm,
                          copy.deepcopy(self._geometry()), directions)

    def write(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the frame as PNG, OpenEXR or TIFF, by the path's ending, with its geometry and
        physical resolution. The file appears whole or not at all. Raises OutputError."""
        _integral.write(self, os.fspath(path))


def read(path: Union[str, "os.PathLike[str]"], sheet: Union[str, "os.PathLike[str]"] = "") -> Frame:
    """Reads a frame, or any picture that `integral` reads, with the geometry that it carries.

    The geometry is the first that exists of: `sheet` (a JSON file), the picture's own document, a
    document beside it (FRAME.png.json, FRAME.json). Without any, Frame.metadata is None. Raises
    InputError, which is a ValueError and an OSError; what a user should know about the file comes as
    a UserWarning.
    """
    return Frame._of(*_integral.read(os.fspath(path), os.fspath(sheet)))
