// SPDX-License-Identifier: AGPL-3.0-or-later
// The parts of bench/strangers: what was measured of scenes that nobody here made, kept in a table
// from run to run, and the page that is made of it.
#ifndef BENCH_STRANGERS_H
#define BENCH_STRANGERS_H

#include "bench/renderer.h"

#include "integral/lightfield/error_estimate.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace integral::bench {

/// One frame: a scene behind a sheet, at one setting.
struct StrangersRow {
    double cpu_seconds = 0; ///< of tracing, without parsing; the least of the runs
    double error = 0;       ///< RMSE over the lit pixels, freed of the references' own errors
    double floor = 0;       ///< the error of the mean of both references
    std::optional<ErrorEstimate> estimate; ///< the program's, of `error`
};

/// One scene behind one sheet: its frames, by their settings' full names.
using StrangersPanel = std::map<std::string, StrangersRow>;

/// Everything measured so far, in a file that grows by a line for each frame, so that a run that
/// was ended goes on where it was.
class StrangersTable {
public:
    /// Reads FILE if there is one. Throws std::runtime_error, with the line, where it is not one of
    /// ours.
    explicit StrangersTable(const std::string& file);

    /// By scene and sheet, and the setting's full name.
    using Key = std::pair<std::string, std::string>;
    const StrangersRow* find(const Key& panel, const std::string& setting) const;
    void add(const Key& panel, const std::string& setting, const StrangersRow& row);

    /// Says why a scene is not judged: the renderer refuses it, or it takes too long. It is judged
    /// all the same if rows are added later.
    void leave_out(const std::string& scene, const std::string& reason);

    /// What its light needs ("matte under point lights"); null: not known.
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

/// Brute force: so many samples for every pixel, the plainest first.
const std::vector<Setting>& brute_force_settings();
/// +A in the light field by falling threshold.
const std::vector<Setting>& antialias_settings();
/// The same without reconstruction.
const std::vector<Setting>& settings_without_reconstruction();

/// The time of brute force for the same error, divided by that of +A: above 1, +A is the faster.
/// Where +A errs more than a single ray, that ray's time stands for brute force's. Nothing where a
/// frame is missing, where one ray a pixel errs by less than 0.001, and where the error is less than
/// the reference's own, or less than brute force's least.
std::optional<double> speed_up(const StrangersPanel& panel, const Setting& setting);
/// The time of +A, divided by that of +A without reconstruction for the same error: below 1,
/// reconstruction pays. Nothing where a frame is missing, where the error is less than the
/// reference's own, or not between those without reconstruction.
std::optional<double> time_to_that_without(const StrangersPanel& panel, const Setting& setting);

/// The page, in Markdown: the distribution over all scenes and sheets, then each of them.
std::string strangers_page(const StrangersTable& table);
/// FOLDER/strangers.svg and .png: speed-ups in rising order, one curve a threshold.
void write_strangers_plot(const StrangersTable& table, const std::string& folder);

} // namespace integral::bench

#endif
