// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/exr_views.h"

#include "integral/frame/depth_attribute.h"

#include <ImfChannelList.h>
#include <ImfMultiView.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace integral {
namespace {

/// The channels of one layer of one view, in one part of the file.
struct Group {
    int part = 0;
    std::string view, layer;
    std::map<std::string, std::string> channels; ///< full names by "r", "g", "b", "a", "y", ...

    bool has(const char* name) const { return channels.count(name) > 0; }
    bool is_colour() const { return has("r") && has("g") && has("b"); }
    bool is_grey() const { return has("y") && !has("ry"); }
};

std::string lower_case(std::string text)
{
    for (char& c : text)
        c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return text;
}

std::string after_last_dot(const std::string& name)
{
    const auto dot = name.rfind('.');
    return dot == std::string::npos ? name : name.substr(dot + 1);
}

/// Adds a channel to the group of its view and layer.
void add_channel(std::vector<Group>& groups, int part, const std::string& channel,
                 const std::string& view, const std::string& name_without_view)
{
    const auto dot = name_without_view.rfind('.');
    const std::string layer = dot == std::string::npos ? "" : name_without_view.substr(0, dot);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
        return g.part == part && g.view == view && g.layer == layer;
    });
    if (group == groups.end())
        group = groups.insert(groups.end(), Group{part, view, layer, {}});
    group->channels.emplace(lower_case(after_last_dot(name_without_view)), channel);
}

std::vector<Group> groups_of(const std::vector<Imf::Header>& headers)
{
    std::vector<Group> groups;
    for (int part = 0; part < int(headers.size()); ++part) {
        const Imf::Header& header = headers[std::size_t(part)];
        if (header.hasType() && header.type() == Imf::DEEPTILE)
            continue;
        const Imf::StringVector views = Imf::hasMultiView(header) ? Imf::multiView(header)
                                                                  : Imf::StringVector();
        const Imf::ChannelList& channels = header.channels();
        for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
            const std::string name = channel.name();
            const std::string view = !views.empty()     ? Imf::viewFromChannelName(name, views)
                                     : header.hasView() ? header.view()
                                                        : "";
            add_channel(groups, part, name, view,
                        views.empty() ? name : Imf::removeViewName(name, view));
        }
    }
    return groups;
}

ExrView view_of(const Group& group)
{
    ExrView view{group.part, group.view, {}};
    const bool colour = group.is_colour();
    for (const char* name : {colour ? "r" : "y", colour ? "g" : "y", colour ? "b" : "y"})
        view.channels.push_back(group.channels.at(name));
    if (group.has("a"))
        view.channels.push_back(group.channels.at("a"));
    return view;
}

std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

template <class Name> std::vector<std::string> names_of(const std::vector<Group>& groups, Name name)
{
    std::vector<std::string> names;
    for (const Group& group : groups)
        if (std::find(names.begin(), names.end(), name(group)) == names.end())
            names.push_back(name(group));
    return names;
}

/// The layer that is the picture, in a file whose colours are all in layers.
std::string main_layer(const std::vector<std::string>& layers)
{
    if (layers.size() == 1)
        return layers[0];
    std::vector<std::string> chosen;
    for (const std::string& layer : layers)
        for (const char* name : {"beauty", "combined", "rgba", "rgb", "composite", "image"})
            if (lower_case(after_last_dot(layer)) == name)
                chosen.push_back(layer);
    if (chosen.size() == 1)
        return chosen[0];
    throw std::runtime_error("it has no channels R, G and B, but layers: " + joined(layers) +
                             "; save the one that is meant by itself");
}

/// Whether channel Y of a part contains depths.
bool has_depths(const Imf::Header& header) { return header.find(depth_attribute) != header.end(); }

/// The groups that have colours; if there are none, the grey groups.
std::vector<Group> pictures_of(const std::vector<Imf::Header>& headers)
{
    std::vector<Group> colours, greys;
    for (Group& group : groups_of(headers))
        if (group.is_colour())
            colours.push_back(std::move(group));
        else if (group.is_grey() && !has_depths(headers[std::size_t(group.part)]))
            greys.push_back(std::move(group));
    if (colours.empty() && greys.empty())
        throw std::runtime_error(std::any_of(headers.begin(), headers.end(), has_depths)
                                     ? "it contains depths, not a picture"
                                     : "it has no channels R, G and B");
    return colours.empty() ? greys : colours;
}

/// Sorts views from the left: of two, the one named "left" first; others in the file's order.
void put_left_first(std::vector<ExrView>& views, const std::vector<Imf::Header>& headers)
{
    const Imf::StringVector order = Imf::hasMultiView(headers[0]) ? Imf::multiView(headers[0])
                                                                  : Imf::StringVector();
    const auto place = [&](const ExrView& view) {
        if (views.size() == 2 && lower_case(view.name) == "left")
            return std::ptrdiff_t(-1);
        return std::find(order.begin(), order.end(), view.name) - order.begin();
    };
    std::vector<std::pair<std::ptrdiff_t, ExrView>> placed;
    for (const ExrView& view : views)
        placed.emplace_back(place(view), view);
    std::stable_sort(placed.begin(), placed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < views.size(); ++k)
        views[k] = std::move(placed[k].second);
}

} // namespace

ExrViews exr_views(const std::vector<Imf::Header>& headers)
{
    const std::vector<Group> pictures = pictures_of(headers);
    const auto layers = names_of(pictures, [](const Group& g) { return g.layer; });
    const bool has_own = std::find(layers.begin(), layers.end(), "") != layers.end();
    const std::string layer = has_own ? "" : main_layer(layers);
    ExrViews chosen;
    std::vector<std::string> parts;
    for (const Group& group : pictures) {
        if (group.layer != layer)
            continue;
        const bool known = std::any_of(chosen.views.begin(), chosen.views.end(),
                                       [&](const ExrView& v) { return v.name == group.view; });
        const bool viewless = !chosen.views.empty() &&
                              (group.view.empty() || chosen.views[0].name.empty());
        if (!known && !viewless)
            chosen.views.push_back(view_of(group));
        else if (headers[std::size_t(group.part)].hasName())
            parts.push_back(headers[std::size_t(group.part)].name());
    }
    put_left_first(chosen.views, headers);
    if (!layer.empty())
        chosen.notice = "it has no channels R, G and B but layers; its layer " + layer + " is read";
    else if (!parts.empty())
        chosen.notice = "its first picture is read; further parts: " + joined(parts);
    return chosen;
}

} // namespace integral
