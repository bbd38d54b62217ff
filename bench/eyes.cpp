// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares replayed views from 25 eyes in the viewing zone with the perspective pictures that the
// unmodified POV-Ray renders from the same places, and with two limits that lenses and pixels set
// (doc/eyes.md). The eyes are 5 x 5 for square lenses, and 25 in a row at the height of the
// aperture's centre for a lenticular sheet, which shows no vertical parallax.
//
// The integral camera renders neither limit. Both are made of perspective pictures by the
// unmodified POV-Ray, then replayed and compared as frames are:
//   "sheet and film": the best possible render. A dense array of perspective cameras fills the
//     aperture. Each of their rays meets a lens, which images it on a film pixel; each pixel is the
//     mean of its rays, that is the mean over its area and its lens's cell. This limit has the
//     losses due to lens pitch and to the angle that a pixel covers, but no sampling errors.
//   "lenses alone": a frame for each eye, from that eye's perspective picture only. Each part of
//     the sheet that the eye sees in one colour has the mean colour of that part of the picture. No
//     frame of this sheet and film shows that eye more. (Some tenths of a decibel are possible,
//     because means are taken in linear light and PSNR of encoded values.) No single frame shows as
//     much to all eyes.
#include "bench/camera_array.h"
#include "bench/pictures.h"
#include "bench/program.h"

#include "integral/compare/compare.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

namespace options = boost::program_options;
namespace files = std::filesystem;
using namespace integral;
using namespace integral::bench;

/// One way to make a frame, and how well the eyes see the scene through it.
struct Seen {
    std::string name, title; ///< in eyes.csv; in eyes.md
    std::vector<ViewFigures> from_eyes;
    std::optional<double> rmse; ///< of the frame, compared with "sheet and film", over lit pixels
    int own = 0; ///< number of eyes whose view is most similar to their own perspective picture
    double farthest = 0; ///< mm: among the other eyes, the greatest distance to the eye whose
                         ///< perspective picture is most similar
};

struct Panel {
    std::string scene;
    Sheet sheet;
    int columns = 0; ///< of the eyes
    std::vector<EyePosition> eyes;
    std::vector<Seen> all;                ///< the settings, then the two limits
    double missing = 0, rays_a_pixel = 0; ///< of "sheet and film"
};

const Setting settings[] = {{"one-ray", "", {}},
                            {"antialiased", "", {"+A0.05", "+R5", "+AM2"}},
                            {"converged", "pixel_samples 8 beam_samples 8", {}}};
constexpr int antialiased = 1;
// The zone's lowest eyes are at -28 mm. An eye below a scene's floor would see only its underside.
const std::string floor_below_all_eyes = "Declare=Floor=-40";

/// Scope of a run: its scenes, frames, eyes and cameras.
struct Plan {
    std::vector<std::string> scenes;
    int width, height;           ///< pixels of the frames
    int eyes_across;             ///< there are eyes_across x eyes_across eyes
    int square_array, row_array; ///< cameras across the aperture, for either kind of sheet
    std::string pictured_scene, pictured_sheet; ///< shown in eyes.png
};
const Plan whole{{"matte", "detail", "glass"}, 240, 160, 5, 32, 48, "matte", "square"};
const Plan quick{{"matte"}, 120, 80, 3, 16, 32, "matte", "square"};

/// A scene behind a sheet.
class Experiment {
public:
    Experiment(const Renderer& integral, const Renderer& pristine, const Plan& plan,
               const std::string& scene, const Sheet& sheet)
        : integral_(integral), pristine_(pristine), plan_(plan)
    {
        panel.scene = scene;
        panel.sheet = sheet;
    }
    void run();
    void write_picture(const std::string& path) const;
    Panel panel;

private:
    CameraArray array(int across, double part, int times, int divided) const
    {
        const Aperture& aperture = frames_[0].metadata->aperture;
        const bool row = shows_a_row(frames_[0]);
        return {row && times == perspective_times ? across * across : across,
                row ? 1 : across,
                part * aperture.width,
                row ? 0 : part * aperture.height,
                plan_.width * times / divided,
                plan_.height * times / divided};
    }
    void take_perspectives();
    void gather();
    Seen seen_of(const std::string& name, const std::string& title, const Frame& frame) const;

    const Renderer &integral_, &pristine_;
    const Plan& plan_;
    std::vector<Frame> frames_; ///< one for each of `settings`
    Frame ideal_;
    std::vector<Frame> perspectives_;
    std::vector<Image> fine_; ///< the perspective pictures as rendered
    Seen lenses_{"lenses-alone", "limit: lenses alone, best for each eye", {}, {}, 0, 0};
};

