// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes pictures and figures for the thesis's table 4-1 (doc/table-4-1.md). It renders a blue
// sphere 50 mm behind two sheets, with and without anti-aliasing and at three resolutions of film,
// and replays each frame from the aperture's centre, where the sphere's profile is measured, and
// from near its right edge, where an eye sees the borders of the micro-images.
//
// table_4_1 FOLDER [SCENES]       writes FOLDER/table-4-1.png and .md. SCENES is the folder of
//                                 sphere.pov (default: bench/scenes of this build's source).
#include "bench/renderer.h"
#include "bench/views.h"
#include "bench/pictures.h"
#include "bench/program.h"

#include "integral/base/constants.h"
#include "integral/compare/compare.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace {

namespace files = std::filesystem;
using namespace integral;
using namespace integral::bench;

// Pixels at 300 dpi: 59.9 x 45.0 mm, which is a whole number of pixels at 150 and 75 dpi, too.
constexpr int width = 708, height = 532;
// A view's pixel is 4 film pixels or 0.34 mm wide, so that a lens has 3.75 of them: enough to see
// single lenses in the profile. Its samples are half a pixel of the finest film apart.
constexpr ViewForm form{4, 4, 8};
constexpr double view_pixel = form.film_pixels * mm_per_inch / dots_per_inch;
constexpr double side = 0.45; // the side eye's distance from the centre, in aperture widths
// The position of a sphere's edge on lenses and pixels is arbitrary. Therefore the profile is the
// mean over spheres whose edges are 0.8 mm apart, a third of the width of a pixel's beam at 300 dpi
// (2.2 mm).
constexpr double radius = 24, radius_step = 0.8;
constexpr int spheres = 5;

struct Shot {
    std::string name, label; ///< in its file's name; above its picture
    int dpi;
    std::string words;                ///< for the integral camera in the scene
    std::vector<std::string> options; ///< for the renderer's command line
};

/// The sphere's profile in a view.
struct Profile {
    double jaggedness = 0; ///< mm: RMS distance of the outermost edge from the circle that fits it
                           ///< best
    double broken = 0;     ///< fraction of the radial lines that cross an edge more than once
};

struct Row {
    Shot shot;
    long long rays = 0;      ///< camera rays
    double rays_a_point = 0; ///< camera rays for each film point that the aperture sees
    Comparison to_perspective, from_side;
    std::optional<Profile> profile; ///< mean over all spheres
    std::optional<double> rmse;     ///< of the frame, compared with the converged one
    std::optional<double> lit_rmse; ///< the same over the pixels that are lit in the converged one
    Image centre_view, side_view;
};

const Shot light_field{"light-field", "300 dpi, +A", 300, "", {"+A0.05", "+R5", "+AM2"}};
const Shot prefilter{"prefilter", "300 dpi, display_prefilter", 300, "display_prefilter", {}};
const Shot one_ray[] = {{"one-300", "300 dpi, one ray", 300, "", {}},
                        {"one-150", "150 dpi, one ray", 150, "", {}},
                        {"one-75", "75 dpi, one ray", 75, "", {}}};
const Shot converged{"converged",
                     "300 dpi, converged",
                     300,
                     "pixel_samples 16 beam_samples 16",
                     {"Integral_Seed=20011"}};

Shot by_pixels_of(int depth, const std::string& threshold)
{
    return {
        "pixels",
        "300 dpi, +A by pixels",
        300,
        "",
        {"+A" + threshold, "+R" + std::to_string(depth), "+AM2", "Integral_Antialiasing=pixels"}};
}

/// The replayed view from an eye `right` aperture widths to the right of the aperture's centre.
Image view_of(const Frame& frame, double right)
{
    return view_of(frame, {right * frame.metadata->aperture.width, 0}, form).image;
}

