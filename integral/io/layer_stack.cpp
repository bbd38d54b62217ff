// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/layer_stack.h"

#include <charconv>
#include <cstring>
#include <expat.h>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace integral {
namespace {

constexpr int max_side = 1 << 20; // pixels
constexpr std::size_t max_depth = 64, max_layers = 10000;

/// Makes the tree of layers while the parser goes through the text.
struct Builder {
    LayerStack stack;
    std::vector<StackedLayer*> open; ///< around the place of the parser; null: not of a layer
    std::size_t layers = 0;
    bool has_root = false;
    std::string error; ///< the first one

    void fail(const std::string& what)
    {
        if (error.empty())
            error = what;
    }

    /// Reads a number; whole ones may have decimals of 0, as some programs write them.
    template <class Number>
    void read(const char* name, const char* text, Number least, Number most, Number& to)
    {
        double value = 0;
        const char* end = text + std::strlen(text);
        const auto [stop, code] = std::from_chars(text, end, value);
        if (code != std::errc() || stop != end || !(value >= least && value <= most) ||
            Number(value) != value)
            fail(std::string("its stack.xml has ") + name + "=\"" + text + "\"; a " +
                 (std::is_integral_v<Number> ? "whole number" : "number") + " from " +
                 std::to_string(int(least)) + " to " + std::to_string(int(most)) + " is expected");
        else
            to = Number(value);
    }

    void read_canvas(const char** attributes)
    {
        for (; *attributes; attributes += 2)
            if (std::strcmp(attributes[0], "w") == 0)
                read("w", attributes[1], 1, max_side, stack.width);
            else if (std::strcmp(attributes[0], "h") == 0)
                read("h", attributes[1], 1, max_side, stack.height);
    }

    StackedLayer layer_of(const char** attributes)
    {
        StackedLayer layer;
        layer.blending = "svg:src-over";
        for (; *attributes; attributes += 2) {
            const std::string name = attributes[0];
            const char* value = attributes[1];
            if (name == "name")
                layer.name = value;
            else if (name == "src")
                layer.source = value;
            else if (name == "composite-op")
                layer.blending = value;
            else if (name == "x")
                read("x", value, -max_side, max_side, layer.left);
            else if (name == "y")
                read("y", value, -max_side, max_side, layer.top);
            else if (name == "opacity")
                read("opacity", value, 0.0, 1.0, layer.opacity);
            else if (name == "visibility")
                layer.visible = std::strcmp(value, "hidden") != 0;
        }
        return layer;
    }

    void begin(const std::string& element, const char** attributes)
    {
        StackedLayer* parent = open.empty() ? nullptr : open.back();
        StackedLayer* here = nullptr;
        const bool is_group = element == "stack", is_layer = element == "layer";
        if (open.size() >= max_depth)
            fail("its groups lie more than " + std::to_string(max_depth) + " deep in each other");
        else if (open.empty() && element == "image")
            read_canvas(attributes);
        else if (is_group && open.size() == 1 && !has_root) {
            has_root = true;
            stack.root = layer_of(attributes);
            here = &stack.root;
        } else if (parent && parent->source.empty() && (is_group || is_layer)) {
            if (++layers > max_layers)
                fail("it has more than " + std::to_string(max_layers) + " layers");
            parent->inside.push_back(layer_of(attributes));
            here = &parent->inside.back();
            if (is_group)
                here->source.clear();
            else if (here->source.empty())
                fail("its layer \"" + here->name + "\" has no picture");
        }
        open.push_back(here);
    }
};

struct FreeParser {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

} // namespace

LayerStack layer_stack_of(const std::string& xml)
{
    using Parser = std::unique_ptr<std::remove_pointer_t<XML_Parser>, FreeParser>;
    const Parser parser(XML_ParserCreate(nullptr));
    Builder builder;
    XML_SetUserData(parser.get(), &builder);
    XML_SetElementHandler(
        parser.get(),
        [](void* data, const char* element, const char** attributes) {
            auto& built = *static_cast<Builder*>(data);
            if (built.error.empty())
                built.begin(element, attributes);
        },
        [](void* data, const char*) {
            auto& built = *static_cast<Builder*>(data);
            if (built.error.empty())
                built.open.pop_back();
        });
    constexpr std::size_t most = 64 << 20; // bytes
    if (xml.size() > most)
        throw std::runtime_error("its stack.xml has more than 64 MB");
    if (XML_Parse(parser.get(), xml.data(), int(xml.size()), 1) != XML_STATUS_OK)
        builder.fail(std::string("its stack.xml is no XML: ") +
                     XML_ErrorString(XML_GetErrorCode(parser.get())) + " in line " +
                     std::to_string(XML_GetCurrentLineNumber(parser.get())));
    if (!builder.has_root || builder.stack.width < 1 || builder.stack.height < 1)
        builder.fail("its stack.xml describes no picture of layers");
    if (!builder.error.empty())
        throw std::runtime_error(builder.error);
    return std::move(builder.stack);
}

} // namespace integral
