// SPDX-License-Identifier: AGPL-3.0-or-later
// A scene in the studio: povray-integral renders its pictures.
#ifndef INTEGRAL_STUDIO_SCENE_INPUT_H
#define INTEGRAL_STUDIO_SCENE_INPUT_H

#include "integral/studio/studio_input.h"

namespace integral {

class SceneInput : public StudioInput {
public:
    /// `scene`: a scene's name (names_scene); `options`: further words for povray-integral, whose
    /// +W and +H give the picture's shape. Throws InputError if the name cannot work.
    SceneInput(const std::string& scene, const std::vector<std::string>& options);

    std::string name() const override;
    const char* kind() const override { return "scene"; }
    const char* unit() const override { return "units"; }
    double aspect() const override;
    std::vector<std::string> files() const override;
    Making probe(const ProbeRequest& request, const ScratchFolder& scratch) override;
    Probe made_probe(const ProbeRequest& request, const ScratchFolder& scratch) override;
    Making print(const PlacementSettings& settings, const FrameMetadata& frame,
                 std::optional<int> draft, const std::string& file) override;
    std::string words(const PlacementSettings& settings,
                      const FrameMetadata& frame) const override;
    SavedPlacement save(const PlacementSettings& settings, const FrameMetadata& frame,
                        const std::string& file) const override;

private:
    std::vector<std::string> words_for(const PlacementSettings& settings,
                                       const FrameMetadata& frame) const;

    const std::string scene_;
    const std::vector<std::string> options_;
};

} // namespace integral

#endif
