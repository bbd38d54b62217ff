// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws what an eye sees of a scene through a lens sheet, from a probe: perspective pictures of the
// scene with depth (quilt_sampler.h). Each sample follows the eye's ray through the nearest lens to
// a film pixel, then this pixel's own sight line (optics.md 3), parallax map (optics.md 8) and the
// line in the probe. Continues sheet_optics.glsl.
//
// A line is parametrised by nearness nu = D0/r, r the distance from the scene's eye plane and D0 that
// of the probe's window. In the picture of a view, the line's image is then straight and of constant
// speed: for the sight line through P of the sheet and A' of the scene's eye plane (mm), and a view
// from e (the scene's own eye is 0), the image is at
//     q(nu) = P - A' (1 - nu D/D0) + (e/D0) d0 (1 - nu),
// in mm on a window as large as the film.

uniform vec2 eye; // mm
uniform bool without_sheet; // the eye's own ray in place of the film pixel's sight line
uniform float aperture_distance;
uniform vec2 aperture_half; // half width and half height, mm; 1e30: no limit
uniform bool elliptical;
uniform bool upright_slit; // the slit of a lenticular sheet lies along y

uniform float sheet_distance; // D, scene units
uniform float scene_distance; // d0, mm
uniform float parallax;       // K
uniform float tint;           // depth budget, mm; 0: no tint

const int max_views = 32;
uniform sampler2DArray colours;  // of the probe's views; linear light when read
uniform sampler2DArray nearness; // D0/r; 0: no surface
uniform int view_count;
uniform vec2 view_eyes[max_views]; // e/D0
uniform float probe_distance;      // D0, scene units
uniform vec2 window;               // the part of the film, around its middle, that shows the scene
uniform float max_nearness;        // of all views
uniform int max_steps;

const float unlimited = 1e30;

// The line that a film pixel shows.
struct SightLine {
    vec2 pole;     // its point on the sheet, mm
    vec2 aperture; // its point in the aperture plane, mm
};

// The sight line of a film point through a lens. `q`: vector from the film point to the pole, or to
// the foot of the film point on the axis. Returns false if the light is totally reflected or cannot
// reach the slit.
bool line_through(vec2 film_point, vec2 q, out SightLine line)
{
    float nd = sqrt(n_squared) * aperture_distance;
    float clear = thickness * thickness - m * dot(q, q);
    line.pole = film_point + q;
    line.aperture = line.pole;
    if (!(clear > 0.0))
        return false;
    if (arrangement != 0) {
        line.aperture += (nd / sqrt(clear)) * q;
        return true;
    }
    // The slit (slit.cpp): Newton's method within a bracket for the root of
    // H(tau) = alpha + g tau + n d (g tau + lateral)/S, S = sqrt(clear - m tau^2).
    vec2 normal = upright_slit ? vec2(1, 0) : vec2(0, 1);
    if (dot(normal, along) < 0.0)
        normal = -normal;
    float g = dot(normal, along), alpha = dot(normal, line.pole), lateral = dot(q, normal);
    float end = m > 0.0 ? sqrt(clear / m) : unlimited;
    if (!(abs(lateral) < g * end))
        return false;
    float low = -end, high = end, s = sqrt(clear);
    float tau = -(alpha * s + nd * lateral) / (g * (s + nd));
    for (int step = 0; step < 8; ++step) {
        if (!(tau > low && tau < high))
            tau = 0.5 * (low + high);
        float s2 = m > 0.0 ? m * (end - tau) * (end + tau) : clear;
        s = sqrt(s2);
        float h = alpha + g * tau + nd * (g * tau + lateral) / s;
        float slope = g + nd * (g * clear + m * lateral * tau) / (s2 * s);
        if (h < 0.0)
            low = tau;
        else
            high = tau;
        float change = h / slope;
        tau -= change;
        if (abs(change) <= 1e-6 * abs(tau))
            break;
    }
    tau = clamp(tau, -end, end);
    s = m > 0.0 ? sqrt(m * (end - tau) * (end + tau)) : sqrt(clear);
    if (!(s > 0.0))
        return false;
    line.pole += tau * along;
    line.aperture = line.pole + (nd / s) * (q + tau * along);
    // The component across the slit is known.
    if (upright_slit)
        line.aperture.x = 0.0;
    else
        line.aperture.y = 0.0;
    return true;
}

// Whether a point of the aperture plane is in the aperture or within rounding of its edge. Along a
// lenticular sheet's slit only.
bool in_aperture(vec2 point)
{
    const float inclusive = 1.0 + 1e-5;
    vec2 part = abs(point) / (aperture_half * inclusive);
    if (arrangement == 0)
        part = upright_slit ? vec2(0, part.y) : vec2(part.x, 0);
    return elliptical ? dot(part, part) <= 1.0 : max(part.x, part.y) <= 1.0;
}