void Experiment::take_perspectives()
{
    const CameraArray cameras = array(plan_.eyes_across, zone, perspective_times, 1);
    panel.eyes = eyes_of(frames_[0], plan_.eyes_across);
    panel.columns = cameras.columns;
    fine_.resize(panel.eyes.size());
    render(pristine_, panel.scene, {floor_below_all_eyes}, cameras,
           [&](const Image& picture, int k) { fine_[k] = picture; });
    for (std::size_t k = 0; k < fine_.size(); ++k) {
        perspectives_.push_back(
            inner_part(shrunk(fine_[k], perspective_times * usual_form.film_pixels), usual_form));
        GatheredFrame best(frames_[0]);
        best.add(fine_[k], panel.eyes[k]);
        lenses_.from_eyes.push_back(
            view_figures(view_of(best.frame(), panel.eyes[k], usual_form), perspectives_[k]));
    }
}

/// For square lenses, neighbouring rays of a picture are 2 film pixels apart, so that each lens has
/// several. For a lenticular sheet they are half a pixel apart, because rays reach only the film
/// row at their own height.
void Experiment::gather()
{
    const bool row = shows_a_row(frames_[0]);
    const CameraArray cameras = array(row ? plan_.row_array : plan_.square_array, 1, row ? 2 : 1,
                                      row ? 1 : 2);
    const std::vector<EyePosition> eyes = cameras.eyes();
    GatheredFrame film(frames_[0]);
    render(pristine_, panel.scene, {floor_below_all_eyes}, cameras,
           [&](const Image& picture, int k) { film.add(picture, eyes[k]); });
    ideal_ = film.frame();
    panel.missing = film.missing();
    panel.rays_a_pixel = film.rays_a_pixel();
}

Seen Experiment::seen_of(const std::string& name, const std::string& title,
                         const Frame& frame) const
{
    Seen seen{name, title, {}, {}, 0, 0};
    for (std::size_t k = 0; k < panel.eyes.size(); ++k) {
        const Frame view = view_of(frame, panel.eyes[k], usual_form);
        seen.from_eyes.push_back(view_figures(view, perspectives_[k]));
        std::size_t nearest = k;
        double best = seen.from_eyes[k].psnr;
        for (std::size_t j = 0; j < panel.eyes.size(); ++j) {
            const double psnr = compare(view, perspectives_[j]).psnr;
            if (psnr > best)
                best = psnr, nearest = j;
        }
        const EyePosition here = panel.eyes[k], there = panel.eyes[nearest];
        seen.own += nearest == k;
        seen.farthest = std::max(seen.farthest, std::hypot(there.x - here.x, there.y - here.y));
    }
    return seen;
}

void Experiment::run()
{
    for (const Setting& setting : settings) {
        const std::string name = panel.scene + "-" + panel.sheet.name + "-" + setting.name;
        std::vector<std::string> words = setting.options;
        words.insert(words.end(), {"Integral_Audit=off", floor_below_all_eyes});
        integral_.render(panel.scene, name, camera_words(panel.sheet, setting), words);
        frames_.push_back(read_frame_with_metadata(integral_.picture(name)));
    }
    take_perspectives();
    gather();
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        const std::string words = settings[i].full_name();
        panel.all.push_back(
            seen_of(settings[i].name, words.empty() ? "one ray" : "`" + words + "`", frames_[i]));
        panel.all.back().rmse = lit_rmse(frames_[i], ideal_);
    }
    panel.all.push_back(seen_of("sheet-and-film", "limit: sheet and film", ideal_));
    panel.all.push_back(lenses_);
}

/// Draws the left, middle and right eyes' perspective pictures, views and their differences. Each
/// pixel covers 2 x 2 film pixels.
void Experiment::write_picture(const std::string& path) const
{
    constexpr ViewForm form{2, 7, perspective_times};
    constexpr double gain = 3;
    const std::size_t count = panel.eyes.size(), middle = count / 2;
    LabelledPictures table;
    table.columns = {"perspective picture", "view of the frame, +A", "difference x 3",
                     "view of sheet and film's limit"};
    const char* names[] = {"top left eye", "centre", "bottom right eye"};
    int name = 0;
    for (const std::size_t k : {std::size_t(0), middle, count - 1}) {
        const Frame picture = inner_part(shrunk(fine_[k], perspective_times * form.film_pixels),
                                         form);
        const Frame view = view_of(frames_[antialiased], panel.eyes[k], form);
        table.rows.push_back(names[name++]);
        for (const Image& image :
             {picture.image, view.image, difference_picture(view.image, picture.image, gain),
              view_of(ideal_, panel.eyes[k], form).image})
            table.pictures.push_back(image);
    }
    table.write(path, 2);
}

