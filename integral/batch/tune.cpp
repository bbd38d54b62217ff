// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/tune.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/batch/renderer.h"
#include "integral/batch/renderer_options.h"
#include "integral/batch/slurm.h"
#include "integral/batch/strips.h"
#include "integral/io/image_file.h"
#include "integral/io/markup.h"
#include "integral/reconstruction/pass_rows.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <regex>
#include <stdexcept>

namespace integral {
namespace {

constexpr int most_bands = 5;
constexpr int blocks_a_band = 3; // rows of blocks in the frame per band; a band is one block high

/// A ladder of one kind of settings, from cheap to expensive.
struct Chain {
    std::vector<TuneSetting> settings;
    double dearer; ///< approximate ratio of the seconds of successive settings
    std::size_t next = 0;
    double expected = 0; ///< seconds of the next setting
};

TuneSetting samples(int pixel, int beam)
{
    return {"pixel_samples " + std::to_string(pixel) + " beam_samples " + std::to_string(beam),
            {"-A"}};
}

TuneSetting antialiased(const std::string& threshold)
{
    return {"pixel_samples 1 beam_samples 1", {"+A" + threshold, "+AM2", "+R5"}};
}

std::vector<Chain> chains()
{
    return {
        {{samples(1, 1), samples(2, 2), samples(2, 4), samples(4, 4), samples(4, 8), samples(8, 8),
          samples(8, 16), samples(16, 16)},
         1.8},
        {{antialiased("0.3"), antialiased("0.1"), antialiased("0.03"), antialiased("0.01")}, 1.4}};
}

/// The text of Integral_Camera= among options, without quotation marks around it; "" if none.
std::string camera_in(const std::vector<std::string>& options)
{
    return without_quotes(value_of_option(options, "integral_camera", ""));
}

/// Integral_Camera= with the existing words of the camera, then a setting's.
std::string camera_option(const std::string& camera, const TuneSetting& setting)
{
    return "Integral_Camera=" + camera + (camera.empty() ? "" : " ") + setting.camera;
}

/// One run of the renderer.
struct Run {
    FrameMetadata metadata;
    double seconds = 0;   ///< from the first ray to the last
    double parsing = 0;   ///< before and after the tracing, without the estimate of the error
    double auditing = 0;  ///< for the estimate of the error
    double processor = 0; ///< of all processors together, for everything
};

/// Renders parts of one frame at different settings.
class Measurement {
public:
    Measurement(const std::string& scene, const std::vector<std::string>& options)
        : scene_(scene), options_(options)
    {
        camera_ = camera_in(options);
        const Run probe = run(samples(1, 1), {"Start_Row=2", "End_Row=2"});
        parsing_ = probe.parsing;
        start_ = probe.seconds;
        start_processor_ = probe.processor;
        film_ = probe.metadata.film;
        const PassRows rows(probe.metadata.sheet, film_, usual_block_side, true);
        reach_ = rows.sampled_from();
        refined_ = rows.refined_from();
        const int blocks = (film_.height + usual_block_side - 1) / usual_block_side;
        bands_ = std::clamp((blocks + blocks_a_band - 1) / blocks_a_band, 1, most_bands);
    }

    /// Renders the bands at a setting. Calls `piece` after each band.
    template <class Piece> TunePoint measure(const TuneSetting& setting, Piece piece)
    {
        const bool antialias = setting.options[0] != "-A";
        double work = 0, audited = 0, rows = 0;
        std::vector<ErrorEstimate> errors;
        for (const RowStrip& band : bands(antialias ? reach_ : 0)) {
            const Run part = run(setting, options_of(band, film_.height));
            const double own = work_of(part);
            clock_ += std::max(0.0, part.seconds - start_);
            processor_ += own;
            work += antialias ? work_of_rows(band, own) : own;
            rows += band.rows;
            audited += part.auditing;
            if (part.metadata.render->error)
                errors.push_back(*part.metadata.render->error);
            piece();
        }
        if (errors.empty())
            throw InputError(scene_ + ": its frame shows nothing by which an error could be "
                                      "estimated");
        rows_ = int(rows);
        if (!antialias && first_samples_ == 0)
            first_samples_ = work / rows;
        costs_.push_back({work * film_.height / rows, audit_of_frame(errors, audited, rows)});
        return {setting, combined(errors), 0, 0};
    }

    /// Predicts the time of each measured point. Uses processor seconds, which do not depend on the
    /// machine's other load, and scales them to clock seconds by the ratio of the two over all
    /// runs.
    void foretell(std::vector<TunePoint>& points) const
    {
        const double clock = clock_ > 0 && processor_ > 0 ? clock_ / processor_ : 1;
        for (std::size_t k = 0; k < points.size(); ++k) {
            points[k].seconds = parsing_ + start_ + clock * costs_[k].work + costs_[k].audit;
            points[k].processor = start_processor_ + costs_[k].work + costs_[k].audit / clock;
        }
    }

