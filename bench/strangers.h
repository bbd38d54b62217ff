// SPDX-License-Identifier: AGPL-3.0-or-later
// The parts of bench/strangers: a table of measurements on scenes not made for this project, which
// is continued from run to run, and the page that is made of it.
#ifndef BENCH_STRANGERS_H
#define BENCH_STRANGERS_H

#include "bench/renderer.h"

#include "integral/frame/error_estimate.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace integral::bench {

/// One frame: a scene behind a sheet, at one setting.
struct StrangersRow {
    double cpu_seconds = 0; ///< of tracing, without parsing; the least of the runs
    double error = 0;       ///< RMSE over the lit pixels, without the references' own errors
    double floor = 0;       ///< the error of the mean of both references
    std::optional<ErrorEstimate> estimate; ///< the program's estimate of `error`
};

/// One scene behind one sheet: its frames, by their settings' full names.
using StrangersPanel = std::map<std::string, StrangersRow>;

/// Everything measured so far, in a file that grows by a line for each frame, so that a run can
/// continue an interrupted one.
class StrangersTable {
public:
    /// Reads `file` if it exists. Throws std::runtime_error with the line if a line does not have
    /// this table's format.
    explicit StrangersTable(const std::string& file);

    /// A scene and a sheet. `setting` is a setting's full name.
    using Key = std::pair<std::string, std::string>;
    const StrangersRow* find(const Key& panel, const std::string& setting) const;
    void add(const Key& panel, const std::string& setting, const StrangersRow& row);

    /// Records why a scene is left out: the renderer fails, or it takes too long. Rows that are
    /// added later cancel this.
    void leave_out(const std::string& scene, const std::string& reason);

    /// The kind of a scene's lighting, such as "matte under point lights"; null if not known.
    const std::string* kind(const std::string& scene) const;
    void set_kind(const std::string& scene, const std::string& kind);

    const std::map<Key, StrangersPanel>& panels() const { return panels_; }
    const std::map<std::string, std::string>& left_out() const { return left_out_; }

private:
    void append(const std::string& line) const;
    void read_line(const std::string& line);

    std::string file_;
    std::map<Key, StrangersPanel> panels_;
    std::map<std::string, std::string> left_out_, kinds_;
};

/// Settings of brute force: a fixed number of samples for every pixel, from one upwards.
const std::vector<Setting>& brute_force_settings();
/// Settings of +A in the light field, by falling threshold.
const std::vector<Setting>& antialias_settings();
/// Such settings without reconstruction.
const std::vector<Setting>& settings_without_reconstruction();

/// The time of brute force at equal error, divided by the time of +A: above 1, +A is faster. If +A
/// errs more than one ray a pixel, the time of one ray a pixel counts as brute force's. Nothing if
/// a frame is missing, if one ray a pixel errs by less than 0.001, or if the error is less than the
/// references' own or than brute force's least.
std::optional<double> speed_up(const StrangersPanel& panel, const Setting& setting);
/// The time of +A, divided by the time of +A without reconstruction at equal error: below 1,
/// reconstruction pays. Nothing if a frame is missing, or if the error is less than the references'
/// own or outside the range of errors without reconstruction.
std::optional<double> time_to_that_without(const StrangersPanel& panel, const Setting& setting);

/// The page, in Markdown: the distribution over all scenes and sheets, then each of them.
std::string strangers_page(const StrangersTable& table);
/// Writes FOLDER/strangers.svg and .png: speed-ups in rising order, one curve a threshold.
void write_strangers_plot(const StrangersTable& table, const std::string& folder);

} // namespace integral::bench

#endif
