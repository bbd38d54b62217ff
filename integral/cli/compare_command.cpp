// SPDX-License-Identifier: AGPL-3.0-or-later
// integral compare: differences between two frames or views, or the pictures of two folders.
#include "integral/base/json.h"
#include "integral/cli/compare_options.h"
#include "integral/cli/values.h"
#include "integral/compare/compare_files.h"
#include "integral/compare/figures_json.h"
#include "integral/compare/figures_text.h"
#include "integral/replay/compare_seen.h"
#include "integral/replay/replay_page.h"

namespace integral {
namespace {

/// Whether two pictures have equal sizes in pixels. Pictures of unequal size are compared only as
/// eyes see them (--seen, --eyes), through sheets of equal size in mm: throws InputError or
/// UsageError if that is not requested or not possible.
bool check_sizes(const Frame& a, const Frame& b, const CompareOptions& o, const Limits& limits)
{
    const std::string& name = o.inputs[1];
    if (a.image.width == b.image.width && a.image.height == b.image.height)
        return true;
    const bool frames = a.metadata && b.metadata;
    const std::string other = frames ? other_sheet(*a.metadata, *b.metadata) : "";
    if (!o.seen && !o.eyes) {
        try {
            require_same_size(a.image, b.image);
        } catch (const std::invalid_argument& error) {
            throw InputError(
                name + ": " + error.what() +
                (frames && other.empty() ? ", or what eyes see of these frames with --seen" : ""));
        }
    }
    if (!other.empty())
        throw InputError(name + ": " + other +
                         "; frames of other sizes in pixels are compared as seen only if both "
                         "films have one size in mm");
    if (const char* option = first_given(
            {{"output", o.output},
             {"flip-map", o.flip_map},
             {"ignore", o.ignore},
             {"weight", o.weight},
             {"mask", o.mask},
             {"max-micro-image-rmse", bool(limits[micro_image_limit])}}))
        throw UsageError(std::string("--") + option + " needs frames of one size in pixels; " +
                         name + " has " + std::to_string(b.image.width) + "x" +
                         std::to_string(b.image.height) + ", the other " +
                         std::to_string(a.image.width) + "x" + std::to_string(a.image.height));
    return false;
}

int run(const CompareOptions& o)
{
    if (o.suite)
        return run_suite(o);
    throw_if_given({{"references", o.references},
                    {"tolerances", o.tolerances},
                    {"junit", o.junit},
                    {"accept", o.accept},
                    {"create", o.create},
                    {"approve", o.approve},
                    {"summary", o.summary},
                    {"threads", o.threads.given}},
                   "is for --suite FOLDER");
    const Limits limits = limits_of(o);
    if (o.inputs.size() != 2)
        throw UsageError("an input is missing: A and B are compared, or folders with --suite; see "
                         "integral help compare");
    ComparisonRules rules;
    change_rules(rules, o, limits);
    ComparisonOutputs outputs{o.output.value_or(""), 1, o.flip_map.value_or("")};
    read_number("gain", o.gain, outputs.gain);
    const std::string output = outputs.difference, sheet = o.sheet.value_or("");
    if (o.flip_map && outputs.flip_map.empty())
        throw UsageError("--flip-map: a name is expected");
    const int piped = (output == "-") + (outputs.flip_map == "-") + (o.html == "-");
    if (piped > 1)
        throw UsageError("only one of -o, --flip-map and --html goes to standard output");
    for (const std::string& path : {output, outputs.flip_map})
        if (!path.empty())
            check_picture(path);
    FrameReader a(o.inputs[0], sheet), b(o.inputs[1], sheet);
    if (o.html && o.html->empty())
        throw UsageError("--html: the name of a file is expected");
    check_outputs({o.html});
    if (rules.seen) {
        a.require_metadata();
        b.require_metadata();
    }
    const Comparison comparison = usage_checked("", [&] {
        const bool one_size = check_sizes(a.frame(), b.frame(), o, limits);
        Comparison result;
        if (one_size)
            result = compare_files(a, b, o.inputs[1], rules, outputs);
        if (!rules.seen && !o.html)
            return result;
        a.restart();
        b.restart();
        const Frame first = a.whole(), second = b.whole();
        if (!one_size)
            result = compare_only_seen(first, second, rules);
        else if (rules.seen)
            result.seen = std::make_shared<SeenFigures>(compare_seen(first, second, rules));
        if (o.html)
            write_file(*o.html, comparison_page(compared_pictures(first, second, result)));
        return result;
    });

    const auto missed = missed_limits(limits, comparison);
    Json json = figures_json(comparison);
    json["passed"] = missed.empty();
    const std::string figures = o.json ? json.dump(2) + "\n" : figures_text(comparison);
    print_figures(figures, piped > 0);
    for (const auto& what : missed)
        say("compare", o.inputs[1] + ": " + what);
    return missed.empty() ? exit_done : exit_check_failed;
}

} // namespace

const Command compare_command = {
    "compare",
    "how far two frames or views are apart: RMSE, PSNR, SSIM, FLIP, worst micro-image",
    R"(A B [-o DIFFERENCE] [--flip] [--max-rmse R] [--max-differing 0.1%] [--max-flip F]
       integral compare --suite FOLDER [--references FOLDER] [-o REPORT.html] [--junit FILE.xml])",
    R"(Compares two pictures of one size in their output encoding, 0 to 1 at full scale (linear
pictures in the other's encoding). Colours are compared over black; alpha is a fourth
channel where both have it. RMSE and PSNR (0 dB is full scale; inf: equal) are over all
channels of all pixels; SSIM is of the lumas, over 11x11 Gaussian windows of sigma 1.5. With
a frame's geometry, the micro-image with the greatest RMSE is named: the lens's column and row
and its place on the sheet. NaN equals NaN and infinity equals infinity; other pairs with NaN
or infinity are counted as unequal pixels, miss every limit, and are left out of the figures.

FLIP (Andersson and others 2020, 2021) is the difference that a person perceives who sees A, the
reference, and B in turn: 0 is none, 1 the greatest. The mean is printed, and the quartiles of
the map weighted by its values. Pictures of floats are compared at several exposures (HDR-FLIP).
An ignored pixel counts as equal in every figure.

With --seen both frames are replayed from nine eyes, or those of --eyes, and the views compared.
The worst eye, the worst place on the sheet, and how far parallax differs are named.

With --suite, the pictures of a folder (PNG, EXR, TIFF; its sub-folders too) are compared with
those of the same names among the references. A picture fails if it misses a limit, or if size
or geometry differ, a file is damaged, or one of the two is missing. Limits stand in a file:
  {"defaults": {"max_rmse": 0.002},
   "files": {"glass/*": {"max_rmse": 0.01, "max_flip": 0.02},
             "noise.png": {"min_ssim": 0.9, "ignore": ["0,0,100x20"]}}}
A name's or glob's limits take the place of the defaults; a later match that of an earlier one;
null lifts a limit. A picture without any limit must equal its reference.
)",
    0,
    2,
    described<CompareOptions>,
    run_with<CompareOptions, run>};

} // namespace integral
