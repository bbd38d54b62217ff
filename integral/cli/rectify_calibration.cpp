// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/rectify_calibration.h"

#include "integral/analysis/calibration_report.h"
#include "integral/analysis/photo_plane.h"
#include "integral/cli/print_chart.h"
#include "integral/io/image_file.h"

namespace integral {

int read_calibration(const CalibrationOptions& o)
{
    const std::string output = needed_output(o.output, "FILE.json");
    if (output != "-" && extension_of(output) != "json")
        throw UsageError("-o " + output + ": the sheet as measured is a .json");
    check_outputs({output});
    FrameMetadata geometry = nominal_geometry(o.start, o.sheet, o.film);
    set_calibration_page(o.page, geometry.film);
    const double distance = chart_distance(o.distance);
    geometry = chart_geometry(geometry, distance);
    const CalibrationPage page{geometry.sheet, geometry.film, distance};
    calibration_layout(page); // throws before the photo is read
    const Plane photo = luminance_plane(read_scan(o.photo).image, o.threads);
    stop_if_interrupted();
    SheetCalibration found;
    try {
        found = calibrate_sheet(photo, page, o.threads);
    } catch (const std::invalid_argument& error) {
        throw InputError(o.photo + ": " + error.what());
    }
    const std::string report = o.json ? calibration_json(page.sheet, found).dump(2) + "\n"
                                      : calibration_text(page.sheet, found);
    geometry.sheet = calibrated_sheet(page.sheet, found);
    geometry.film.width = geometry.film.height = 0;
    if (const auto filling = filling_aperture(geometry.sheet, geometry.aperture.distance))
        geometry.aperture = *filling;
    write_file(output, to_json(geometry));
    print_figures(report, output == "-");
    return exit_done;
}

} // namespace integral
