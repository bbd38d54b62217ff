// SPDX-License-Identifier: AGPL-3.0-or-later
// The pages on which a suite's pictures are accepted or rejected.
#ifndef INTEGRAL_STUDIO_APPROVAL_PAGE_H
#define INTEGRAL_STUDIO_APPROVAL_PAGE_H

#include "integral/studio/approval.h"

namespace integral {

/// The page with all pictures, their outcomes and decisions, and the button that finishes.
std::string approval_list(const Suite& suite, const std::vector<ApprovalItem>& items,
                          const ServerRequest& request);

/// The page of one picture, number `index` of `count` from 0: a bar with the buttons above the
/// comparison's page.
std::string approval_picture(const SuiteFolders& folders, const ApprovalItem& item,
                             std::size_t index, std::size_t count, const ServerRequest& request);

/// The page with the reason why a decision was not carried out.
std::string approval_refusal(const std::string& name, const std::string& why, std::size_t index,
                             const ServerRequest& request);

/// The page after the end.
std::string approval_end(const ApprovalCounts& counts, const ServerRequest& request);

/// "2 accepted, 1 rejected, 0 undecided".
std::string approval_summary(const ApprovalCounts& counts);

} // namespace integral

#endif
