// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/sheet_list.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/frame/names.h"
#include "integral/sheet/known_sheets.h"
#include "integral/sheet/sheet_figures.h"
#include "integral/sheet/sheet_report.h"

#include <cstdio>

namespace integral {
namespace {

/// One line of the table.
struct Row {
    std::string name;
    LensSheet sheet;
    double pixels;                      ///< per lens
    std::optional<double> budget, zone; ///< mm
    std::optional<double> lenses;       ///< across the picture
    std::optional<WholePicture> whole;
};

Row row_of(const std::string& name, const LensSheet& sheet, FrameMetadata print)
{
    print.sheet = sheet;
    const LensRowGeometry c = counted(print);
    const double distance = print.aperture.distance;
    Row row{name,
            sheet,
            c.period / c.pixel,
            depth_budget(sheet, c.pixel),
            filling_width(sheet, distance, c.cell),
            std::nullopt,
            std::nullopt};
    if (c.pixels > 0) {
        const double width = c.pixels * c.pixel;
        row.lenses = width / c.period;
        if (row.zone)
            row.whole = whole_picture(distance, *row.zone, width);
    }
    return row;
}

std::vector<Row> rows_of(const FrameMetadata& print, bool with_own)
{
    std::vector<Row> rows;
    if (with_own)
        rows.push_back(row_of("this sheet", print.sheet, print));
    for (const KnownSheet& known : known_sheets())
        rows.push_back(
            row_of(std::string("Integral_Sheet_") + known.name + "()", known.sheet, print));
    return rows;
}

/// A figure with `decimals` decimals, or "-", right-aligned in a column of `width` characters.
std::string column(std::optional<double> value, int decimals, int width)
{
    const std::string text = value ? with_decimals(*value, decimals) : "-";
    return std::string(std::size_t(std::max(1, width - int(text.size()))), ' ') + text;
}

std::optional<double> half_of(std::optional<double> length)
{
    if (length)
        *length /= 2;
    return length;
}

std::string text_of(const Row& row)
{
    std::string text = row.name;
    text.resize(25, ' ');
    text += name_of(row.sheet.arrangement);
    text.resize(35, ' ');
    text += column(mm_per_inch / row.sheet.pitch, 2, 6) + column(row.sheet.thickness, 2, 7) +
            column(row.sheet.ior, 3, 7) + column(row.pixels, 2, 8) + column(row.budget, 1, 8) +
            column(row.zone, 0, 7) + column(half_of(row.zone), 0, 7) + column(row.lenses, 0, 7);
    if (!row.whole)
        return text + "          -\n";
    const std::string farthest = row.whole->farthest
                                     ? " to " + with_decimals(*row.whole->farthest, 0)
                                     : "";
    return text + "  from " + with_decimals(row.whole->nearest, 0) + farthest + "\n";
}

Json json_of(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

} // namespace

std::string sheet_list_text(const FrameMetadata& print, bool with_own)
{
    const Film& film = print.film;
    std::string text = "Lens sheets at " + with_digits(mm_per_inch / film.pixel_pitch.x, 6) +
                       " dpi, seen from " + with_digits(print.aperture.distance, 6) + " mm";
    if (film.width > 0)
        text += "; the picture is " + with_decimals(film.width * film.pixel_pitch.x, 1) + " x " +
                with_decimals(film.height * film.pixel_pitch.y, 1) + " mm, " +
                size_text(film.width, film.height) + " pixels";
    text +=
        "\n\n"
        "                                   lenses  thick-         pixels   depth   zone,  jumps "
        " lenses    whole\n"
        "                                  an inch   ness  index  a lens  budget   width    at +-"
        "  across    picture\n";
    for (const Row& row : rows_of(print, with_own))
        text += text_of(row);
    return text +
           "\n"
           "Lengths are in mm. Depth budget: things so far before and behind the sheet are as "
           "sharp "
           "as\n"
           "its lenses. Zone: where the eyes may be, at that distance; past its edges, at +- half "
           "its "
           "width,\n"
           "the picture jumps back to the other side's view. Whole picture: from where an eye "
           "before "
           "the\n"
           "middle sees all of it without a jump. Commercial sheets are nominal: measure yours "
           "(integral\n"
           "print --chart).\n";
}

Json sheet_list_json(const FrameMetadata& print, bool with_own)
{
    Json list = Json::array();
    for (const Row& row : rows_of(print, with_own))
        list.push_back({{"name", row.name},
                        {"arrangement", name_of(row.sheet.arrangement)},
                        {"lenses_per_inch", mm_per_inch / row.sheet.pitch},
                        {"pitch_mm", row.sheet.pitch},
                        {"thickness_mm", row.sheet.thickness},
                        {"ior", row.sheet.ior},
                        {"pixels_per_lens", row.pixels},
                        {"depth_budget_mm", json_of(row.budget)},
                        {"zone_mm", json_of(row.zone)},
                        {"lenses_across", json_of(row.lenses)},
                        {"whole_from_mm", row.whole ? Json(row.whole->nearest) : Json(nullptr)},
                        {"whole_to_mm", row.whole ? json_of(row.whole->farthest) : Json(nullptr)}});
    return list;
}

} // namespace integral
