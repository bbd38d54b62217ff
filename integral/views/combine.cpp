// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/combine.h"

#include "integral/base/interrupt.h"
#include "integral/frame/geometry_difference.h"
#include "integral/io/frame_rows.h"
#include "integral/views/covered_means.h"
#include "integral/views/made_frame.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace integral {
namespace {

/// A frame and its depth frame.
struct CombinedFrame {
    explicit CombinedFrame(const std::string& path) : file(path) {}

    FrameReader file;
    DepthFrame depths;
};

/// Throws std::invalid_argument unless the geometry of `path` is that of `other`.
void check_same(const std::string& path, const FrameMetadata& geometry, const std::string& other,
                const FrameMetadata& expected)
{
    if (const auto difference = geometry_difference(geometry, expected))
        throw std::invalid_argument(path + ": its " + difference->path + " is " +
                                    difference->first + ", and that of " + other + " is " +
                                    difference->second +
                                    "; make both frames for one sheet, film and viewer");
}

std::unique_ptr<CombinedFrame> read_one(const std::string& path, const std::string& given_depth)
{
    auto frame = std::make_unique<CombinedFrame>(path);
    frame->file.require_metadata();
    frame->file.refuse_projection();
    const auto& render = frame->file.frame().metadata->render;
    if (render && render->draft > 1)
        throw InputError(path + ": it is a draft; render it without Integral_Draft");
    const std::string depth = given_depth.empty() ? depth_beside(path) : given_depth;
    if (given_depth.empty() && !std::filesystem::exists(depth))
        throw InputError(path + ": its depth frame " + depth +
                         " is missing; write it with Integral_Depth_Image or integral layers "
                         "--depth, or name it with --depth");
    frame->depths = read_depths(depth);
    check_same(depth, frame->depths.metadata, path, *frame->file.frame().metadata);
    return frame;
}

/// One frame's part of a merged pixel.
struct Part {
    float depth = 0;
    std::size_t frame = 0;
    Colour colour; ///< linear light, premultiplied
};

/// A merged pixel.
struct Merged {
    Colour colour{0, 0, 0, 0};
    float depth = 0;
    std::size_t nearest = 0; ///< index of the frame that supplies the depth
};

/// Sorts the parts from the front to the back and merges them.
Merged merged(std::vector<Part>& parts)
{
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.depth < b.depth; });
    Merged all{{0, 0, 0, 0}, parts[0].depth, parts[0].frame};
    const auto solid = std::find_if(parts.begin(), parts.end(),
                                    [](const Part& part) { return part.colour.a >= 0.5f; });
    if (solid != parts.end()) {
        all.depth = solid->depth;
        all.nearest = solid->frame;
    }
    float open = 1; // the share of light that the parts so far let through
    for (const Part& part : parts) {
        if (!(open > 0))
            break;
        add(all.colour, open, part.colour);
        open *= 1 - part.colour.a;
    }
    return all;
}

/// The frames, read some rows at a time, and their merged depth.
class Merger {
public:
    explicit Merger(const CombineRequest& request) : keeps_depths_(!request.depth_output.empty())
    {
        for (std::size_t k = 0; k < request.frames.size(); ++k) {
            stop_if_interrupted();
            frames_.push_back(
                read_one(request.frames[k], request.depths.empty() ? "" : request.depths[k]));
            check_same(request.frames[k], metadata(k), request.frames[0], metadata(0));
        }
        shares_.resize(frames_.size());
    }

    const FrameMetadata& metadata(std::size_t k) const
    {
        return *frames_[k]->file.frame().metadata;
    }

    /// The form of the merged frame.
    Image form(std::optional<int> bits) const
    {
        int most = 8;
        bool transparent = true;
        for (const auto& frame : frames_) {
            most = std::max(most, sample_bits(frame->file.frame().image));
            transparent = transparent && frame->file.frame().image.channels == 4;
        }
        const Image& first = frames_[0]->file.frame().image;
        const int stored = bits.value_or(most);
        Image form = form_of(stored, first.width, first.height, transparent ? 4 : 3,
                             encoding_of_made(stored, first));
        form.premultiplied = transparent && first.premultiplied;
        return form;
    }

    /// Reads the next rows of all frames and merges them into `band`, whose first row is `first`.
    bool draw(int first, Image& band, int threads, const Progress& progress)
    {
        std::vector<Image> bands;
        std::vector<LinearReader> light;
        for (auto& frame : frames_) {
            bands.push_back(blank_like(frame->file.frame().image, band.width, band.height));
            frame->file.read(bands.back());
        }
        for (const Image& own : bands)
            light.emplace_back(own);
        return for_each_row(
            band.height, threads,
            [&](int y) {
                CombinedShares nearest(frames_.size());
                std::vector<Part> parts(frames_.size());
                for (int x = 0; x < band.width; ++x) {
                    const std::size_t pixel = std::size_t(first + y) * band.width + std::size_t(x);
                    bool imaged = false;
                    for (std::size_t k = 0; k < parts.size(); ++k) {
                        const DepthFrame& own = frames_[k]->depths;
                        const bool shows = own.imaged[pixel] > 0;
                        imaged = imaged || shows;
                        parts[k] = {shows && !std::isnan(own.depth[pixel])
                                        ? own.depth[pixel]
                                        : std::numeric_limits<float>::infinity(),
                                    k, light[k](x, y)};
                        parts[k].colour.a = share_of(parts[k].colour.a);
                    }
                    const Merged all = merged(parts);
                    store_linear(band, x, y, all.colour);
                    if (keeps_depths_) {
                        DepthFrame& merged_depths = frames_[0]->depths;
                        merged_depths.imaged[pixel] = imaged ? 1 : 0;
                        merged_depths.depth[pixel] = imaged ? all.depth : 0;
                    }
                    nearest[all.nearest] += imaged ? 1 : 0;
                }
                add_shares(nearest);
            },
            progress);
    }

    /// Moves the merged depths out; drawn only if CombineRequest::depth_output is set.
    DepthFrame take_depths() { return std::move(frames_[0]->depths); }

    /// The frames' shares of the imaged pixels.
    CombinedShares shares() const
    {
        double all = 0;
        for (const double pixels : shares_)
            all += pixels;
        CombinedShares shares = shares_;
        for (double& share : shares)
            share /= std::max(1.0, all);
        return shares;
    }

private:
    void add_shares(const CombinedShares& row)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (std::size_t k = 0; k < row.size(); ++k)
            shares_[k] += row[k];
    }

    bool keeps_depths_; ///< whether the first frame's depths become the merged ones, pixel by pixel
    std::vector<std::unique_ptr<CombinedFrame>> frames_;
    CombinedShares shares_; ///< in pixels
    std::mutex mutex_;
};

} // namespace

std::string depth_beside(const std::string& frame)
{
    std::filesystem::path path(frame);
    return path.replace_extension().string() + "-depth.exr";
}

CombinedShares write_combined(const CombineRequest& request, const Progress& progress)
{
    Merger merger(request);
    FrameMetadata geometry = merger.metadata(0);
    remove_scene(geometry);
    Frame form{merger.form(request.bits), std::nullopt};
    geometry.encoding = form.image.encoding;
    set_metadata(form, geometry);
    write_drawn_rows(request.output, merger, form, request.threads, progress);
    if (!request.depth_output.empty()) {
        DepthFrame depths = merger.take_depths();
        depths.metadata = geometry;
        depths.eye_distances.clear();
        write_depths(request.depth_output, depths);
    }
    return merger.shares();
}

} // namespace integral
