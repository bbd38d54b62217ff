// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/panel.h"

namespace integral {
namespace {

/// The calibration that the maker's software uses for a display whose own calibration is unknown.
LookingGlassCalibration nominal(double pitch, double slope, double center, double view_cone,
                                double dpi, int width, int height)
{
    LookingGlassCalibration calibration;
    calibration.pitch = pitch;
    calibration.slope = slope;
    calibration.center = center;
    calibration.view_cone = view_cone;
    calibration.dpi = dpi;
    calibration.width = width;
    calibration.height = height;
    return calibration;
}

/// The calibration with two kinds of subpixel cells, which alternate by column or by row, counted
/// from the top left.
LookingGlassCalibration with_cells(LookingGlassCalibration calibration, CellPattern pattern,
                                   const PixelCell& first, const PixelCell& second)
{
    calibration.cells.order = Subpixels::cells;
    calibration.cells.pattern = pattern;
    calibration.cells.number = 2;
    calibration.cells.cell[0] = first;
    calibration.cells.cell[1] = second;
    return calibration;
}

Panel named(const char* name, Panel panel)
{
    panel.name = name;
    return panel;
}

Panel looking_glass(const char* name, const LookingGlassCalibration& calibration)
{
    return named(name, panel_from(calibration));
}

/// The thesis's display: an NEC LCD with RGB stripes and pixels of 0.207 mm behind the 1.27 mm
/// sheet, which gives about six pixels for each lens. The thesis states 10 inches; 1024 x 768 such
/// pixels have a diagonal of 10.4 inches. Other thesis figures give the viewing distance, 300 mm.
Panel thesis()
{
    Panel panel;
    panel.name = "thesis-lcd";
    panel.film = {1024, 768, {0.207, 0.207}, Subpixels::rgb};
    panel.sheet = {Arrangement::lenticular, 1.27, 3.08, 1.6, 0, {}};
    panel.aperture = *filling_aperture(panel.sheet, 300);
    return panel;
}

std::vector<Panel> make_panels()
{
    // The three colours of a pixel form a triangle; in the other cell the triangle is upside down.
    const PixelCell blue_below{{{-0.31, 0.25}, {0.28, 0.25}, {0, -0.25}}},
        blue_above{{{-0.31, -0.25}, {0.28, -0.25}, {0, 0.25}}};
    const PixelCell blue_right{{{-0.25, -0.31}, {-0.25, 0.28}, {0.25, 0}}},
        blue_left{{{0.25, -0.31}, {0.25, 0.28}, {-0.25, 0}}};
    const CellPattern columns = CellPattern::columns, rows = CellPattern::rows;
    // The values are from the maker's list of device templates. That list counts rows from the
    // bottom; with an even number of rows, the top row therefore has the second cell.
    return {
        thesis(),
        looking_glass("looking-glass-portrait", nominal(52, -7, 0.5, 40, 324, 1536, 2048)),
        looking_glass("looking-glass-go", nominal(80.7, -6.3, -0.3, 54, 491, 1440, 2560)),
        looking_glass("looking-glass-16-landscape",
                      with_cells(nominal(44.72, -6.9, 0.5, 50, 283, 3840, 2160), columns,
                                 blue_below, blue_above)),
        looking_glass(
            "looking-glass-16-portrait",
            with_cells(nominal(44.72, -7.45, 0, 50, 283, 2160, 3840), rows, blue_left, blue_right)),
        looking_glass("looking-glass-32-landscape", nominal(75, -7.2, -0.2, 50, 280, 7680, 4320)),
        looking_glass("looking-glass-32-portrait",
                      with_cells(nominal(80.7, -6.3, -0.3, 54, 280, 4320, 7680), columns,
                                 blue_below, blue_above)),
        looking_glass("looking-glass-65", nominal(42, -6, 0.3, 40, 136, 7680, 4320)),
        looking_glass("looking-glass-16-gen2", nominal(50, -7, 0.5, 40, 283, 3840, 2160)),
        looking_glass("looking-glass-32-gen2", nominal(42, -6, 0.3, 40, 280, 7680, 4320)),
        looking_glass("looking-glass-8-9",
                      nominal(49.79978561401367, 5.48, 0, 40, 338, 2560, 1600)),
        looking_glass("looking-glass-15-6",
                      nominal(50.07143783569336, -7.7, 0, 40, 283, 3840, 2160)),
        looking_glass("looking-glass-8k", nominal(38.0545883178711, -7.7, 0, 40, 280, 7680, 4320)),
    };
}

} // namespace

const std::vector<Panel>& known_panels()
{
    static const std::vector<Panel> panels = make_panels();
    return panels;
}

std::optional<Panel> panel_named(const std::string& name)
{
    for (const Panel& panel : known_panels())
        if (panel.name == name)
            return panel;
    return std::nullopt;
}

} // namespace integral
