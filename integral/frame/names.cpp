// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/names.h"

#include <cstddef>

namespace integral {
namespace {

template <class Kind> struct Name {
    Kind kind;
    const char* word;
};

template <class Kind> struct Names; // the table of a type's words

template <> struct Names<Arrangement> {
    static constexpr Name<Arrangement> table[] = {{Arrangement::lenticular, "lenticular"},
                                                  {Arrangement::square, "square"},
                                                  {Arrangement::hexagonal, "hexagonal"}};
};
template <> struct Names<LensMapping> {
    static constexpr Name<LensMapping> table[] = {{LensMapping::automatic, "auto"},
                                                  {LensMapping::closest, "closest"},
                                                  {LensMapping::accurate, "accurate"},
                                                  {LensMapping::exhaustive, "exhaustive"}};
};
template <> struct Names<LensModel> {
    static constexpr Name<LensModel> table[] = {{LensModel::extended_pinhole, "extended_pinhole"},
                                                {LensModel::pinhole, "pinhole"},
                                                {LensModel::hybrid, "hybrid"},
                                                {LensModel::full, "full"}};
};
template <> struct Names<Subpixels::Order> {
    static constexpr Name<Subpixels::Order> table[] = {
        {Subpixels::rgb, "rgb"},   {Subpixels::bgr, "bgr"},     {Subpixels::vrgb, "vrgb"},
        {Subpixels::vbgr, "vbgr"}, {Subpixels::cells, "cells"}, {Subpixels::none, "none"}};
};
template <> struct Names<CellPattern> {
    static constexpr Name<CellPattern> table[] = {{CellPattern::same, "same"},
                                                  {CellPattern::checkerboard, "checkerboard"},
                                                  {CellPattern::columns, "columns"},
                                                  {CellPattern::rows, "rows"},
                                                  {CellPattern::staggered, "staggered"}};
};
template <> struct Names<ErrorMethod> {
    static constexpr Name<ErrorMethod> table[] = {{ErrorMethod::audit, "audit"},
                                                  {ErrorMethod::split_halves, "split halves"}};
};
template <> struct Names<ApertureShape> {
    static constexpr Name<ApertureShape> table[] = {{ApertureShape::rectangle, "rectangle"},
                                                    {ApertureShape::ellipse, "ellipse"}};
};
template <> struct Names<Encoding::Kind> {
    static constexpr Name<Encoding::Kind> table[] = {{Encoding::Kind::linear, "linear"},
                                                     {Encoding::Kind::srgb, "srgb"},
                                                     {Encoding::Kind::power, "power"}};
};

template <class Kind> const char* word_for(Kind kind)
{
    for (const auto& name : Names<Kind>::table)
        if (name.kind == kind)
            return name.word;
    return "";
}

} // namespace

const char* name_of(Arrangement kind) { return word_for(kind); }
const char* name_of(LensMapping kind) { return word_for(kind); }
const char* name_of(LensModel kind) { return word_for(kind); }
const char* name_of(Subpixels::Order kind) { return word_for(kind); }
const char* name_of(CellPattern kind) { return word_for(kind); }
const char* name_of(ErrorMethod kind) { return word_for(kind); }
const char* name_of(ApertureShape kind) { return word_for(kind); }
const char* name_of(Encoding::Kind kind) { return word_for(kind); }

template <class Kind> std::optional<Kind> kind_named(const std::string& word)
{
    for (const auto& name : Names<Kind>::table)
        if (word == name.word)
            return name.kind;
    return std::nullopt;
}

template <class Kind> std::string legal_names()
{
    std::string list;
    const auto& table = Names<Kind>::table;
    const std::size_t count = sizeof table / sizeof table[0];
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0)
            list += i + 1 < count ? ", " : " or ";
        list += table[i].word;
    }
    return list;
}

template std::optional<Arrangement> kind_named(const std::string&);
template std::optional<LensMapping> kind_named(const std::string&);
template std::optional<LensModel> kind_named(const std::string&);
template std::optional<Subpixels::Order> kind_named(const std::string&);
template std::optional<CellPattern> kind_named(const std::string&);
template std::optional<ErrorMethod> kind_named(const std::string&);
template std::optional<ApertureShape> kind_named(const std::string&);
template std::optional<Encoding::Kind> kind_named(const std::string&);
template std::string legal_names<Arrangement>();
template std::string legal_names<LensMapping>();
template std::string legal_names<LensModel>();
template std::string legal_names<Subpixels::Order>();
template std::string legal_names<CellPattern>();
template std::string legal_names<ErrorMethod>();
template std::string legal_names<ApertureShape>();
template std::string legal_names<Encoding::Kind>();

} // namespace integral
