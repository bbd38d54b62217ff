// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the points of a calibration page where four squares meet, and the camera that shows them.
#ifndef INTEGRAL_ANALYSIS_PAGE_CORNERS_H
#define INTEGRAL_ANALYSIS_PAGE_CORNERS_H

#include "integral/analysis/edge_response.h"
#include "integral/analysis/photo_camera.h"

#include <array>
#include <optional>
#include <vector>

namespace integral {

/// A point of the print, and the photo point that shows it.
struct PageCorner {
    Vec2 page, photo;
};

/// The photo point near `start` where black and white squares meet, to a few hundredths of a pixel:
/// the point from which all edges within `reach` pixels radiate. Nothing if there is none.
std::optional<Vec2> corner_near(const Plane& photo, Vec2 start, double reach);

/// Number of the camera's parameters in a fit.
constexpr std::size_t camera_parameters = 13;

/// Steps of the camera's parameters for derivatives.
std::vector<double> camera_steps();

/// The camera after a change by these parameters: rotation (3, radians), place (3, mm), logarithm
/// of the focal length, principal point (2, photo widths), k1, k2 and tangential distortion (2).
PhotoCamera changed(const PhotoCamera& camera, const double* parameters, double width);

/// Differences from the usual phone's camera, in standard deviations: focal length, principal point
/// (2), k1, k2 and tangential distortion (2). `size`: of the photo, pixels.
std::array<double, 7> unusual(const PhotoCamera& camera, Vec2 size);

struct PageView {
    PhotoCamera camera;
    std::vector<PageCorner> corners;
};

/// Finds the corners, beginning near the targets, and refines the camera as it goes on. `targets`
/// and `corners`: places on the page, mm. Corners that do not lie where the camera sees the others
/// are left out. Throws std::invalid_argument, with advice, if less than half remain.
PageView find_page(const Plane& photo, const std::array<Vec2, 4>& targets,
                   const std::vector<Vec2>& corners);

} // namespace integral

#endif