/// The luma of a view in linear light, interpolated between its pixels. In linear light, a pixel
/// that an edge half covers has the mean luma of both sides.
class Luma {
public:
    explicit Luma(const Image& image) : image_(image), read_(image) {}
    /// `point`: mm from the centre, y downwards.
    double at(Vec2 point) const
    {
        const double x = std::clamp(0.5 * (image_.width - 1) + point.x / view_pixel, 0.0,
                                    image_.width - 1.001);
        const double y = std::clamp(0.5 * (image_.height - 1) + point.y / view_pixel, 0.0,
                                    image_.height - 1.001);
        const int i = int(x), j = int(y);
        const double right = x - i, down = y - j;
        return (1 - down) * ((1 - right) * pixel(i, j) + right * pixel(i + 1, j)) +
               down * ((1 - right) * pixel(i, j + 1) + right * pixel(i + 1, j + 1));
    }
    /// Half-way between the luma of the sphere at the centre and of the light wall in the corner.
    double middle() const
    {
        return 0.5 * (pixel(image_.width / 2, image_.height / 2) + pixel(0, 0));
    }
    /// The length of radial lines, mm.
    double reach() const { return (0.5 * image_.height - 1) * view_pixel; }

private:
    double pixel(int x, int y) const
    {
        const Colour c = read_(x, y);
        return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
    }
    const Image& image_;
    LinearReader read_;
};

/// Finds the sphere's edge along radial lines from its centre. `middle`: the luma at the edge.
Profile profile_of(const Image& view, double middle)
{
    constexpr int lines = 1440;
    constexpr double step = 0.02;
    const Luma luma(view);
    std::vector<double> radii;
    double mean = 0, right = 0, down = 0;
    Profile profile;
    for (int k = 0; k < lines; ++k) {
        const Vec2 along{std::cos(2 * pi * k / lines), std::sin(2 * pi * k / lines)};
        int crossings = 0;
        double outermost = 0, before = luma.at({0, 0}) - middle;
        for (double r = step; r <= luma.reach(); r += step) {
            const double here = luma.at(r * along) - middle;
            if ((here < 0) != (before < 0)) {
                ++crossings;
                outermost = r - step * here / (here - before);
            }
            before = here;
        }
        radii.push_back(outermost);
        profile.broken += double(crossings > 1) / lines;
        mean += outermost / lines;
        right += 2 * outermost * along.x / lines;
        down += 2 * outermost * along.y / lines;
    }
    // To first order, the circle nearest to the edge is r = mean + right cos + down sin.
    double squares = 0;
    for (int k = 0; k < lines; ++k) {
        const double angle = 2 * pi * k / lines;
        const double away = radii[k] - mean - right * std::cos(angle) - down * std::sin(angle);
        squares += away * away / lines;
    }
    profile.jaggedness = std::sqrt(squares);
    return profile;
}

/// RMSE over the pixels that are not black in the reference. Nothing in this scene is black; a
/// pixel is black if no lens shows it to the aperture.
double lit_rmse(const Image& image, const Image& reference)
{
    ColourDifferences differences;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Colour a = stored_pixel(image, x, y), b = stored_pixel(reference, x, y);
            if (b.r == 0 && b.g == 0 && b.b == 0)
                continue;
            differences.add(a, b);
        }
    return differences.rms();
}

/// One sheet's frames and views.
class Experiment {
public:
    Experiment(const Renderer& renderer, const Sheet& sheet) : renderer_(renderer), sheet_(sheet)
    {
        render(converged);
        converged_ = frame_of(converged);
        perspective_ = perspective(0);
        side_perspective_ = perspective(side * converged_.metadata->aperture.width);
        middle_ = Luma(perspective_).middle();
        Row flat{{"perspective", "perspective picture", 0, "", {}},
                 0,
                 0,
                 {},
                 {},
                 profile_of(perspective_, middle_),
                 {},
                 {},
                 perspective_,
                 side_perspective_};
        rows.push_back(flat);
        for (const Shot& shot : one_ray)
            points_[shot.dpi] = render(shot);
        const long long rays = render(light_field);
        add(light_field);
        add(prefilter);
        add(by_pixels_with(rays));
        for (const Shot& shot : one_ray)
            add(shot);
        add(converged);
    }

    std::string table() const;
    const std::string& title() const { return sheet_.title; }
    std::vector<Row> rows;

private:
    std::string file(const Shot& shot, int sphere) const
    {
        return sheet_.name + "-" + shot.name + (sphere > 0 ? "-" + std::to_string(sphere + 1) : "");
    }
    Frame frame_of(const Shot& shot, int sphere = 0) const
    {
        return read_frame_with_metadata(renderer_.picture(file(shot, sphere)));
    }

