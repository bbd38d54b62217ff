// SPDX-License-Identifier: AGPL-3.0-or-later
// Pictures with depth in the studio: a photograph, a stereo pair, a frame or views of eyes.
#ifndef INTEGRAL_STUDIO_PICTURE_INPUT_H
#define INTEGRAL_STUDIO_PICTURE_INPUT_H

#include "integral/depth/relief_input.h"
#include "integral/studio/studio_input.h"

#include <mutex>
#include <optional>

namespace integral {

/// Pictures with depth as a scene. Its eye is request.distance mm (a scene unit is 1 mm) from a
/// window as wide as request.size. A surface of parallax p (relief.h) is distance / (1 - p) from
/// the eye, so that a placement in this scene is a change of the depths' range (ReliefInput,
/// place), and `integral views --to-frame --depth-range` makes the print.
class PictureInput : public StudioInput {
public:
    /// `words`: the inputs and options of `integral views` that describe `request`. Reads the
    /// inputs; only then are notices about depths reported to the user. Throws as read_relief does.
    PictureInput(const std::vector<std::string>& inputs, const std::vector<std::string>& words,
                 const ReliefRequest& request, const Progress& progress);

    std::string name() const override;
    const char* kind() const override { return "picture"; }
    const char* unit() const override { return "mm"; }
    double aspect() const override { return aspect_; }
    std::vector<std::string> files() const override;
    void forget() override;
    Making probe(const ProbeRequest& request, const ScratchFolder& scratch) override;
    Probe made_probe(const ProbeRequest& request, const ScratchFolder& scratch) override;
    Making print(const PlacementSettings& settings, const FrameMetadata& frame,
                 std::optional<int> draft, const std::string& file) override;
    std::string words(const PlacementSettings& settings, const FrameMetadata& frame) const override;
    SavedPlacement save(const PlacementSettings& settings, const FrameMetadata& frame,
                        const std::string& file) const override;

private:
    ReliefInput placed(const ReliefRequest& request, const Progress& progress);
    void set_ends();
    DepthSpan depth_range(const FrameMetadata& frame) const;
    std::string command(const FrameMetadata& frame, const std::string& sheet,
                        const std::string& file) const;

    const std::vector<std::string> inputs_, words_;
    ReliefRequest request_; ///< without notices
    double aspect_ = 1;
    bool has_eyes_ = false; ///< the pictures are from several eyes

    // Used by one thread at a time.
    std::optional<ReliefInput> relief_; ///< before place(); empty: not read
    double read_distance_ = 0;          ///< request.distance of relief_
    Probe probe_;                       ///< the one made last

    mutable std::mutex mutex_;
    ParallaxSpan ends_; ///< in the scene, of the depths that place() puts at request.ends
};

} // namespace integral

#endif
