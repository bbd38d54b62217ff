// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs the renderer for the studio: probes of a scene, exact drafts of its print, and the print.
#ifndef INTEGRAL_STUDIO_SCENE_RENDERS_H
#define INTEGRAL_STUDIO_SCENE_RENDERS_H

#include "integral/frame/frame.h"
#include "integral/studio/placement_settings.h"
#include "integral/studio/probe.h"

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

/// Renders in the background, one picture at a time: two small probes first (again when the
/// picture's shape changes), then exact drafts as soon as they are requested, and a probe with side
/// views while nothing else is to be done. The print
/// itself waits for the picture under way, and other pictures wait for the print. A change of the
/// scene's files starts this anew. Nothing is rendered while no page listens.
class SceneRenders {
public:
    /// `scene`: a scene's name (names_scene); `options`: further words for povray-integral;
    /// `aspect`: width / height of the print, if known, else the options' +W and +H give it. Throws
    /// InputError if the name cannot work.
    SceneRenders(const std::string& scene, const std::vector<std::string>& options,
                 std::optional<double> aspect);
    ~SceneRenders();

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

    /// The words of povray-integral's command line for drafts and print, which are also lines of a
    /// settings file.
    std::vector<std::string> words_for(const PlacementSettings& settings,
                                       const FrameMetadata& frame) const;

    /// The state as JSON on one line: probe (its number; 0: none), exact (its request's number; 0:
    /// none), draft and seconds of that, printing (whether the print is being rendered, or waits),
    /// print (the file of the newest print, or null), print_word (the same as a word for a shell),
    /// work (what is being rendered: "probe", "exact", "print" or null), progress (0 to 1), problem
    /// (why the scene cannot be rendered, or null).
    std::string state() const;

    /// A page that listens: counted from its construction to its destruction.
    class Listener {
    public:
        explicit Listener(SceneRenders& renders);
        ~Listener();
        /// Waits for a change of the state, at most some seconds; returns the new state, or an
        /// empty text if nothing has changed; nothing after end().
        std::optional<std::string> next_state();

    private:
        SceneRenders& renders_;
        int sent_changes_ = -1;
    };

    // For the program's first thread.

    /// Starts, watches and ends the renderer. Call it several times a second.
    void work();
    /// Ends the renderer and all listeners' streams.
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
    void begin(std::unique_ptr<Job> job, const std::vector<std::string>& words);
    void watch_job();
    void finish(const Job& job);

    const std::string scene_;
    const std::vector<std::string> options_;

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
    std::vector<std::pair<std::string, std::string>> files_; ///< of the scene, with their stamps
    bool is_watching_ = false;                               ///< whether files_ has been filled
    Clock::time_point watched_;                              ///< when files_ were last looked at
};

} // namespace integral

#endif
