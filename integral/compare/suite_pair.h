// SPDX-License-Identifier: AGPL-3.0-or-later
// One picture of a suite and its reference: what is found of them.
#ifndef INTEGRAL_COMPARE_SUITE_PAIR_H
#define INTEGRAL_COMPARE_SUITE_PAIR_H

#include "integral/compare/tolerances.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

/// What became of a pair. Of several, the one that stands last here.
enum class PairState {
    passed,
    over_limit,
    other_geometry,
    other_size,
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
    std::string name; ///< relative to either folder
    bool has_reference = false, has_result = false;
    PairState state = PairState::passed;
    std::vector<std::string> faults; ///< a line each
    Limits limits;
    std::optional<Comparison> figures; ///< where both could be read and are of one size
    std::string pictures;              ///< HTML that shows them, if a report is wanted

    bool missing() const { return state >= PairState::no_reference; }
    bool passed() const { return state == PairState::passed; }
};

/// Whether there is a report to make pictures for, and how the differences are amplified in it (0:
/// so that they are seen).
struct SuitePictures {
    bool wanted = false;
    double gain = 0;
};

/// Compares one pair, or looks at the one file that there is; fills in what is empty above. Faults
/// of the files are noted, not thrown.
void compare_pair(SuitePair& pair, const SuiteFolders& folders, const SuitePictures& pictures);

} // namespace integral

#endif