    TuneResult result() const
    {
        return {film_.width, film_.height, rows_, parsing_, {}, std::nullopt, camera_};
    }
    int pieces() const { return bands_; }

private:
    /// Seconds of the whole frame at one setting.
    struct Cost {
        double work;  ///< of the processors, to trace it
        double audit; ///< by the clock, to estimate its error
    };

    /// Seconds of the processors that tracing took, without parsing and without the audit.
    double work_of(const Run& part) const
    {
        const double rendering = std::max(0.0, part.processor - start_processor_),
                     clock = part.seconds + part.auditing;
        return clock > 0 ? rendering * part.seconds / clock : 0;
    }

    /// The part of a band's processor seconds that its own rows take. Of the rows rendered around
    /// the band, the nearer ones are refined, too; the farther ones get only their first samples.
    double work_of_rows(const RowStrip& band, double work) const
    {
        const double beside = std::min(band.above, reach_) + band.below,
                     refined = std::min(band.above, refined_) + std::min(band.below, refined_);
        const double refining = std::max(0.0, work - (band.rows + beside) * first_samples_);
        return band.rows * (first_samples_ + refining / (band.rows + refined));
    }

    /// Bands one block high, spread evenly over the frame's height.
    std::vector<RowStrip> bands(int reach) const
    {
        const int blocks = (film_.height + usual_block_side - 1) / usual_block_side;
        const auto all = row_strips(film_.height, blocks, usual_block_side, reach);
        std::vector<RowStrip> chosen;
        for (int k = 0; k < bands_; ++k)
            chosen.push_back(all[std::size_t((2 * k + 1) * blocks / (2 * bands_))]);
        return chosen;
    }

    /// Predicts the clock seconds of the whole frame's audit, assuming that it examines 0.5% of the
    /// lit pixels (those with rays), but not fewer than in the first band.
    double audit_of_frame(const std::vector<ErrorEstimate>& errors, double seconds,
                          double rows) const
    {
        double looked_at = 0, lit = 0;
        for (const ErrorEstimate& error : errors) {
            looked_at += double(error.pixels);
            lit += double(error.lit_pixels);
        }
        if (!(looked_at > 0) || errors[0].method != ErrorMethod::audit)
            return 0;
        const double of_frame = std::max(0.005 * lit * film_.height / rows,
                                         double(errors[0].pixels));
        return seconds * of_frame / looked_at;
    }

    Run run(const TuneSetting& setting, const std::vector<std::string>& rows) const
    {
        const ScratchFolder scratch;
        const std::string picture = scratch.path("band.png");
        std::vector<std::string> words = scene_words(scene_, options_);
        words.insert(words.end(), setting.options.begin(), setting.options.end());
        words.insert(words.end(), rows.begin(), rows.end());
        words.push_back(camera_option(camera_, setting));
        words.push_back("+FN8 +O\"" + picture + "\"");
        words.push_back("-P");
        words.push_back("Integral_Metadata=full"); // with the seconds
        const auto begun = std::chrono::steady_clock::now();
        const ChildEnd end = render(scene_, words, scratch);
        const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun)
                                 .count();
        Run made;
        made.metadata = read_metadata(picture);
        if (!made.metadata.render)
            throw InputError(scene_ + ": its camera is not integral");
        made.processor = end.processor;
        made.seconds = made.metadata.render->seconds;
        if (made.metadata.render->error)
            made.auditing = made.metadata.render->error->seconds;
        made.parsing = std::max(0.0, whole - made.seconds - made.auditing);
        return made;
    }

