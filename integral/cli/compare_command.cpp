// SPDX-License-Identifier: AGPL-3.0-or-later
// integral compare: how far two frames or views are apart.
#include "integral/cli/command.h"
#include "integral/cli/compare_options.h"
#include "integral/cli/compare_suite.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/compare/compare.h"
#include "integral/compare/figures_json.h"
#include "integral/io/image_file.h"
#include "integral/lightfield/names.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace integral {
namespace {

options::options_description make_options()
{
    options::options_description all("Options");
    const auto number = [](const char* name) {
        return options::value<std::string>()->value_name(name);
    };
    all.add_options()(
        "output,o", options::value<std::string>()->value_name("DIFFERENCE"),
        "write the difference picture, |A - B| of each channel: .png, .exr or .tiff; - "
        "writes a PNG to standard output and the figures to standard error")(
        "gain", number("G")->default_value("1"), "multiply the difference picture by G")(
        "sheet", options::value<std::string>()->value_name("FILE.json"),
        "geometry for frames that carry none, or instead of their own")(
        "json", "print the figures as JSON (a PSNR that is infinite is null)")("help",
                                                                               "print this");
    add_limit_options(all);
    add_suite_options(all);
    return all;
}

std::string as_text(const Comparison& c)
{
    char text[400];
    std::snprintf(text, sizeof text,
                  "RMSE                %.6f\n"
                  "PSNR                %.3f dB\n"
                  "SSIM                %.6f\n"
                  "largest difference  %.6f\n"
                  "within 2/255        %.4f%% of the pixels\n"
                  "encoding            %s\n",
                  c.rmse, c.psnr, c.ssim, c.largest_difference, 100 * c.within_two,
                  name_of(c.encoding.kind));
    std::string result = text;
    if (c.worst) {
        std::snprintf(
            text, sizeof text, "worst micro-image   lens %lld,%lld at %.3f,%.3f mm: RMSE %.6f\n",
            static_cast<long long>(c.worst->lens.i), static_cast<long long>(c.worst->lens.j),
            c.worst->pole.x, c.worst->pole.y, c.worst->rmse);
        result += text;
    }
    return result;
}

std::string as_json(const Comparison& comparison, bool passed)
{
    nlohmann::ordered_json json = figures_json(comparison);
    json["passed"] = passed;
    return json.dump(2) + "\n";
}

/// Compares two pictures, some rows at a time, and writes their difference if `output` is not
/// empty.
Comparison compare_rows(FrameReader& a, FrameReader& b, const std::string& name_of_b,
                        const std::string& output, double gain)
{
    const Image &form_a = a.frame().image, &form_b = b.frame().image;
    std::optional<Comparer> comparer;
    try {
        comparer.emplace(a.frame(), b.frame());
    } catch (const std::invalid_argument& error) {
        throw InputError(name_of_b + ": " + error.what());
    }
    std::optional<PictureWriter> difference;
    if (!output.empty())
        difference.emplace(
            PictureWriter::of_frame(output, difference_form(form_a, form_b), std::nullopt));
    const int most = std::min(rows_of_a_band(form_a), rows_of_a_band(form_b));
    Image rows_a, rows_b;
    for (int y = 0; y < form_a.height; y += most) {
        stop_if_interrupted();
        const int rows = std::min(most, form_a.height - y);
        if (rows_a.height != rows) {
            rows_a = blank_like(form_a, form_a.width, rows);
            rows_b = blank_like(form_b, form_b.width, rows);
        }
        a.read(rows_a);
        b.read(rows_b);
        comparer->add(rows_a, rows_b);
        if (difference)
            difference->write(difference_picture(rows_a, rows_b, gain));
    }
    stop_if_interrupted();
    if (difference)
        difference->finish();
    return comparer->result();
}

int run(const options::variables_map& arguments)
{
    if (given(arguments, "suite"))
        return run_suite(arguments);
    refuse_suite_options(arguments);
    const Limits limits = limits_from(arguments);
    const auto inputs = inputs_of(arguments);
    if (inputs.size() != 2)
        throw UsageError("an input is missing: A and B are compared, or folders with --suite; see "
                         "integral help compare");
    const double gain = parse_number("gain", text_of(arguments, "gain"), "a number");
    const std::string output = text_of(arguments, "output");
    if (!output.empty()) {
        format_for(output);
        check_writable(output);
    }
    const std::string sheet = text_of(arguments, "sheet");
    FrameReader a(inputs[0], sheet), b(inputs[1], sheet);
    const Comparison comparison = compare_rows(a, b, inputs[1], output, gain);

    const auto missed = missed_limits(limits, comparison);
    const std::string figures = given(arguments, "json") ? as_json(comparison, missed.empty())
                                                         : as_text(comparison);
    if (output == "-") // the picture has standard output
        std::fputs(figures.c_str(), stderr);
    else
        write_file("-", figures);
    for (const auto& what : missed)
        say("compare", inputs[1] + ": " + what);
    return missed.empty() ? exit_done : exit_check_failed;
}

} // namespace

const Command compare_command = {
    "compare",
    "how far two frames or views are apart: RMSE, PSNR, SSIM, worst micro-image",
    "A B [-o DIFFERENCE] [--max-rmse R] [--min-psnr P] [--min-ssim S]\n"
    "       integral compare --suite FOLDER [--references FOLDER] [-o REPORT.html] [--junit "
    "FILE.xml]",
    "Compares two pictures of one size in their output encoding, 0 to 1 at full scale (linear\n"
    "pictures in the other's encoding). Colours are compared over black; alpha is a fourth\n"
    "channel where both have it. RMSE and PSNR (0 dB is full scale; inf: equal) are over all\n"
    "channels of all pixels; SSIM is of the lumas, over 11x11 Gaussian windows of sigma 1.5. With\n"
    "a frame's geometry, the micro-image with the greatest RMSE is named: the lens's column and "
    "row\n"
    "and its place on the sheet.\n"
    "\n"
    "With --suite, the pictures of a folder (PNG, EXR, TIFF; its sub-folders too) are compared "
    "with\n"
    "those of the same names among the references. A picture fails if it misses a limit, or if "
    "size\n"
    "or geometry differ, a file is damaged, or one of the two is missing. Limits stand in a file:\n"
    "  {\"defaults\": {\"max_rmse\": 0.002},\n"
    "   \"files\": {\"glass/*\": {\"max_rmse\": 0.01}, \"noise.png\": {\"min_ssim\": 0.9}}}\n"
    "A name's or glob's limits take the place of the defaults; a later match that of an earlier "
    "one;\n"
    "null lifts a limit. A picture without any limit must equal its reference.\n",
    0,
    2,
    make_options,
    run_from_map<run>};

} // namespace integral
