// SPDX-License-Identifier: AGPL-3.0-or-later
// The light field of a frame: its samples by direction and lens, with the ray of each.
#ifndef INTEGRAL_VIEWS_LIGHT_FIELD_H
#define INTEGRAL_VIEWS_LIGHT_FIELD_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"
#include "integral/frame/view_grid.h"

#include <memory>
#include <optional>
#include <vector>

namespace integral {

/// The axes of a light field L[v, u, t, s]. u and v are the column and the row of a sample behind
/// its lens, from the left and from the top; s and t are the column and the row of the lens, from
/// the left and from the top of the film. Behind lenticular lenses there is one v, and t is a row
/// of film pixels; behind lenses that lie across there is one u, and s is a column of film pixels.
/// In odd rows of a hexagonal lattice, lens s lies half a pitch further right; the lenses of a
/// slanted sheet lie along its own rows, and a slanted lenticular lens moves sideways with t.
class LightFieldAxes {
public:
    /// `directions`: numbers of u and v. natural_views of parallel_views.h gives each film pixel
    /// one. Throws std::invalid_argument as lens_window does, if there is no lens, for more than
    /// 4096 of u or v, and for more than 2^31 - 1 rows of samples (v, u, t).
    LightFieldAxes(const FrameMetadata& metadata, ViewGrid directions);
    ~LightFieldAxes();

    int u() const; ///< number of each
    int v() const;
    int s() const;
    int t() const;

    /// Whether the samples are the film's pixels (views_are_exact): the sample (v, u, t, s) is then
    /// the pixel in column first().column + s u() + u and row first().row + t v() + v. Lenses that
    /// the film covers only in part are left out.
    bool is_exact() const;
    PixelPlace first() const;

    /// Where the light of lens (t, s) leaves the sheet, mm: its pole or, for a lenticular lens, the
    /// point where its axis crosses the film's row or column.
    Vec2 pole(int t, int s) const;

    /// The film point of a sample, mm.
    Vec2 film_point(int v, int u, int t, int s) const;

    /// Where the ray of a direction through a lens at the sheet's centre meets the plane at
    /// `distance` (mm, > 0) in front of the sheet, mm. The ray of another lens meets it as far from
    /// its own pole. Empty if the light is totally reflected.
    std::optional<Vec2> aperture_point(int v, int u, double distance) const;

    /// Coordinate of a point along the rows of lenses (x for upright ones), and across them.
    double along_rows(Vec2 point) const;
    double across_rows(Vec2 point) const;

private:
    friend std::optional<Image> light_field_samples(const Frame&, const LightFieldAxes&, int,
                                                    const Progress&);
    struct State;
    std::unique_ptr<State> state_;
};

/// The samples L[v, u, t, s] in the frame's form, as one picture: row (v u() + u) t() + t has the
/// pixels of all s. If they are not the film's pixels, they are interpolated bilinearly between the
/// centres of film pixels, in linear light, as parallel_views does; black (transparent) where there
/// is no film. `threads` and `progress` as in replay; returns nothing if `progress` stopped the
/// work.
std::optional<Image> light_field_samples(const Frame& frame, const LightFieldAxes& axes,
                                         int threads = 0, const Progress& progress = {});

/// For each sample L[v, u, t, s]: 1 if the frame's camera (recorded_camera) images all film pixels
/// that the sample is interpolated from through lens (t, s), else 0. Micro-images far
/// from the sheet's centre are displaced outwards: the samples at their edge may belong to a
/// neighbouring lens, or to none.
std::vector<unsigned char> light_field_mask(const FrameMetadata& metadata,
                                            const LightFieldAxes& axes, int threads = 0);

} // namespace integral

#endif