// The vector from a film point to the point of the sheet through which it sees the aperture's centre
// (SheetOptics::pole_seeing_centre).
vec2 to_pole_seeing_centre(vec2 film_point)
{
    float radius = length(film_point), nd = sqrt(n_squared) * aperture_distance;
    if (radius == 0.0)
        return vec2(0);
    float p = radius * nd / (nd + thickness);
    for (int step = 0; step < 4; ++step) {
        float root = sqrt(nd * nd + m * p * p), ratio = nd / root;
        p += (radius - p - p * thickness / root) / (1.0 + thickness / root * ratio * ratio);
    }
    return (p / radius - 1.0) * film_point;
}

// The sight line of the film point at `offset` (mm) from a corner: through the nearest lens, or else
// the lens that sees the aperture (optics.md 4, `auto`). Returns false if no lens images the point.
bool sight_line(ViewCorner from, vec2 offset, out SightLine line)
{
    vec2 film_point = from.place + offset, place = vec2(0);
    bool imaged = false;
    // A loop, as some processors compute both sides of a branch.
    for (int search = 0; search < 2 && !imaged; ++search) {
        if (search == 1)
            place = to_pole_seeing_centre(film_point);
        imaged = line_through(film_point, place + to_nearest_pole(from, offset + place), line) && in_aperture(line.aperture);
    }
    return imaged;
}

// A view's image of a line: q(nu) in pixels of the probe from the upper left is from + nu speed.
struct LineImage {
    vec2 from, speed;
};

LineImage image_of(SightLine line, vec2 scene_eye, int view)
{
    vec2 probe = vec2(textureSize(nearness, 0).xy), film = vec2(film_size) * pixel_pitch;
    vec2 scale = vec2(probe.x, -probe.y) / film, side = view_eyes[view] * scene_distance;
    vec2 from = line.pole - scene_eye + side, speed = scene_eye * (sheet_distance / probe_distance) - side;
    return LineImage(scale * from + 0.5 * probe, scale * speed);
}

ivec2 inside_probe(ivec2 texel) { return clamp(texel, ivec2(0), textureSize(nearness, 0).xy - 1); }

float texel_nearness(int view, ivec2 texel) { return texelFetch(nearness, ivec3(inside_probe(texel), view), 0).r; }

float nearness_at(int view, vec2 q) { return texel_nearness(view, ivec2(floor(q))); }

bool is_outside(vec2 q)
{
    return any(lessThan(q, vec2(-0.5))) || any(greaterThan(q, vec2(textureSize(nearness, 0).xy) + 0.5));
}

// Bilinear weights of the four pixels around a point without those whose nearness differs from
// `about` by more than `margin`. Where all do, the nearest pixel counts.
struct Corners {
    ivec2 first;
    vec4 weights, nearness; // (0, 0), (1, 0), (0, 1), (1, 1)
};

Corners corners_of(int view, vec2 q, float about, float margin)
{
    vec2 place = q - 0.5, part = place - floor(place);
    Corners c;
    c.first = ivec2(floor(place));
    c.nearness = vec4(texel_nearness(view, c.first), texel_nearness(view, c.first + ivec2(1, 0)),
                      texel_nearness(view, c.first + ivec2(0, 1)), texel_nearness(view, c.first + ivec2(1, 1)));
    vec4 bilinear = vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(vec2(1.0 - part.y), vec2(part.y)) + 1e-6;
    c.weights = bilinear * vec4(lessThanEqual(abs(c.nearness - about), vec4(margin)));
    float total = dot(c.weights, vec4(1));
    vec2 nearest = step(0.5, part);
    c.weights = total > 0.0 ? c.weights / total
                            : vec4(1.0 - nearest.x, nearest.x, 1.0 - nearest.x, nearest.x) *
                                  vec4(vec2(1.0 - nearest.y), vec2(nearest.y));
    return c;
}

vec3 texel_colour(int view, ivec2 texel) { return texelFetch(colours, ivec3(inside_probe(texel), view), 0).rgb; }

vec3 colour_of(int view, Corners c)
{
    return c.weights.x * texel_colour(view, c.first) + c.weights.y * texel_colour(view, c.first + ivec2(1, 0)) +
           c.weights.z * texel_colour(view, c.first + ivec2(0, 1)) + c.weights.w * texel_colour(view, c.first + ivec2(1, 1));
}

// The view, not in `tried`, nearest to the eye `scene_eye` (in view_eyes' units) that sees the
// line's point at nu: inside its picture and not hidden; nu < 0: any. -1: none.
int view_seeing(SightLine line, vec2 scene_eye, vec2 units, float nu, int tried)
{
    int best = -1;
    float least = unlimited;
    for (int view = 0; view < view_count; ++view) {
        vec2 away = view_eyes[view] - units;
        float distance = dot(away, away);
        if (distance >= least || (tried >> view & 1) == 1)
            continue;
        if (nu >= 0.0) {
            LineImage image = image_of(line, scene_eye, view);
            vec2 q = image.from + nu * image.speed;
            if (is_outside(q) || nearness_at(view, q) > nu)
                continue;
        }
        least = distance;
        best = view;
    }
    return best;
}

