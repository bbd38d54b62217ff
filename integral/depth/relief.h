// SPDX-License-Identifier: AGPL-3.0-or-later
// A scene reconstructed from views and their depth. It gives the light along any line of sight and
// takes account of what hides what.
//
// Depth is measured here as parallax: z / (distance + z) for a point z mm behind the image plane.
// When the eye moves sideways, the point's picture moves by that part of the eye's step. It is 0 in
// the plane and 1 endlessly far away. The pixels of a view along a line of sight are linear in it.
#ifndef INTEGRAL_DEPTH_RELIEF_H
#define INTEGRAL_DEPTH_RELIEF_H

#include "integral/depth/view_set.h"

#include <vector>

namespace integral {

/// A picture that an eye takes, in linear light; row by row from the top left.
struct ReliefPicture {
    Vec2 eye; ///< on the eyes' plane, mm
    int width = 0, height = 0;
    PixelPlaces places; ///< mm
    ColourPlanes light;
    std::vector<float> lit; ///< 1, or 0 for a pixel without light; empty: all have some
};

/// What an eye knows of depth, and its picture.
struct ReliefMap {
    Vec2 eye; ///< on the eyes' plane, mm
    int width = 0, height = 0;
    PixelPlaces places;          ///< mm
    std::vector<float> parallax; ///< NaN: nothing is known there
    std::size_t picture = 0;     ///< of the same eye, among Relief's
};

/// A line of sight: where it meets the image plane and the plane of the eyes, mm.
struct ReliefLine {
    Vec2 place, eye;
};

/// What is seen along a line: linear light, and whether any view has seen it; else it is what its
/// surroundings farther off look like.
struct Seen {
    Colour light;
    bool known = false;
};

class Relief {
public:
    /// 1 to 32 maps. Throws std::invalid_argument if they know nothing.
    Relief(std::vector<ReliefPicture> pictures, std::vector<ReliefMap> maps, double distance,
           Vec2 size);

    double distance() const { return distance_; } ///< from the eyes to the image plane, mm
    Vec2 size() const { return size_; }           ///< of the pictures in the image plane, mm
    double pixel() const { return pixel_; }       ///< side of a picture's pixel, mm

    /// The same scene, `factor` times as large.
    void scale(double factor);

    /// What is seen along a line. The depth is where the line first meets the map of the eye
    /// nearest to it, or if it passes there behind an edge, another eye's. The light is that of the
    /// pictures whose eyes are nearest to the line and see its end. Where no map shows the end of
    /// the line, it is what lies farther off beside the edge.
    Seen along(const ReliefLine& line) const;

private:
    struct Meeting;
    Meeting meet(const ReliefMap& map, const ReliefLine& line) const;
    bool is_seen(const ReliefMap& map, double parallax, const ReliefLine& line) const;
    Colour light_at(const ReliefMap& map, double parallax, const ReliefLine& line) const;
    Colour light_beside(const ReliefMap& map, const Meeting& hidden, const ReliefLine& line) const;
    bool is_between_eyes(Vec2 eye) const;

    std::vector<ReliefPicture> pictures_;
    std::vector<ReliefMap> maps_;
    double distance_;
    Vec2 size_;
    double pixel_ = 1;
    Vec2 first_eye_, last_eye_;      ///< the rectangle of the pictures' eyes
    Vec2 spacing_{1, 1};             ///< of these, > 0
    float least_ = 0, greatest_ = 0; ///< parallax in all maps
};

/// What a relief is made of: the views, unsoftened, whose light is encoded so, and the parallax
/// that each of some eyes sees. `maps[k].picture` counts the middle view as 0 and others[i] as i +
/// 1. The set must have a scale.
Relief relief_of(const ViewSet& views, Encoding encoding, std::vector<ReliefMap> maps, Vec2 size,
                 int threads);

/// Where a view of a set was taken from, mm.
Vec2 eye_of(const ViewSet& views, const DepthView& view);

} // namespace integral

#endif
