# SPDX-License-Identifier: AGPL-3.0-or-later
"""Light fields: frames by direction and lens."""
import dataclasses
import functools
from typing import Any, Dict, Optional, Tuple

import numpy as np

from . import _integral


@dataclasses.dataclass(frozen=True, eq=False)
class LightField:
    """The light field L[v, u, t, s, channel] of a frame.

    u, v are the column and the row of a sample behind its lens, from the left and from the top of
    the film; s, t are the column and the row of the lens, from the left and from the top. Behind
    lenticular lenses there is one v, and t is a row of film pixels; behind lenses that lie across
    there is one u, and s is a column of film pixels. In odd rows of a hexagonal sheet, and in all
    rows of a slanted one, lenses are shifted: `poles_mm` has their places.

    samples      [v, u, t, s, channel] in the frame's encoding. If each lens covers the same whole
                 number of pixels, a view of the frame's own array (see `is_view`), without lenses
                 that the film covers only in part. Otherwise each lens's width (and height; of
                 hexagonal lenses the height of a row) is divided into as many equal parts as there
                 are directions, and a sample is the light in the middle of its part: bilinear
                 between the centres of film pixels, in linear light, each colour at its own
                 subpixels; black where there is no film.
    is_view      whether writing to `samples` changes the frame
    u_mm, v_mm   where a direction's ray meets the aperture plane, mm from the lens's pole, along the
                 rows of lenses and across them (x and y for upright lenses); exact for the middle v
                 and u. The order is the opposite of the film's: u_mm falls, v_mm rises.
    s_mm, t_mm   the lenses' places on the sheet, mm from its centre, along the rows of lenses and
                 across them: of the middle row and column
    aperture_mm  [v, u, 2] where the ray meets the aperture plane, (x, y) in mm from the lens's pole,
                 for each direction; NaN if its light is totally reflected
    poles_mm     [t, s, 2] where a lens's light leaves the sheet, (x, y) in mm

    The ray of a sample goes from (poles_mm + aperture_mm, -distance) to (poles_mm, 0) into the
    scene. Lenticular lenses fix only the component of aperture_mm across the lenses; the other is 0.
    """

    samples: np.ndarray
    is_view: bool
    u_mm: np.ndarray
    v_mm: np.ndarray
    s_mm: np.ndarray
    t_mm: np.ndarray
    aperture_mm: np.ndarray
    poles_mm: np.ndarray
    _document: Dict[str, Any] = dataclasses.field(repr=False)
    _directions: Optional[Tuple[int, int]] = dataclasses.field(repr=False)

    @functools.cached_property
    def imaged(self) -> np.ndarray:
        """[v, u, t, s] whether the frame's camera images the sample's film pixels (if it is
        interpolated, all of them) through this lens, so that the sample is light that came along its
        ray. Computed on first use, by a ray for each pixel."""
        return _integral.light_field_imaged(self._document, self._directions, 0)
