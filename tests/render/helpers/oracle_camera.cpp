// SPDX-License-Identifier: AGPL-3.0-or-later
#include "oracle.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace oracle {
namespace {

Point3 cross(Point3 a, Point3 b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real dot(Point3 a, Point3 b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Real length(Point3 a) { return std::sqrt(dot(a, a)); }
Point3 times(Point3 a, Real s) { return {a[0] * s, a[1] * s, a[2] * s}; }

/// "1", "1,2" or "1,2,3".
std::vector<Real> numbers(const std::string& key, const std::string& text)
{
    std::vector<Real> result;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        std::size_t used = 0;
        result.push_back(std::stold(word, &used));
        if (used != word.size())
            throw std::invalid_argument(key + ": not a number: " + word);
    }
    return result;
}

/// Applies POV-Ray's transform `kind value` to a point, or to a direction, which `translate` does
/// not change. Rotations are about x, then y, then z.
Point3 transformed(const Description::Transform& t, Point3 p, bool direction)
{
    if (t.kind == "translate")
        return direction ? p : Point3{p[0] + t.value[0], p[1] + t.value[1], p[2] + t.value[2]};
    if (t.kind == "scale")
        return {p[0] * t.value[0], p[1] * t.value[1], p[2] * t.value[2]};
    for (int axis = 0; axis < 3; axis++) {
        const Real angle = t.value[axis] * std::acos(-1.0L) / 180, c = std::cos(angle),
                   s = std::sin(angle);
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        const Real u = p[i] * c - p[j] * s, v = p[i] * s + p[j] * c;
        p[i] = u, p[j] = v;
    }
    return p;
}

std::string vector_text(const Point3& v)
{
    std::ostringstream out;
    out.precision(17);
    out << '<' << v[0] << ", " << v[1] << ", " << v[2] << '>';
    return out.str();
}

} // namespace

Description read_description(const std::vector<std::string>& words)
{
    Description d;
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos)
            throw std::invalid_argument("not key=value: " + word);
        const std::string key = word.substr(0, equals), text = word.substr(equals + 1);
        if (key == "arrangement") {
            d.arrangement = text;
            continue;
        }
        if (key == "mapping") {
            d.mapping = text;
            continue;
        }
        if (key == "shape") {
            d.shape = text;
            continue;
        }
        if (key == "model") {
            d.model = text;
            continue;
        }
        if (key == "subpixels") {
            d.subpixels = text;
            continue;
        }
        if (key == "pattern") {
            d.pattern = text;
            continue;
        }
        if (key == "groups") {
            d.groups = text;
            continue;
        }
        if (key == "size") {
            char x = 0;
            std::istringstream(text) >> d.width >> x >> d.height;
            continue;
        }
        const std::vector<Real> n = numbers(key, text);
        if (key == "places") {
            for (std::size_t k = 0; k + 1 < n.size(); k += 2)
                d.places.push_back({n[k], n[k + 1]});
            continue;
        }
        const auto scalar = [&] {
            if (n.size() != 1)
                throw std::invalid_argument(word);
            return n[0];
        };
        const auto pair = [&] { return Point2{n[0], n.size() > 1 ? n.at(1) : n[0]}; };
        const auto triple = [&] { return Point3{n.at(0), n.at(1), n.at(2)}; };
        if (key == "pitch")
            d.pitch = scalar();
        else if (key == "thickness")
            d.thickness = scalar();
        else if (key == "ior")
            d.ior = scalar();
        else if (key == "slant")
            d.slant = scalar();
        else if (key == "offset")
            d.offset = pair();
        else if (key == "dpi")
            d.dpi = pair();
        else if (key == "pixel_pitch")
            d.pixel_pitch = pair();
        else if (key == "aperture")
            d.aperture = pair();
        else if (key == "depth_range")
            d.depth_range = pair();
        else if (key == "sheet_distance")
            d.sheet_distance = scalar();
        else if (key == "viewing_distance")
            d.viewing_distance = scalar();
        else if (key == "parallax")
            d.parallax = scalar();
        else if (key == "move_eye")
            d.move_eye = scalar() != 0;
        else if (key == "units_per_mm")
            d.units_per_mm = scalar();
        else if (key == "beam_samples")
            d.beam_samples = int(scalar());
        else if (key == "pixel_samples")
            d.pixel_samples = int(scalar());
        else if (key == "display_prefilter")
            d.display_prefilter = scalar() != 0;
        else if (key == "pseudoscopic")
            d.pseudoscopic = scalar() != 0;
        else if (key == "start")
            d.start = scalar();
        else if (key == "channel")
            d.channel = int(scalar());
        else if (key == "marginal")
            d.marginal = int(scalar());
        else if (key == "group")
            d.group = int(scalar());
        else if (key == "angle")
            d.angle = scalar();
        else if (key == "look_at")
            d.look_at = triple();
        else if (key == "location")
            d.location = triple();
        else if (key == "direction")
            d.direction = triple();
        else if (key == "right")
            d.right = triple();
        else if (key == "up")
            d.up = triple();
        else if (key == "sky")
            d.sky = triple();
        else if (key == "rotate" || key == "scale" || key == "translate")
            d.transforms.push_back({key, triple()});
        else
            throw std::invalid_argument("unknown key: " + key);
    }
    return d;
}

namespace {

/// The part of the text that both cameras share: the view, with the transforms last.
std::string view_text(const Description& d)
{
    std::ostringstream out;
    out.precision(17);
    out << "  location " << vector_text(d.location) << " direction " << vector_text(d.direction)
        << "\n  right " << vector_text(d.right) << " up " << vector_text(d.up) << " sky "
        << vector_text(d.sky) << '\n';
    if (d.angle)
        out << "  angle " << *d.angle << '\n';
    if (d.look_at)
        out << "  look_at " << vector_text(*d.look_at) << '\n';
    for (const auto& t : d.transforms)
        out << "  " << t.kind << ' ' << vector_text(t.value) << '\n';
    return out.str();
}

} // namespace

