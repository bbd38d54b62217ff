// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares one picture of a suite with its reference.
#ifndef INTEGRAL_COMPARE_SUITE_PAIR_H
#define INTEGRAL_COMPARE_SUITE_PAIR_H

#include "integral/compare/seen.h"
#include "integral/compare/tolerances.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// The outcome for a pair. If several outcomes apply, the last of them in this list is taken.
enum class PairState {
    passed,
    over_limit,
    other_geometry,
    other_size,
    no_tolerances, ///< a region or mask does not fit the picture
    damaged,
    no_reference,
    no_result
};

/// The word for a state, in reports and for programs: "passed", "limit", "geometry" ...
const char* name_of(PairState state);

/// The two folders, as the user named them.
struct SuiteFolders {
    std::string results, references;
    std::string result(const std::string& name) const { return results + "/" + name; }
    std::string reference(const std::string& name) const { return references + "/" + name; }
};

struct SuitePair {
    std::string name;                               ///< relative to either folder
    bool has_reference = false, has_result = false; ///< whether the files are there
    PairState state = PairState::passed;
    std::vector<std::string> faults; ///< one line for each
    Limits limits;
    ComparisonRules rules;
    std::optional<Comparison> figures; ///< empty unless both were read and have the same size
    std::string pictures;              ///< HTML that shows both, if a report is requested
    std::string comparator;            ///< HTML that opens the comparison of both; empty: none
    std::optional<Image> thumbnail;    ///< of a failed pair: reference, result, difference

    bool missing() const { return state >= PairState::no_reference; }
    bool passed() const { return state == PairState::passed; }
};

/// The pictures of a report.
struct SuitePictures {
    bool requested = false;  ///< whether there is a report
    bool thumbnails = false; ///< whether there is a summary with small pictures
    double gain = 0;         ///< multiplies the differences; 0: chosen to make each visible
};

/// Compares a pair, or reads its only file, and fills in state, faults, figures and pictures. Files
/// that cannot be read are noted as faults, not thrown. `compare_seen` compares the eyes' views
/// where the pair's rules require it and both frames have geometry.
void compare_pair(SuitePair& pair, const SuiteFolders& folders, const SuitePictures& pictures,
                  const CompareSeen& compare_seen);

} // namespace integral

#endif
