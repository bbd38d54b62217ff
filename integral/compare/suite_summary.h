// SPDX-License-Identifier: AGPL-3.0-or-later
// A suite's outcome as Markdown, for the page of a CI job or a comment on a change.
#ifndef INTEGRAL_COMPARE_SUITE_SUMMARY_H
#define INTEGRAL_COMPARE_SUITE_SUMMARY_H

#include "integral/compare/suite_report.h"

namespace integral {

/// The Markdown: the counts, and a table of the pairs that failed, at most 50, each with its faults
/// and, where it has one, its picture. `pictures`: the pictures' folder, with which the Markdown's
/// links begin; a pair's picture is thumbnail_name in it.
std::string suite_markdown(const Suite& suite, const std::string& pictures);

/// The file name for a pair's small picture.
std::string thumbnail_name(const Suite& suite, const SuitePair& pair);

/// Writes the Markdown to `path` ("-": standard output, without pictures), and the small pictures
/// of the pairs that have one to the folder PATH.pictures. Throws OutputError.
void write_suite_summary(const Suite& suite, const std::string& path);

} // namespace integral

#endif