std::string perspective_text(const Description& d) { return "camera {\n" + view_text(d) + "}\n"; }

std::string camera_text(const Description& d)
{
    std::ostringstream out;
    out.precision(17);
    out << "camera {\n  integral\n  lens_sheet { " << d.arrangement << " pitch " << d.pitch
        << " thickness " << d.thickness << " ior " << d.ior;
    if (d.slant != 0)
        out << " slant " << d.slant;
    if (d.offset != Point2{0, 0})
        out << " offset <" << d.offset[0] << ", " << d.offset[1] << ">";
    out << " }\n  film { ";
    if (d.pixel_pitch)
        out << "pixel_pitch <" << (*d.pixel_pitch)[0] << ", " << (*d.pixel_pitch)[1] << ">";
    else
        out << "dpi <" << d.dpi[0] << ", " << d.dpi[1] << ">";
    if (d.units_per_mm)
        out << " units_per_mm " << *d.units_per_mm;
    if (d.subpixels != "none")
        out << " subpixels " << d.subpixels;
    if (d.subpixels == "cells") {
        out << " { " << d.pattern;
        for (const Point2& place : d.places)
            out << " <" << place[0] << ", " << place[1] << ">";
        out << " }";
    }
    out << " }\n";
    if (d.sheet_distance)
        out << "  sheet_distance " << *d.sheet_distance << '\n';
    if (d.viewing_distance)
        out << "  viewing_distance " << *d.viewing_distance << '\n';
    if (d.parallax)
        out << "  parallax " << *d.parallax << '\n';
    if (d.move_eye)
        out << "  move_eye\n";
    if (d.aperture)
        out << "  capture_aperture <" << (*d.aperture)[0] << ", " << (*d.aperture)[1] << ">\n";
    if (d.depth_range)
        out << "  depth_range <" << (*d.depth_range)[0] << ", " << (*d.depth_range)[1] << ">\n";
    if (d.shape != "rectangle")
        out << "  aperture_shape " << d.shape << '\n';
    if (d.model != "extended_pinhole")
        out << "  lens_model " << d.model << '\n';
    if (d.beam_samples > 0)
        out << "  beam_samples " << d.beam_samples << '\n';
    if (d.pixel_samples > 1)
        out << "  pixel_samples " << d.pixel_samples << '\n';
    if (d.display_prefilter)
        out << "  display_prefilter\n";
    if (d.pseudoscopic)
        out << "  pseudoscopic\n";
    if (d.mapping != "auto")
        out << "  lens_mapping " << d.mapping << '\n';
    out << view_text(d) << "}\n";
    return out.str();
}

/// POV-Ray's own order: right, direction, angle, up, sky, location, look_at, then the transforms.
Placed place(const Description& d)
{
    Point3 direction = d.direction, right = d.right, up = d.up, location = d.location;
    if (d.angle)
        direction = times(direction, length(right) / std::tan(*d.angle * std::acos(-1.0L) / 360) /
                                         2 / length(direction));
    Real distance = length(direction); // of the sheet, in scene units
    if (d.look_at) {
        const bool ordinary = dot(cross(up, direction), right) > 0;
        const Real direction_length = length(direction), right_length = length(right),
                   up_length = length(up);
        Point3 axis{(*d.look_at)[0] - location[0], (*d.look_at)[1] - location[1],
                    (*d.look_at)[2] - location[2]};
        distance = length(axis);
        axis = times(axis, 1 / distance);
        Point3 side = cross(d.sky, axis);
        side = times(side, 1 / length(side));
        up = times(cross(axis, side), up_length);
        right = times(side, ordinary ? right_length : -right_length);
        direction = times(axis, direction_length);
    }
    if (d.sheet_distance)
        distance = *d.sheet_distance;
    const Real ratio = distance / length(direction);
    for (const auto& t : d.transforms) {
        location = transformed(t, location, false);
        direction = transformed(t, direction, true);
        right = transformed(t, right, true);
        up = transformed(t, up, true);
    }
    distance = ratio * length(direction);
    const Real window = distance * length(right) / length(direction);
    const Real film_width = film_from_pixel(d, d.width, 0)[0] - film_from_pixel(d, 0, 0)[0];
    const Real k = d.units_per_mm ? *d.units_per_mm : window / film_width;
    if (d.move_eye) { // along the axis; the sheet's centre does not move
        const Real moved = (distance - *d.viewing_distance * k) / length(direction);
        for (int i = 0; i < 3; ++i)
            location[i] += moved * direction[i];
        distance = *d.viewing_distance * k;
    }
    const Real scene = distance / k, viewed = d.viewing_distance ? *d.viewing_distance : scene;
    const Real parallax = d.parallax ? *d.parallax : scene / viewed;
    return {location, times(right, k / length(right)), times(up, k / length(up)),
            times(direction, k / length(direction)), viewed, scene, parallax};
}

SheetRay in_scene(const Placed& placed, SheetRay ray)
{
    Point3 way{0, 0, placed.scene_distance};
    for (int i = 0; i < 2; ++i) {
        const Real on_sheet = ray.aperture_point[i] +
                              ray.direction[i] * placed.distance / ray.direction[2];
        ray.aperture_point[i] *= placed.parallax;
        way[i] = on_sheet - ray.aperture_point[i];
    }
    ray.direction = times(way, 1 / length(way));
    return ray;
}

} // namespace oracle
