// SPDX-License-Identifier: AGPL-3.0-or-later
// A scene reconstructed from views and their depth. It gives the light along any line of sight,
// with occlusion.
//
// Depth is measured here as parallax: z / (distance + z) for a point z mm behind the image plane.
// When the eye moves sideways, the point's picture moves by that fraction of the eye's movement.
// Parallax is 0 in the image plane and 1 at infinity. As a point moves along a line of sight, its
// place in a view changes linearly with its parallax.
#ifndef INTEGRAL_DEPTH_RELIEF_H
#define INTEGRAL_DEPTH_RELIEF_H

#include "integral/depth/view_set.h"
#include "integral/frame/picture_fit.h"

#include <vector>

namespace integral {

/// A picture from an eye, in linear light; row by row from the top left.
struct ReliefPicture {
    Vec2 eye; ///< on the eyes' plane, mm
    int width = 0, height = 0;
    PixelPlaces places; ///< mm
    ColourPlanes light;
    std::vector<float> lit; ///< 1, or 0 for a pixel without light; empty: all have some
};

/// The depth map of an eye, and the index of its picture.
struct ReliefMap {
    Vec2 eye; ///< on the eyes' plane, mm
    int width = 0, height = 0;
    PixelPlaces places;          ///< mm
    std::vector<float> parallax; ///< NaN: nothing is known there
    std::size_t picture = 0;     ///< index in Relief's pictures of the picture from this eye
};

/// A line of sight: where it meets the image plane and the plane of the eyes, mm.
struct ReliefLine {
    Vec2 place, eye;
};

/// Linear light along a line of sight, the parallax of the surface where it ends, and whether any
/// view shows it. Light that no view shows is filled in from the farther surface next to it.
struct Seen {
    Colour light;
    double parallax = 0;
    bool known = false;
};

/// Parallax of near and far surfaces.
struct ParallaxSpan {
    double near = 0, far = 0;
};

class Relief {
public:
    /// Takes 1 to 32 maps. Throws std::invalid_argument if they contain no depth.
    Relief(std::vector<ReliefPicture> pictures, std::vector<ReliefMap> maps, double distance,
           Vec2 size);

    double distance() const { return distance_; } ///< from the eyes to the image plane, mm
    Vec2 size() const { return size_; }           ///< of the pictures in the image plane, mm
    double pixel() const { return pixel_; }       ///< side of a picture's pixel, mm

    /// Moves the eyes' plane to that distance from the image plane, mm. Parallax stays, so that the
    /// scene's depth grows with the distance.
    void set_distance(double distance) { distance_ = distance; }

    /// Makes the scene `factor` times as large.
    void scale(double factor);
    /// Makes the scene so large that its pictures fit into a rectangle, mm; or fill it, with
    /// Fit::cover, or if the shapes hardly differ (FittedPicture).
    void scale_to(Vec2 rectangle, Fit how);

    /// Reduces maps whose pixels are less than half as wide or high as `spacing`, mm, of the lines
    /// of sight to come: retains one pixel in each rectangle of at most that size. Depths are not
    /// averaged: the mean of two depths is the depth of no surface.
    void thin(Vec2 spacing);

    /// The parallax of the nearest and farthest twentieth of all maps: nine tenths lie between.
    ParallaxSpan span() const;

    /// Moves all surfaces along the lines of sight from the middle of the eyes' plane: a parallax
    /// of 0 becomes `to.near`, 1 becomes `to.far`, and the others follow linearly, as in the relief
    /// of optics.md 8. The pictures' eyes move nearer to the middle as surfaces move farther apart.
    /// Throws std::invalid_argument if a picture has another eye and to.near is not less than
    /// to.far.
    void move(ParallaxSpan to);

    /// The same, so that span() becomes `to`.
    void fit(ParallaxSpan to);

    /// Reduces size() to the rectangle in the image plane, around the middle, that all pictures
    /// show.
    void crop_to_common();

    /// The light along a line. The line ends where it first meets the map of the nearest eye or, if
    /// it passes behind an edge there, another eye's map. The light comes from the pictures whose
    /// eyes are nearest to the line and, for an eye beyond them, see the line's end. If no map
    /// shows the end, the line is taken to end on the farther surface next to the edge.
    Seen along(const ReliefLine& line) const;

private:
    struct Meeting;
    Meeting meet(const ReliefMap& map, const ReliefLine& line) const;
    bool is_seen(const ReliefMap& map, double parallax, const ReliefLine& line) const;
    Colour light_at(const ReliefMap& map, double parallax, const ReliefLine& line) const;
    Colour light_beside(const ReliefMap& map, const Meeting& hidden, const ReliefLine& line) const;
    bool is_between_eyes(Vec2 eye) const;
    void update_extents();

    std::vector<ReliefPicture> pictures_;
    std::vector<ReliefMap> maps_;
    double distance_;
    Vec2 size_;
    double pixel_ = 1;
    Vec2 first_eye_, last_eye_;      ///< the rectangle of the pictures' eyes
    Vec2 spacing_{1, 1};             ///< greatest spacing of neighbouring eyes, > 0
    bool sparse_ = false; ///< surfaces move so far from eye to eye that one may hide what the next
                          ///< one sees
    float least_ = 0, greatest_ = 0; ///< parallax in all maps; a little more, so that it is met
};

/// Makes a relief from views before soften(), stored in `encoding`, and from parallax maps of some
/// of their eyes. `maps[k].picture` is 0 for the middle view and i + 1 for others[i]. The set must
/// have a scale.
Relief relief_of(const ViewSet& views, Encoding encoding, std::vector<ReliefMap> maps, Vec2 size,
                 int threads);

/// The eye of a view of a set, mm.
Vec2 eye_of(const ViewSet& views, const DepthView& view);

} // namespace integral

#endif