    std::string scene_;
    std::vector<std::string> options_;
    std::string camera_;
    Film film_;
    int reach_ = 0, refined_ = 0; ///< rows next to a band that are sampled, and that are refined
    int bands_ = 1, rows_ = 0;
    /// Seconds of a one-row render: parsing; tracing; everything, of all processors.
    double parsing_ = 0, start_ = 0, start_processor_ = 0;
    double first_samples_ = 0;         ///< processors' seconds of a row with one ray a pixel
    double clock_ = 0, processor_ = 0; ///< seconds of all tracing so far
    std::vector<Cost> costs_;          ///< in the order of measuring
};

/// An option that tune rejects. Names in lower case: see values_of_option.
struct UnfitOption {
    const char *keyword, *letters, *shown, *why;
};
const char* const whole_frames = "settings are found for whole frames";
const UnfitOption unfit_options[] = {
    {"integral_quilt", "", "Integral_Quilt", whole_frames},
    {"integral_rows", "", "Integral_Rows", whole_frames},
    {"start_row", "sr", "+SR", whole_frames},
    {"end_row", "er", "+ER", whole_frames},
    {"start_column", "sc", "+SC", whole_frames},
    {"end_column", "ec", "+EC", whole_frames},
    {"final_frame", "kff", "+KFF", "settings are found for one frame, not for an animation"},
};

void check_unfit_options(const std::vector<std::string>& options)
{
    for (const UnfitOption& unfit : unfit_options)
        if (!values_of_option(options, unfit.keyword, unfit.letters).empty())
            throw std::invalid_argument(std::string(unfit.shown) + ": " + unfit.why +
                                        "; leave it out");
    const std::string audit = value_of_option(options, "integral_audit", "");
    if (std::regex_match(audit, std::regex("off|no|false|0", std::regex::icase)))
        throw std::invalid_argument("Integral_Audit=" + audit +
                                    ": settings are found by the estimated error; leave it out");
}

void check_options(const std::string& scene, const std::vector<std::string>& options)
{
    check_unfit_options(options);
    for (const std::string& word : options)
        for (const RendererOption& option : renderer_options_in(word)) {
            const bool antialias = option.kind == RendererOption::Kind::letters &&
                                   !option.name.empty() &&
                                   (option.name[0] == 'A' || option.name[0] == 'a');
            if (antialias)
                throw std::invalid_argument(word +
                                            ": the settings of +A are what is looked for; leave "
                                            "it out");
        }
    static const std::regex sampling("\\b(pixel|beam)_samples\\b");
    if (std::regex_search(camera_in(options), sampling))
        throw std::invalid_argument("pixel_samples and beam_samples are what is looked for; leave "
                                    "them out of Integral_Camera");
    if (!names_scene(scene))
        throw std::invalid_argument(scene + ": it is no scene (.pov, .ini)");
    const std::string file = without_section(scene);
    if (names_settings(scene) && std::filesystem::exists(file) &&
        std::regex_search(read_file(file), std::regex("integral_camera", std::regex::icase)))
        throw std::invalid_argument(scene + ": it has an Integral_Camera of its own; give that "
                                            "after the scene's name instead");
}

/// Whether the next setting of a chain may still be better than the points so far.
bool worth_measuring(const Chain& chain, const std::vector<TunePoint>& points, const TuneGoal& goal)
{
    if (chain.next >= chain.settings.size())
        return false;
    if (goal.seconds && !points.empty() && chain.expected > 1.3 * *goal.seconds)
        return false;
    const auto best = best_point(points, goal);
    return !(goal.error && best && chain.expected >= points[*best].seconds);
}

} // namespace

double counted_error(const ErrorEstimate& error) { return error.low > 0 ? error.rms : error.high; }

std::optional<std::size_t> best_point(const std::vector<TunePoint>& points, const TuneGoal& goal)
{
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const TunePoint& point = points[k];
        if ((goal.error && counted_error(point.error) > *goal.error) ||
            (goal.seconds && point.seconds > *goal.seconds) || (!goal.error && !goal.seconds))
            continue;
        if (!best || (goal.error ? point.seconds < points[*best].seconds
                                 : counted_error(point.error) < counted_error(points[*best].error)))
            best = k;
    }
    return best;
}

TuneResult tune(const std::string& scene, const std::vector<std::string>& options,
                const TuneGoal& goal, const Progress& progress)
{
    check_options(scene, options);
    Measurement measurement(scene, options);
    std::vector<Chain> ladder = chains();
    int settings = 0, done = 0;
    for (const Chain& chain : ladder)
        settings += int(chain.settings.size());
    const auto piece = [&] {
        stop_if_interrupted();
        if (progress)
            progress(++done, settings * measurement.pieces());
    };
    std::vector<TunePoint> points;
    for (;;) {
        Chain* cheapest = nullptr;
        for (Chain& chain : ladder)
            if (worth_measuring(chain, points, goal) &&
                (!cheapest || chain.expected < cheapest->expected))
                cheapest = &chain;
        if (!cheapest)
            break;
        points.push_back(measurement.measure(cheapest->settings[cheapest->next++], piece));
        measurement.foretell(points);
        cheapest->expected = points.back().seconds * cheapest->dearer;
        // Try +A0.3 next: it gives the best error for its time on nearly every scene
        // (doc/error-against-time.md). Skip +A0.3 only if one ray a pixel is good enough.
        if (points.size() == 1)
            ladder[1].expected = points[0].seconds;
    }
    if (progress)
        progress(1, 1);
    TuneResult result = measurement.result();
    result.best = best_point(points, goal);
    result.points = std::move(points);
    return result;
}

std::vector<std::string> tuned_words(const std::string& scene,
                                     const std::vector<std::string>& options,
                                     const TuneResult& result, const TuneSetting& setting)
{
    std::vector<std::string> words = {names_settings(scene) ? scene : "+I" + scene};
    for (const std::string& option : options)
        if (camera_in({option}).empty())
            words.push_back(option);
    for (const std::string& option : setting.options)
        if (option != "-A")
            words.push_back(option);
    words.push_back(camera_option(result.camera, setting));
    return words;
}

std::string tuned_command(const std::string& scene, const std::vector<std::string>& options,
                          const TuneResult& result, const TuneSetting& setting)
{
    std::string text = "povray-integral";
    for (const std::string& word : tuned_words(scene, options, result, setting))
        text += " " + for_shell(word);
    return text;
}

} // namespace integral
