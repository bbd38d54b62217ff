// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/compare_options.h"

#include "integral/base/number_text.h"
#include "integral/cli/values.h"
#include "integral/compare/seen.h"

#include <algorithm>

namespace integral {
namespace {

std::string option_of(const LimitKind& kind)
{
    std::string option = kind.word;
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

} // namespace

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
    add(group, "approve", o.approve,
        "show each picture that did not pass on a page in the browser, served to this machine "
        "alone: "
        "accept (a) does at once what --accept does, reject (r) leaves the reference as it is");
    add(group, "port", o.port, "PORT", "the port of --approve's page (default: a free one)");
    add(group, "no-browser", o.no_browser,
        "--approve: print the page's address and do not open a browser");
    add(group, "create", o.create,
        "make results without a reference references first, and say so: for a first run");
    add(group, "summary", o.summary, "FILE.md",
        "write the outcome as Markdown, for the page of a CI job, and small pictures of what "
        "failed "
        "to the folder FILE.md.pictures");
    declare(group, o.threads);
    all.add(group);
}

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
    for (const std::string& words : o.ignore.value_or(Arguments()))
        rules.regions.push_back(usage_checked("--ignore ", [&] { return region_of(words, 0); }));
    for (const std::string& words : o.weight.value_or(Arguments())) {
        const std::size_t at = words.rfind('=');
        if (at == std::string::npos)
            throw_usage("weight", words, "WHERE=W");
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

} // namespace integral