std::string text(const char* format, double value)
{
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

/// Returns the figures of every view from every eye as CSV.
std::string csv(const std::vector<Panel>& panels)
{
    std::string out = "scene,sheet,row,column,x_mm,y_mm,frame,psnr_db,ssim\n";
    for (const Panel& panel : panels)
        for (const Seen& seen : panel.all)
            for (std::size_t k = 0; k < panel.eyes.size(); ++k)
                out += panel.scene + "," + panel.sheet.name + "," +
                       std::to_string(k / panel.columns + 1) + "," +
                       std::to_string(k % panel.columns + 1) + "," + text("%.3f", panel.eyes[k].x) +
                       "," + text("%.3f", panel.eyes[k].y) + "," + seen.name + "," +
                       text("%.3f", seen.from_eyes[k].psnr) + "," +
                       text("%.4f", seen.from_eyes[k].ssim) + "\n";
    return out;
}

/// Returns the least, mean and greatest figures of each frame as a Markdown table.
std::string table(const std::vector<Panel>& panels)
{
    std::string out =
        "| scene, sheet | frame | PSNR least | mean | greatest | SSIM least | mean | greatest "
        "| frame's RMSE | own |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n";
    for (const Panel& panel : panels)
        for (const Seen& seen : panel.all) {
            const ViewFigures low = least(seen.from_eyes), middle = mean(seen.from_eyes),
                              high = greatest(seen.from_eyes);
            out += "| " + panel.scene + ", " + panel.sheet.name + " | " + seen.title;
            for (const double psnr : {low.psnr, middle.psnr, high.psnr})
                out += text(" | %.2f", psnr);
            for (const double ssim : {low.ssim, middle.ssim, high.ssim})
                out += text(" | %.3f", ssim);
            out += " | " + (seen.rmse ? text("%.4f", *seen.rmse) : std::string()) + " | " +
                   (&seen == &panel.all.back()
                        ? std::string()
                        : std::to_string(seen.own) + text(", %.1f mm", seen.farthest)) +
                   " |\n";
        }
    return out;
}

const char* usage = "eyes [--quick] -o FOLDER\n\n"
                    "Writes FOLDER/eyes.csv (every view), eyes.md (the table) and eyes.png.\n\n";

options::options_description make_options()
{
    const auto path = [](const char* word) {
        return options::value<std::string>()->value_name(word);
    };
    options::options_description all("Options");
    all.add_options()("output,o", path("FOLDER"),
                      "where the tables, the picture and the frames are written")(
        "quick", "one scene, nine eyes and small frames: seconds instead of minutes")(
        "renderer", path("FILE"), "povray-integral (default: the one built beside this program)")(
        "pristine", path("FILE"),
        "an unmodified POV-Ray (default: the one built beside this program)")(
        "scenes", path("FOLDER"),
        "the scenes (default: bench/scenes of this build's source)")("help", "print this");
    return all;
}

int run(const options::variables_map& arguments)
{
    if (!arguments.count("output"))
        throw UsageError("-o FOLDER is missing");
    const std::string folder = arguments["output"].as<std::string>();
    const Plan& plan = arguments.count("quick") ? quick : whole;
    const auto path = [&](const char* option, const files::path& usual) {
        const std::string name = arguments.count(option)
                                     ? arguments[option].as<std::string>()
                                     : (own_folder() / usual).lexically_normal().string();
        if (!files::exists(name))
            throw UsageError(
                name + ": it does not exist; build it (make all pristine) or name it with --" +
                option);
        return name;
    };
    const std::string scenes = path("scenes", "../../bench/scenes");
    const Renderer integral{path("renderer", "../bin/povray-integral"), scenes, folder + "/frames",
                            plan.width, plan.height};
    const Renderer pristine{path("pristine", "../pristine/unix/povray"), scenes, folder + "/frames",
                            plan.width, plan.height};
    files::create_directories(folder + "/frames");
    check_writable(folder + "/eyes.csv");
    std::vector<Panel> panels;
    for (const std::string& scene : plan.scenes)
        for (const Sheet& sheet : sheets()) {
            Experiment experiment(integral, pristine, plan, scene, sheet);
            experiment.run();
            panels.push_back(experiment.panel);
            const Panel& panel = panels.back();
            std::cout << scene << ", " << sheet.name << ": " << text("%.0f", panel.rays_a_pixel)
                      << " rays a pixel in the limit; none on "
                      << text("%.2f%%", 100 * panel.missing) << " of the lit pixels\n"
                      << table({panel}) << std::endl;
            if (scene == plan.pictured_scene && sheet.name == plan.pictured_sheet)
                experiment.write_picture(folder + "/eyes.png");
            // Written after each panel, so that an interruption loses only what is not finished.
            write_file(folder + "/eyes.csv", csv(panels));
            write_file(folder + "/eyes.md", table(panels));
        }
    return 0;
}

} // namespace

int main(int count, char** words)
{
    return status_of("eyes", [&] {
        const options::options_description all = make_options();
        const options::variables_map arguments = parsed(count, words, all);
        if (!arguments.count("help"))
            return run(arguments);
        std::cout << usage << all;
        return 0;
    });
}
