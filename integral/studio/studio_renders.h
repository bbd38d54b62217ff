// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs the making of the studio's pictures: probes of its input, exact drafts of the print, and the
// print.
#ifndef INTEGRAL_STUDIO_STUDIO_RENDERS_H
#define INTEGRAL_STUDIO_STUDIO_RENDERS_H

#include "integral/frame/frame.h"
#include "integral/studio/studio_input.h"

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>

namespace integral {

/// A draft of the print, and the settings that it was made for.
struct ExactDraft {
    int number = 0; ///< of its request
    int draft = 1;  ///< pixels of the print across a pixel of the draft
    double seconds = 0;
    Frame frame; ///< with the print's pixels (with_final_pixels), 8-bit sRGB with alpha
};

/// Runs the making of pictures in the background, one at a time: two small probes first (again when
/// the picture's shape changes), then exact drafts as soon as they are requested, and a probe with
/// side views while nothing else is to be done. The print itself waits for the picture under way,
/// and other pictures wait for the print. A change of the input's files starts this anew. Nothing
/// is made while no page listens.
class StudioRenders {
public:
    /// `input` must outlive this. `aspect`: width / height of the print, if known, else the
    /// input's.
    StudioRenders(StudioInput& input, std::optional<double> aspect);
    ~StudioRenders();

    // For any thread.

    /// The newest probe and the newest exact draft; null: none yet.
    std::shared_ptr<const Probe> probe() const;
    std::shared_ptr<const ExactDraft> exact() const;

    /// Requests the exact draft for settings. Ends the work on an earlier one.
    void request_exact(int number, const PlacementSettings& settings);
    /// Ends the work on that exact draft.
    void stop_exact(int number);

    /// Requests the print for settings, anti-aliased, as `file` (.png).
    void request_print(const PlacementSettings& settings, const std::string& file);
    /// Ends the work on the print.
    void stop_print();
    /// The newest print's file; empty: none yet.
    std::string print() const;

    /// The state as JSON on one line: probe (its number; 0: none), exact (its request's number; 0:
    /// none), draft and seconds of that, printing (whether the print is being rendered, or waits),
    /// print (the file of the newest print, or null), print_word (the same as a word for a shell),
    /// work (what is being made: "probe", "exact", "print" or null), progress (0 to 1), problem
    /// (why no picture can be made, or null).
    std::string state() const;

    /// A page that listens: counted from its construction to its destruction.
    class Listener {
    public:
        explicit Listener(StudioRenders& renders);
        ~Listener();
        /// Waits for a change of the state, at most some seconds; returns the new state, or an
        /// empty text if nothing has changed; nothing after end().
        std::optional<std::string> next_state();

    private:
        StudioRenders& renders_;
        int sent_changes_ = -1;
    };

    // For the program's first thread.

    /// Starts, watches and ends the making of pictures. Call it several times a second.
    void work();
    /// Ends the making of pictures, and all listeners' streams.
    void end();

private:
    using Clock = std::chrono::steady_clock;
    struct Job;
    struct ExactRequest {
        int number = 0;
        PlacementSettings settings;
    };
    struct PrintRequest {
        std::string file;
        PlacementSettings settings;
    };

    void change();
    bool is_urgent(const ProbeRequest& request) const;
    void watch_files();
    bool is_abandoned();
    void begin_probe(const ProbeRequest& request);
    void begin_exact(const ExactRequest& request);
    void begin_print(const PrintRequest& request);
    void begin(std::unique_ptr<Job> job, const Making& making);
    void watch_job();
    static bool has_ended(Job& job);
    void finish(const Job& job);

    StudioInput& input_;

    mutable std::mutex mutex_; ///< guards the following
    std::condition_variable changed_;
    int changes_ = 0; ///< of the state
    bool ended_ = false;
    int listeners_ = 0;
    Clock::time_point left_ = Clock::now(); ///< when the last listener went
    std::shared_ptr<const Probe> probe_;
    int probe_number_ = 0;
    std::optional<ProbeRequest> next_probe_;
    std::shared_ptr<const ExactDraft> exact_;
    std::optional<ExactRequest> next_exact_;
    int requested_exact_ = 0; ///< number of the request that is not stopped; 0: none
    std::optional<PrintRequest> next_print_;
    bool print_is_stopped_ = false;
    std::string print_; ///< the newest print's file
    std::string work_, problem_;
    double progress_ = 0;

    // Used by the first thread alone.
    std::unique_ptr<Job> job_;
    std::vector<std::pair<std::string, std::string>> files_; ///< of the input, with their stamps
    bool is_watching_ = false;                               ///< whether files_ has been filled
    Clock::time_point watched_;                              ///< when files_ were last looked at
};

} // namespace integral

#endif
