# SPDX-License-Identifier: AGPL-3.0-or-later
"""The rays of a frame's pixels, and the pixels of rays."""
import copy
from typing import Any, NamedTuple, Tuple

import numpy as np

from . import _integral
from .geometry import Aperture, Document, Film, LensSheet, _document


class Rays(NamedTuple):
    """The rays of n places on a film.

    imaged      [n] bool: whether a lens images the place for an eye in the aperture
    origins     [n, 3] start of the line of sight on the viewer's side; NaN where not imaged
    directions  [n, 3] unit vectors into the scene; NaN where not imaged
    lenses      [n, 2] index (i, j) of the lens; 0 where not imaged
    """

    imaged: np.ndarray
    origins: np.ndarray
    directions: np.ndarray
    lenses: np.ndarray


class Camera:
    """A sheet, a film behind it and an aperture before it: which ray belongs to which pixel.

    Its space is the sheet frame: mm, origin at the sheet's centre on the plane of the poles, x to
    the viewer's right, y up, z away from the viewer into the scene; the film is at z = thickness,
    the aperture at z = -distance. Frame.camera("scene") has the space of the rendered scene.

    Places on the film are in pixels, x to the right and y down from the film's top left corner; the
    middle of the first pixel is (0.5, 0.5). Arrays may have any strides and types; results are
    doubles, the same to the bit as the C++ library's. Threads share the work of long arrays
    (`threads`: 0 for one for each core).

    model    "extended_pinhole" or "pinhole"
    mapping  how a pixel finds its lens: "auto", "closest", "accurate" or "exhaustive"
    """

    def __init__(self, sheet: LensSheet, film: Film, aperture: Aperture,
                 model: str = "extended_pinhole", mapping: str = "auto"):
        self._set(_document(sheet, film, aperture, render={"model": model, "mapping": mapping}),
                  "sheet")

    def _set(self, made: Document, space: str) -> None:
        if space not in ("sheet", "scene"):
            raise ValueError(f'space {space!r}: "sheet" or "scene" is expected')
        self._made, self.space = _integral.document(made), space
        self._camera = _integral.Camera(self._made, space == "scene")

    @classmethod
    def _of(cls, made: Document, space: str) -> "Camera":
        camera = cls.__new__(cls)
        camera._set(made, space)
        return camera

    def __reduce__(self) -> Any:
        return Camera._of, (self._made, self.space)

    @property
    def document(self) -> Document:
        """The geometry, as in frames' files."""
        return copy.deepcopy(self._made)

    def rays(self, pixels: Any, threads: int = 0) -> Rays:
        """Returns the rays of places on the film, an array [n, 2]; `pixel_centres` gives the middles
        of all pixels. A ray starts on the aperture and goes through the lens's pole into the scene."""
        return Rays(*self._camera.rays(pixels, threads))

    def pixel_centres(self) -> np.ndarray:
        """The middles of all pixels [height * width, 2], row by row."""
        film = self._made["film"]
        x, y = np.meshgrid(np.arange(film["width"]) + 0.5, np.arange(film["height"]) + 0.5)
        return np.stack([x.ravel(), y.ravel()], axis=1)

    def pixels_seen(self, origins: Any, directions: Any,
                    threads: int = 0) -> Tuple[np.ndarray, np.ndarray]:
        """Inverse of `rays`: the places on the film [n, 2] that are seen along lines, and the
        lenses (i, j) whose cells the lines cross [n, 2]. `origins` [n, 3] are any points of the
        lines, `directions` [n, 3] have any length and either sense. Places may be outside the film;
        they are NaN for lines parallel to the sheet."""
        return self._camera.pixels_seen(origins, directions, threads)

    def pixels_imaging(self, points: Any, lenses: Any, threads: int = 0) -> np.ndarray:
        """The places on the film [n, 2] at which lenses [n, 2] image points [n, 3]: NaN where a lens
        images no light of the point. The points must not lie in the plane of the sheet."""
        return self._camera.pixels_imaging(points, lenses, threads)

    def poles(self, lenses: Any, threads: int = 0) -> np.ndarray:
        """The poles of lenses [n, 2], mm from the sheet's centre [n, 2]: of a lenticular lens, a
        point of its axis."""
        return self._camera.poles(lenses, threads)
