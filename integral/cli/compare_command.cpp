// SPDX-License-Identifier: AGPL-3.0-or-later
// integral compare: how far two frames or views, or the pictures of two folders, are apart.
#include "integral/base/number_text.h"
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/cli/values.h"
#include "integral/compare/compare_files.h"
#include "integral/compare/figures_json.h"
#include "integral/compare/figures_text.h"
#include "integral/compare/suite_accept.h"
#include "integral/compare/suite_renames.h"
#include "integral/compare/suite_run.h"
#include "integral/compare/suite_summary.h"
#include "integral/replay/compare_seen.h"
#include "integral/replay/replay_page.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace integral {
namespace {

struct CompareOptions : CommonOptions {
    std::optional<std::string> output, gain, sheet, flip_map, ppd, channel_tolerance, mask, html;
    std::optional<Words> ignore, weight, eyes;
    bool json = false, flip = false, seen = false;
    std::array<std::optional<std::string>, limit_count> limits; ///< in the order of limit_kinds
    // With --suite:
    std::optional<std::string> suite, references, tolerances, junit, summary;
    std::optional<Words> accept;
    bool create = false;
    ThreadOptions threads;
};

std::string option_of(const LimitKind& kind)
{
    std::string option = kind.word;
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

void declare(options::options_description& all, CompareOptions& o)
{
    add(all, "output,o", o.output, "DIFFERENCE",
        "write the difference picture, |A - B| of each channel: .png, .exr or .tiff; - writes a "
        "PNG to standard output and the figures to standard error");
    add(all, "gain", o.gain, "G (=1)", "multiply the difference picture by G");
    add(all, "sheet", o.sheet, "FILE.json",
        "geometry for frames that carry none, or instead of their own");
    add(all, "json", o.json,
        "print the figures as JSON (a figure that is infinite or unknown is null)");
    for (std::size_t i = 0; i < limit_count; ++i)
        add(all, option_of(limit_kinds[i]).c_str(), o.limits[i], limit_kinds[i].value_name,
            limit_kinds[i].explanation);
    add(all, "channel-tolerance", o.channel_tolerance, "D (=2/255)",
        "a pixel differs if one of its channels differs by more than D, 0 to 1 (--max-differing)");
    add(all, "flip", o.flip,
        "compute FLIP, the difference that a person perceives who sees both pictures in turn, 0 to "
        "1: LDR-FLIP, or HDR-FLIP where a picture holds floats");
    add(all, "flip-map", o.flip_map, "FILE",
        "write the map of FLIP: .png or .tiff in colours, black 0 and light yellow 1; .exr the "
        "values");
    add(all, "ppd", o.ppd, "PIXELS",
        "pixels per degree of the viewer's sight for FLIP (default: by a frame's viewing distance "
        "and film; 67.02 without geometry)");
    all.add_options()("ignore", fills(o.ignore, "WHERE")->composing(),
                      "leave out a region: X,Y,WxH in pixels, or lens:COLUMN,ROW, or ranges of "
                      "lenses as lens:0..3,-2..2. May be given several times");
    all.add_options()("weight", fills(o.weight, "WHERE=W")->composing(),
                      "a region counts W times as much as the rest of the picture. May be given "
                      "several times");
    add(all, "mask", o.mask, "FILE",
        "a picture of the same size: where it is black pixels are ignored, where it is white they "
        "count, between in proportion");
    add(all, "seen", o.seen,
        "compare what eyes see of frames through their sheets (with pupil and blur), too; the "
        "limits are for that then, except --max-micro-image-rmse");
    all.add_options()(
        "eyes", fills(o.eyes, "EYES")->composing(),
        "the eyes of --seen: a grid CxR over the viewing zone (default: nine eyes, 3x3 "
        "or side by side), or X,Y,DISTANCE in mm, which may be given several times");
    add(all, "html", o.html, "PAGE",
        "write one page, in which the reader moves the eye before both frames at once: a line "
        "between the two that is moved, or blinking");
    options::options_description group("With --suite");
    add(group, "suite", o.suite, "FOLDER",
        "compare the pictures of a folder with their references. -o writes a report, one HTML "
        "page; --json prints all figures; the limits above take the place of the file's defaults; "
        "--gain multiplies the report's differences, by itself each so that it is seen");
    add(group, "references", o.references, "FOLDER",
        "where the references are (default: the folder references beside --suite's)");
    add(group, "tolerances", o.tolerances, "FILE",
        "limits for all pictures and for some (default: suite.json among the references, if it is "
        "there)");
    add(group, "junit", o.junit, "FILE", "write the outcome as JUnit XML, for CI systems");
    group.add_options()(
        "accept", fills(o.accept, "NAME...")->multitoken()->composing(),
        "compare nothing: make these results the references, and remove the reference of a result "
        "that is gone; each is named by its name within the folder, or by its path");
    add(group, "create", o.create,
        "make results without a reference references first, and say so: for a first run");
    add(group, "summary", o.summary, "FILE.md",
        "write the outcome as Markdown, for the page of a CI job, and small pictures of what "
        "failed "
        "to the folder FILE.md.pictures");
    declare(group, o.threads);
    all.add(group);
}

/// The limits that the line gives. Throws UsageError.
Limits limits_of(const CompareOptions& o)
{
    Limits limits;
    for (std::size_t i = 0; i < limit_count; ++i) {
        if (!o.limits[i])
            continue;
        const LimitKind& kind = limit_kinds[i];
        const std::string option = option_of(kind), text = *o.limits[i];
        const double limit = kind.is_share && share_of(text)
                                 ? *share_of(text)
                                 : parse_number(option.c_str(), text, "a number");
        if (!(limit >= kind.least && limit <= kind.greatest))
            throw UsageError("--" + option + " " + text + ": a number from " +
                             with_digits(kind.least, 6) + " to " + with_digits(kind.greatest, 6) +
                             " is expected");
        limits[i] = limit;
    }
    return limits;
}

/// Changes `rules` by what the line gives. Throws UsageError.
void change_rules(ComparisonRules& rules, const CompareOptions& o, const Limits& limits)
{
    if (o.channel_tolerance)
        rules.channel_tolerance = parse_number_between("channel-tolerance", *o.channel_tolerance,
                                                       "a number", 0, 1, "a number from 0 to 1");
    if (o.ppd)
        rules.ppd = parse_number_between("ppd", *o.ppd, "a number", least_ppd, greatest_ppd,
                                         "a number from 1 to 1000");
    if (o.mask)
        rules.mask = *o.mask;
    for (const std::string& words : o.ignore.value_or(Words()))
        rules.regions.push_back(usage_checked("--ignore ", [&] { return region_of(words, 0); }));
    for (const std::string& words : o.weight.value_or(Words())) {
        const std::size_t at = words.rfind('=');
        if (at == std::string::npos)
            refuse("weight", words, "WHERE=W");
        const double weight = parse_number_between("weight", words.substr(at + 1), "WHERE=W", 0,
                                                   1e6, "a weight from 0 to 1000000");
        rules.regions.push_back(
            usage_checked("--weight ", [&] { return region_of(words.substr(0, at), weight); }));
    }
    if (o.eyes)
        rules.seen = usage_checked("--eyes ", [&] { return seen_eyes_of(*o.eyes); });
    else if (o.seen && !rules.seen)
        rules.seen.emplace();
    rules.flip |= o.flip || o.flip_map || limits[flip_limit];
}

/// Throws UsageError for options that --suite does not go with.
void check_suite_options(const CompareOptions& o)
{
    if (!o.inputs.empty())
        throw UsageError(
            "with --suite no pictures are named; the folders are --suite and --references");
    if (o.sheet)
        throw UsageError("--sheet and --suite do not go together: each frame has its own geometry");
    if (o.html)
        throw UsageError("--html and --suite do not go together: the suite's report is -o");
    if (o.flip_map)
        throw UsageError("--flip-map and --suite do not go together: the report has the maps");
    const auto is_empty = [](const std::optional<std::string>& text) {
        return text && text->empty();
    };
    if (const char* option = first_given({{"suite", is_empty(o.suite)},
                                          {"references", is_empty(o.references)},
                                          {"tolerances", is_empty(o.tolerances)},
                                          {"junit", is_empty(o.junit)},
                                          {"summary", is_empty(o.summary)}}))
        throw UsageError(std::string("--") + option + ": a name is expected");
    const std::string output = o.output.value_or(""), extension = extension_of(output);
    if (!output.empty() && output != "-" && extension != "html" && extension != "htm")
        throw UsageError("-o " + output + ": with --suite it is a report, NAME.html");
    if (const char* other = first_given({{"output", o.output},
                                         {"junit", o.junit},
                                         {"summary", o.summary},
                                         {"create", o.create},
                                         {"tolerances", o.tolerances},
                                         {"json", o.json}});
        o.accept && other)
        throw UsageError(std::string("--accept and --") + other +
                         " do not go together: references are replaced, nothing is compared");
    if ((output == "-") + (o.junit == "-") + (o.summary == "-") > 1)
        throw UsageError("only one of -o, --junit and --summary goes to standard output");
}

/// Makes results references and says so. `verb`: "accepted". `errors`: say it on standard error.
void accept(const Words& names, const SuiteFolders& folders, const char* verb, bool errors)
{
    accept_results(names, folders,
                   [&](const std::string& name, const std::string& reference, const char* now) {
                       std::fprintf(errors ? stderr : stdout, "%s %s: %s %s\n", verb, name.c_str(),
                                    reference.c_str(), now);
                   });
    std::fflush(stdout);
}

/// Writes and prints what the comparison found. Returns an ExitStatus.
int report(const Suite& suite, const CompareOptions& o)
{
    const std::string output = o.output.value_or(""), junit = o.junit.value_or("");
    if (!output.empty()) {
        const std::string folder = output == "-"
                                       ? ""
                                       : std::filesystem::absolute(output).parent_path().string();
        write_file(output, suite_page(suite, folder));
    }
    if (!junit.empty())
        write_file(junit, suite_junit(suite));
    if (o.summary)
        write_suite_summary(suite, *o.summary);
    for (const SuitePair& pair : suite.pairs)
        for (const std::string& fault : pair.faults)
            say("compare", pair.name + ": " + fault);
    for (const std::string& fault : suite.unused)
        say("compare", suite.tolerances + ": " + fault);
    const std::string said = o.json ? suite_json(suite) : suite_summary(suite) + "\n";
    print_figures(said, output == "-" || junit == "-" || o.summary == "-");
    return suite.passed() ? exit_done : exit_check_failed;
}

int run_suite(const CompareOptions& o)
{
    check_suite_options(o);
    const int threads = o.threads.count();
    SuitePictures pictures;
    pictures.wanted = !o.output.value_or("").empty();
    read_number("gain", o.gain, pictures.gain);
    pictures.thumbnails = o.summary && o.summary != "-";
    const SuiteFolders folders = suite_folders(*o.suite, o.references, o.accept || o.create);
    if (o.accept) {
        accept(*o.accept, folders, "accepted", false);
        return exit_done;
    }

    SuiteTolerances tolerances = read_tolerances(folders, o.tolerances);
    const Limits limits = limits_of(o);
    for (std::size_t kind = 0; kind < limit_count; ++kind)
        if (limits[kind])
            tolerances.tolerances.defaults[kind] = limits[kind];
    change_rules(tolerances.tolerances.default_rules, o, limits);
    for (const std::string& path :
         {o.output.value_or(""), o.junit.value_or(""), o.summary.value_or("")})
        if (!path.empty())
            check_writable(path);
    if (o.create)
        accept(results_without_reference(folders), folders, "created", true);
    Suite suite = suite_of(folders, tolerances);
    if (!compare_suite(suite, pictures, compare_seen, threads, progress_bar("comparing")))
        throw Interrupted();
    note_renames(suite);
    return report(suite, o);
}

int run(const CompareOptions& o)
{
    if (o.suite)
        return run_suite(o);
    refuse_given({{"references", o.references},
                  {"tolerances", o.tolerances},
                  {"junit", o.junit},
                  {"accept", o.accept},
                  {"create", o.create},
                  {"summary", o.summary},
                  {"threads", o.threads.given}},
                 "goes with --suite FOLDER");
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
    if (output == "-" && outputs.flip_map == "-")
        throw UsageError("-o and --flip-map do not both go to standard output");
    for (const std::string& path : {output, outputs.flip_map})
        if (!path.empty())
            check_picture(path);
    FrameReader a(o.inputs[0], sheet), b(o.inputs[1], sheet);
    if (o.html && o.html->empty())
        throw UsageError("--html: the name of a file is expected");
    check_outputs({o.html});
    if (rules.seen || o.html) {
        a.require_metadata();
        b.require_metadata();
    }
    const Comparison comparison = usage_checked("", [&] {
        Comparison result = compare_files(a, b, o.inputs[1], rules, outputs);
        if (!rules.seen && !o.html)
            return result;
        a.restart();
        b.restart();
        const Frame first = a.whole(), second = b.whole();
        if (rules.seen)
            result.seen = std::make_shared<SeenFigures>(compare_seen(first, second, rules));
        if (o.html) {
            View start;
            start.eye = centre_eye(*first.metadata);
            set_as_seen(start, *first.metadata);
            write_file(*o.html, comparison_page(first, second, start));
        }
        return result;
    });

    const auto missed = missed_limits(limits, comparison);
    Json json = figures_json(comparison);
    json["passed"] = missed.empty();
    const std::string figures = o.json ? json.dump(2) + "\n" : figures_text(comparison);
    print_figures(figures, output == "-" || outputs.flip_map == "-");
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