    /// The scene's perspective picture, with a view's pixels, from an eye `right` mm right of the
    /// aperture's centre.
    Image perspective(double right) const
    {
        return perspective_of(
                   renderer_, "sphere", sheet_.name + "-perspective", EyePosition{right, 0},
                   {"Declare=Sphere_Radius=" + std::to_string(radius)}, perspective_times, form)
            .image;
    }

    /// Renders the frame of one of the spheres. Returns the number of camera rays.
    long long render(const Shot& shot, int sphere = 0) const
    {
        // +W and +H change the number of pixels; Renderer has set the film's size in mm.
        std::vector<std::string> options{
            "+W" + std::to_string(width * shot.dpi / 300),
            "+H" + std::to_string(height * shot.dpi / 300), "Integral_Audit=off",
            "Declare=Sphere_Radius=" + std::to_string(radius - radius_step * sphere)};
        options.insert(options.end(), shot.options.begin(), shot.options.end());
        const std::string film = " film { dpi " + std::to_string(shot.dpi) + " } ";
        const std::string camera = "lens_sheet { " + sheet_.words() + " }" + film + shot.words;
        const RenderCost cost = renderer_.render("sphere", file(shot, sphere), camera, options);
        std::cerr << file(shot, sphere) << ": " << cost.camera_rays << " rays, " << cost.cpu_seconds
                  << " CPU seconds\n";
        return cost.camera_rays;
    }

    /// Returns the setting of POV-Ray's own anti-aliasing that takes the fewest camera rays, but at
    /// least `least`.
    Shot by_pixels_with(long long least) const
    {
        std::optional<Shot> best;
        long long fewest = 0;
        for (const int depth : {2, 3, 4, 5}) // thresholds in the order of growing numbers of rays
            for (const char* threshold : {"0.9", "0.5", "0.3", "0.2", "0.15", "0.1", "0.07", "0.05",
                                          "0.03", "0.02", "0.01", "0.0"}) {
                const Shot shot = by_pixels_of(depth, threshold);
                const long long rays = render(shot);
                if (rays < least)
                    continue;
                if (!best || rays < fewest)
                    best = shot, fewest = rays;
                break;
            }
        if (!best)
            throw std::runtime_error("no setting of POV-Ray's own anti-aliasing takes as many rays "
                                     "as +A in the light field");
        return *best;
    }

    void add(const Shot& shot)
    {
        // The reference gets no profile, which would take four more renders.
        const bool reference = shot.name == converged.name;
        Row row{shot, 0, 0, {}, {}, {}, {}, {}, {}, {}};
        row.rays = reference ? 256 * points_[300] : render(shot);
        row.rays_a_point = double(row.rays) / double(points_[shot.dpi]);
        const Frame frame = frame_of(shot);
        row.centre_view = view_of(frame, 0);
        row.side_view = view_of(frame, side);
        row.to_perspective = compare({row.centre_view, {}}, {perspective_, {}});
        row.from_side = compare({row.side_view, {}}, {side_perspective_, {}});
        if (shot.dpi == 300 && !reference) {
            row.rmse = compare(frame, converged_).rmse;
            row.lit_rmse = lit_rmse(frame.image, converged_.image);
        }
        if (!reference) {
            row.profile = Profile{};
            for (int sphere = 0; sphere < spheres; ++sphere) {
                if (sphere > 0)
                    render(shot, sphere);
                const Profile one = profile_of(view_of(frame_of(shot, sphere), 0), middle_);
                row.profile->jaggedness += one.jaggedness / spheres;
                row.profile->broken += one.broken / spheres;
            }
        }
        rows.push_back(row);
    }

    const Renderer& renderer_;
    Sheet sheet_;
    Frame converged_;
    Image perspective_, side_perspective_;
    double middle_ = 0;               ///< luma of the edge
    std::map<int, long long> points_; ///< by dpi: the number of film points that the aperture sees
};

