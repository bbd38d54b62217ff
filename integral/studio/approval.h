// SPDX-License-Identifier: AGPL-3.0-or-later
// Lets a user look at a suite's failed pictures in a browser, and accept or reject each.
#ifndef INTEGRAL_STUDIO_APPROVAL_H
#define INTEGRAL_STUDIO_APPROVAL_H

#include "integral/compare/suite_accept.h"
#include "integral/compare/suite_report.h"
#include "integral/studio/server.h"

#include <atomic>
#include <mutex>
#include <vector>

namespace integral {

enum class Decision { none, accepted, rejected };

/// One picture that did not pass.
struct ApprovalItem {
    const SuitePair* pair = nullptr;
    Decision decision = Decision::none;
    std::string stamp; ///< of its files when last shown (pair_stamp)
};

struct ApprovalCounts {
    int accepted = 0, rejected = 0, undecided = 0;
};

ApprovalCounts counts_of(const std::vector<ApprovalItem>& items);

/// Answers requests to a Server: "/" lists the pictures, "/picture/K" shows one (K from 1) with the
/// comparison's page, and a POST to "/picture/K/accept", "/picture/K/reject" or "/finish" carries
/// out the command. No path names a file. Accepting calls accept_results at once, but is refused if
/// a file has changed since it was shown.
class Approval {
public:
    /// `suite` must have been compared and must outlive this. `accepted`: for accept_results.
    Approval(const Suite& suite, Accepted accepted);

    /// May be called by several threads at once.
    std::optional<ServerAnswer> answer(const ServerRequest& request);

    bool has_ended() const { return ended_; }
    ApprovalCounts counts() const;

private:
    ServerAnswer show(std::size_t index, const ServerRequest& request);
    ServerAnswer decide(std::size_t index, bool accept, const ServerRequest& request);

    const Suite& suite_;
    Accepted accepted_;
    mutable std::mutex mutex_; ///< guards items_ and everything that accepting changes
    std::vector<ApprovalItem> items_;
    std::atomic<bool> ended_ = false;
};

} // namespace integral

#endif
