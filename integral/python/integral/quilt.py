# SPDX-License-Identifier: AGPL-3.0-or-later
"""Quilts: many views of one scene in one picture."""
import os
from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np

from . import _integral
from .frame import Encoding
from .geometry import Document

Path = Union[str, "os.PathLike[str]"]


class Quilt:
    """The views of a quilt.

    views          [row, column, y, x, channel] of uint8, uint16 or float32: column 0 is seen from the
                   far left, row 0 from the lowest eye. Lenticular lenses have one row or one column
    encoding, premultiplied  of the samples, as of Frame
    aspect         a view's width divided by its height, as it is to be seen
    metadata       the document of the frame whose views these are, with its "quilt"; None for other
                   programs' quilts
    eyes_mm        [row, column, 2] places of the eyes, mm to the right of the sheet's axis and above
                   it, at metadata["quilt"]["eyes"]["distance_mm"]; None if they are not known
    depth_mm       [row, column, y, x] behind the sheet (read_depths); None if not read
    """

    def __init__(self, views: Any, aspect: Optional[float] = None, *, encoding: Encoding = "srgb",
                 premultiplied: bool = False, metadata: Optional[Document] = None,
                 eyes_mm: Optional[np.ndarray] = None, depth_mm: Optional[np.ndarray] = None):
        self.views = np.asarray(views)
        if self.views.ndim != 5:
            raise ValueError("views: an array [row, column, y, x, channel] is expected")
        self.aspect = aspect or self.views.shape[3] / self.views.shape[2]
        self.encoding, self.premultiplied = encoding, premultiplied
        self.metadata, self.eyes_mm, self.depth_mm = metadata, eyes_mm, depth_mm

    def __repr__(self) -> str:
        rows, columns, height, width = self.views.shape[:4]
        return f"<integral.Quilt: {columns} x {rows} views of {width} x {height} pixels>"

    def write(self, path: Path) -> str:
        """Writes the quilt as PNG, OpenEXR or TIFF, and returns its path: the name gets the ending
        _qsCxRaASPECT if it has none. Raises OutputError."""
        return _integral.write_quilt(os.fspath(path), self.views, self.encoding, self.premultiplied,
                                     self.metadata, self.aspect)


def read_quilt(path: Union[Path, Sequence[Path]], depths: Optional[Path] = None, *,
               grid: Optional[Tuple[int, int]] = None, aspect: Optional[float] = None) -> Quilt:
    """Reads the views of a quilt, of an MPO or a stereo OpenEXR, or of the files of all views.

    depths  the quilt's OpenEXR file of Integral_Depth_Image
    grid    numbers of columns and rows; None: as the file or its name states
    aspect  of a view; None: as the file or its name states, else that of its pixels

    Raises InputError, and ValueError if the files do not fit together.
    """
    paths = [path] if isinstance(path, (str, os.PathLike)) else list(path)
    views, encoding, premultiplied, metadata, shape, eyes = _integral.read_quilt(
        [os.fspath(one) for one in paths], grid, aspect)
    depth = None if depths is None else _tiles(_integral.read_depths(os.fspath(depths)), views.shape)
    return Quilt(views, shape, encoding=encoding, premultiplied=premultiplied, metadata=metadata,
                 eyes_mm=eyes, depth_mm=depth)


def _tiles(depths: Tuple[np.ndarray, Document, np.ndarray], shape: Tuple[int, ...]) -> np.ndarray:
    """[row, column, y, x] of the depths of a quilt, whose views have this shape."""
    rows, columns, height, width = shape[:4]
    depth, metadata, _ = depths
    record = metadata.get("quilt")
    if record is None or record["columns"] * record["rows"] != rows * columns:
        raise ValueError("the depths are not those of this quilt")
    across, up = record["columns"], record["rows"]
    if depth.shape[1] // across != width or depth.shape[0] // up != height:
        raise ValueError("the depths are of views of another size")
    depth = depth[depth.shape[0] - up * height:, :across * width]
    tiles = depth.reshape(up, height, across, width).swapaxes(1, 2)[::-1]
    return tiles.reshape(rows, columns, height, width)