std::string text(const char* format, double value)
{
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

std::string Experiment::table() const
{
    std::string
        out = "**" + sheet_.title +
              "**\n\n| frame | dpi | camera rays | a lit pixel | PSNR (dB) | SSIM | PSNR, side |"
              " SSIM, side | jaggedness (mm) | broken | RMSE | RMSE, lit |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const Row& row : rows) {
        std::string name = row.shot.words;
        for (const std::string& option : row.shot.options)
            name += (name.empty() ? "" : " ") + option;
        std::vector<std::string> cells{row.shot.dpi == 0 ? row.shot.label
                                       : name.empty()    ? "one ray"
                                                         : "`" + name + "`"};
        if (row.shot.dpi > 0)
            cells.insert(cells.end(),
                         {std::to_string(row.shot.dpi), std::to_string(row.rays),
                          text("%.2f", row.rays_a_point), text("%.2f", row.to_perspective.psnr),
                          text("%.4f", row.to_perspective.ssim), text("%.2f", row.from_side.psnr),
                          text("%.4f", row.from_side.ssim)});
        else
            cells.resize(8);
        cells.push_back(row.profile ? text("%.3f", row.profile->jaggedness) : "");
        cells.push_back(row.profile ? text("%.1f%%", 100 * row.profile->broken) : "");
        cells.push_back(row.rmse ? text("%.4f", *row.rmse) : "");
        cells.push_back(row.lit_rmse ? text("%.4f", *row.lit_rmse) : "");
        for (const std::string& cell : cells)
            out += "| " + cell + (cell.empty() ? "" : " ");
        out += "|\n";
    }
    return out + "\n";
}

/// Writes a picture of the views, cut to squares around the sphere and enlarged by two. Each sheet
/// has a row of views from the centre and a row from the side. The converged frame is left out.
void write_montage(const std::vector<Experiment>& sheets, const std::string& path)
{
    const Image& any = sheets[0].rows[0].centre_view;
    const int cut = any.height, over = any.width - any.height;
    LabelledPictures montage;
    for (const Row& row : sheets[0].rows)
        montage.columns.push_back(row.shot.label);
    montage.columns.pop_back();
    for (const Experiment& sheet : sheets)
        for (const bool aside : {false, true}) {
            montage.rows.push_back(sheet.title() + (aside ? ", side" : ", centre"));
            for (std::size_t i = 0; i < montage.columns.size(); ++i) {
                const Row& row = sheet.rows[i];
                montage.pictures.push_back(aside ? part_of(row.side_view, over, 0, cut, cut)
                                                 : part_of(row.centre_view, over / 2, 0, cut, cut));
            }
        }
    montage.write(path, 2);
}

void run(const files::path& folder, const files::path& scenes, const files::path& program)
{
    const std::string frames = (folder / "frames").string(),
                      picture = (folder / "table-4-1.png").string();
    const Renderer renderer{program.string(), scenes.string(), frames, width, height};
    if (!files::exists(renderer.program))
        throw InputError(renderer.program + ": there is no renderer here; build it (make)");
    if (!files::exists(scenes / "sphere.pov"))
        throw InputError((scenes / "sphere.pov").string() +
                         ": the scene is missing; name its folder after the output's");
    files::create_directories(frames);
    check_writable(picture);
    std::vector<Experiment> sheets;
    std::string tables;
    for (const char* arrangement : {"lenticular", "square"}) {
        const std::string name = arrangement;
        sheets.emplace_back(renderer, Sheet{name, "1.27 mm " + name, 1.27, 3.08, 1.6});
        tables += sheets.back().table();
    }
    write_montage(sheets, picture);
    write_file((folder / "table-4-1.md").string(), tables);
    std::cout << tables;
}

} // namespace

int main(int count, char** words)
{
    return status_of("table_4_1", [&] {
        if (count < 2 || count > 3 || !*words[1] || *words[1] == '-')
            throw UsageError("usage: table_4_1 FOLDER [SCENES]");
        const files::path scenes = count > 2 ? files::path(words[2])
                                             : own_folder() / "../../bench/scenes";
        run(words[1], scenes.lexically_normal(),
            (own_folder() / "../bin/povray-integral").lexically_normal());
        return 0;
    });
}