// Surface of the probe.
struct Surface {
    vec3 colour;
    float nearness;
};

// A march along a line over the pixels of a view, from the greatest nearness down.
struct March {
    int view;
    LineImage image;
    vec2 pace;      // pixels per nearness across and down, not 0
    vec2 next;      // nearness at which the line leaves the pixel's column and row
    float cell;     // width of a step in pixels: 1, or more where the line is long
    float enter, leave; // nearness at which the line enters and leaves the pixel
};

void begin(inout March march, SightLine line, vec2 scene_eye, int view, float enter)
{
    march.view = view;
    march.image = image_of(line, scene_eye, view);
    vec2 speed = march.image.speed;
    march.pace = max(abs(speed), 1e-6);
    march.cell = max(1.0, (march.pace.x + march.pace.y) * max_nearness / float(max_steps));
    // The line goes against `speed`: to the pixel's lower border where speed is positive.
    vec2 place = (march.image.from + enter * speed) / march.cell, part = place - floor(place);
    vec2 way = vec2(speed.x > 0.0 ? part.x : 1.0 - part.x, speed.y > 0.0 ? part.y : 1.0 - part.y);
    march.next = enter - march.cell * way / march.pace;
    march.enter = enter;
    march.leave = max(max(march.next.x, march.next.y), 0.0);
}

void go_on(inout March march)
{
    if (march.next.x > march.next.y)
        march.next.x -= march.cell / march.pace.x;
    else
        march.next.y -= march.cell / march.pace.y;
    march.enter = march.leave;
    march.leave = clamp(max(march.next.x, march.next.y), 0.0, march.enter);
}

vec2 middle_of(March march) { return march.image.from + 0.5 * (march.enter + march.leave) * march.image.speed; }

// The surface nearest to the viewer along a line. A view is a height field over its picture. Where
// the line passes behind an edge it goes on in another view that sees it, or behind the edge until it
// emerges, or meets the background, which then has the colour next to the edge.
Surface surface_along(SightLine line, vec2 scene_eye)
{
    vec2 units = scene_eye * (sheet_distance / (scene_distance * probe_distance));
    int view = view_seeing(line, scene_eye, units, -1.0, 0), tried = 1 << view;
    March march;
    begin(march, line, scene_eye, view, max_nearness * 1.0001);
    vec2 q = middle_of(march);
    float surface = nearness_at(view, q), before = surface, rise = 0.0, slope = 0.0, margin = 0.0;
    vec2 edge = q; // the background's pixel next to the edge
    float edge_surface = surface, edge_enter = 0.0;
    int edge_view = view;
    bool behind = false;
    const int running = 0, reached = 1, met_hidden = 2, crossed = 3, ended = 4;
    int state = running;
    for (int steps = 0; state < met_hidden;) {
        state = running;
        margin = 1.5 * march.cell / max(march.pace.x, march.pace.y);
        while (state == running) {
            q = middle_of(march);
            before = surface;
            surface = nearness_at(march.view, q);
            rise = surface - before;
            if (behind && rise < -margin && surface > march.enter && surface < edge_enter) {
                state = met_hidden;
            } else {
                behind = behind && surface > march.enter;
                if (!behind && surface >= march.leave) {
                    state = reached;
                } else if (march.leave <= 0.0 || ++steps >= 3 * max_steps) {
                    state = ended;
                } else {
                    slope = rise;
                    go_on(march);
                }
            }
        }
        if (state == reached) {
            vec2 next_q = march.image.from + (1.5 * march.leave - 0.5 * march.enter) * march.image.speed;
            float next_rise = nearness_at(march.view, next_q) - surface;
            bool passes_behind = surface > march.enter && min(abs(rise - slope), abs(rise - next_rise)) > margin;
            int other = passes_behind || is_outside(q) ? view_seeing(line, scene_eye, units, march.enter, tried) : -1;
            if (other >= 0) {
                tried |= 1 << other;
                begin(march, line, scene_eye, other, march.enter);
                surface = nearness_at(other, middle_of(march));
                slope = 0.0;
            } else if (!passes_behind) {
                state = crossed;
            } else {
                behind = true;
                edge = q + sign(march.image.speed) * min(vec2(1), march.pace / max(march.pace.x, march.pace.y));
                edge_surface = before;
                edge_enter = march.enter;
                edge_view = march.view;
                if (march.leave <= 0.0)
                    state = ended;
                slope = rise;
                go_on(march);
            }
        }
    }

    float about = surface, nu = clamp(surface, march.leave, march.enter);
    int turns = 2;
    if (state == met_hidden) {
        // The nearer place next to the hidden part.
        turns = 0;
        vec2 hidden = march.image.from + surface * march.image.speed;
        if (length(hidden - edge) < length(hidden - q)) {
            q = edge;
            about = edge_surface;
        }
    } else if (state == ended) {
        // The line never emerged: the background next to the edge behind which it passed.
        turns = 0;
        q = edge;
        about = nu = edge_surface;
        march.view = edge_view;
    }
    // Where the line crosses the surface in or next to the pixel.
    float low = march.leave - margin, high = march.enter + margin, jump = max(margin, 0.03 * about);
    Corners c;
    for (int turn = 0; turn <= turns; ++turn) {
        if (turns > 0)
            q = march.image.from + nu * march.image.speed;
        c = corners_of(march.view, q, about, jump);
        if (turn < turns)
            nu = clamp(dot(c.weights, c.nearness), low, high);
    }
    return Surface(colour_of(march.view, c), nu);
}

// The tints of depth_picture.cpp, and a pattern: soft is dotted, beyond is striped.
vec3 tinted(Surface surface)
{
    float omega = surface.nearness * sheet_distance / probe_distance;
    float lift = 1.0 - parallax * (1.0 - omega);
    float depth = lift > 0.0 ? parallax * aperture_distance * (1.0 - omega) / lift : unlimited;
    float grey = min(1.0, dot(surface.colour, vec3(0.2126, 0.7152, 0.0722)));
    vec3 colour = vec3(0.25, 0.55, 1.0);
    ivec2 at = ivec2(gl_FragCoord.xy);
    float mark = 1.0;
    if (abs(depth) > 2.0 * tint) {
        colour = vec3(0.9, 0.15, 0.1);
        mark = (at.x + at.y) % 10 < 3 ? 0.5 : 1.0;
    } else if (abs(depth) > tint) {
        colour = vec3(1.0, 0.75, 0.1);
        mark = at.x % 8 < 2 && at.y % 8 < 2 ? 0.4 : 1.0;
    }
    return (mark * (0.15 + 0.85 * grey)) * colour;
}

vec3 light_along(SightLine line)
{
    // As FittedPicture::is_in_bar: no bars along a side that the picture fills.
    vec2 edge = mix(vec2(unlimited), 0.5 * window * vec2(film_size) * pixel_pitch, lessThan(window, vec2(1)));
    if (any(greaterThan(abs(line.pole), edge)))
        return vec3(0);
    Surface surface = surface_along(line, parallax * line.aperture);
    return tint > 0.0 ? tinted(surface) : surface.colour;
}

// The light of the film pixel whose left upper corner is `pixel` from a corner of the view.
// `stripe`: offset of the colour's stripe from the pixel's centre, in pixels.
vec3 light_of_pixel(ViewCorner at, vec2 pixel, float stripe)
{
    vec2 centre = pixel + vec2(0.5 + stripe, 0.5);
    SightLine line;
    if (!sight_line(at, vec2(1, -1) * pixel_pitch * (centre - at.film_part), line))
        return vec3(0);
    return light_along(line);
}

vec3 seen(ivec2 view, vec2 inside)
{
    ViewCorner at = view_corner(view);
    vec2 moved = vec2(inside.x, -inside.y) * view_pixel;
    vec2 to_eye = eye - at.place - moved;
    vec2 film_step = moved;
    if (!without_sheet)
        film_step += film_point_seen(to_nearest_pole(at, moved), to_eye);
    vec2 pixel = at.film_part + vec2(film_step.x, -film_step.y) / pixel_pitch;
    vec2 place = at.film_whole + floor(pixel);
    if (any(lessThan(place, vec2(0))) || any(greaterThanEqual(place, vec2(film_size))))
        return vec3(0);
    if (without_sheet)
        return light_along(SightLine(at.place + moved, at.place + moved + (aperture_distance / eye_distance) * to_eye));
    if (subpixels == 0)
        return light_of_pixel(at, floor(pixel), 0.0);
    float shift = subpixels == 1 ? 1.0 / 3.0 : -1.0 / 3.0; // of blue's stripe; red's is the opposite
    vec3 light;
    for (int channel = 0; channel < 3; ++channel) {
        float stripe = float(channel - 1) * shift;
        light[channel] = light_of_pixel(at, vec2(floor(pixel.x - stripe), floor(pixel.y)), stripe)[channel];
    }
    return light;
}

void main()
{
    ivec2 view = drawn_pixel();
    vec3 total = vec3(0);
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i)
            total += seen(view, (vec2(i, j) + 0.5) / float(samples));
    shown = encoded(total / float(samples * samples));
}
