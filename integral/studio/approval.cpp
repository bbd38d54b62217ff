// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/approval.h"

#include "integral/studio/approval_page.h"
#include "integral/studio/file_stamp.h"

#include <charconv>

namespace integral {
namespace {

/// The stamps of a pair's files.
std::string pair_stamp(const SuiteFolders& folders, const std::string& name)
{
    return file_stamp(folders.reference(name)) + "/" + file_stamp(folders.result(name));
}

/// K and WORD in "/picture/K" or "/picture/K/WORD".
struct PicturePath {
    std::size_t number = 0; ///< 0: the path is of another form
    std::string word;
};

PicturePath picture_path(const std::string& path)
{
    const std::string start = "/picture/";
    PicturePath read;
    if (path.compare(0, start.size(), start) != 0)
        return read;
    const char *at = path.data() + start.size(), *const end = path.data() + path.size();
    const auto number = std::from_chars(at, end, read.number);
    if (number.ec != std::errc() || (number.ptr != end && *number.ptr != '/'))
        return {};
    if (number.ptr != end)
        read.word.assign(number.ptr + 1, end);
    return read;
}

} // namespace

ApprovalCounts counts_of(const std::vector<ApprovalItem>& items)
{
    ApprovalCounts counts;
    for (const ApprovalItem& item : items)
        ++(item.decision == Decision::accepted   ? counts.accepted
           : item.decision == Decision::rejected ? counts.rejected
                                                 : counts.undecided);
    return counts;
}

Approval::Approval(const Suite& suite, Accepted accepted)
    : suite_(suite), accepted_(std::move(accepted))
{
    for (const SuitePair& pair : suite.pairs)
        if (!pair.passed())
            items_.push_back({&pair, Decision::none, pair_stamp(suite.folders, pair.name)});
}

std::optional<ServerAnswer> Approval::answer(const ServerRequest& request)
{
    if (request.path == "/" && !request.is_post) {
        const std::lock_guard lock(mutex_);
        return ServerAnswer{200, approval_list(suite_, items_, request)};
    }
    if (request.path == "/finish" && request.is_post) {
        ended_ = true;
        return ServerAnswer{200, approval_end(counts(), request)};
    }
    const PicturePath path = picture_path(request.path);
    if (path.number < 1 || path.number > items_.size())
        return std::nullopt;
    if (!request.is_post)
        return path.word.empty() ? std::optional(show(path.number - 1, request)) : std::nullopt;
    if (path.word == "accept" || path.word == "reject")
        return decide(path.number - 1, path.word == "accept", request);
    return std::nullopt;
}

ServerAnswer Approval::show(std::size_t index, const ServerRequest& request)
{
    ApprovalItem item;
    {
        const std::lock_guard lock(mutex_);
        items_[index].stamp = pair_stamp(suite_.folders, items_[index].pair->name);
        item = items_[index];
    }
    return {200, approval_picture(suite_.folders, item, index, items_.size(), request)};
}

ServerAnswer Approval::decide(std::size_t index, bool accept, const ServerRequest& request)
{
    const std::lock_guard lock(mutex_);
    ApprovalItem& item = items_[index];
    const std::string& name = item.pair->name;
    const auto refused = [&](const std::string& why) {
        return ServerAnswer{409, approval_refusal(name, why, index, request)};
    };
    if (item.decision == Decision::accepted && !accept)
        return refused("It was accepted already, and its reference is replaced.");
    if (accept && item.decision != Decision::accepted) {
        if (item.stamp != pair_stamp(suite_.folders, name))
            return refused("Its files have changed since they were shown; look at them again.");
        try {
            accept_results({name}, suite_.folders, accepted_);
        } catch (const std::exception& error) {
            return refused(error.what());
        }
    }
    item.decision = accept ? Decision::accepted : Decision::rejected;
    // Go on to the next undecided picture, or to the list.
    std::string next = request.base + "/";
    for (std::size_t k = 1; k < items_.size(); ++k) {
        const std::size_t other = (index + k) % items_.size();
        if (items_[other].decision == Decision::none) {
            next += "picture/" + std::to_string(other + 1);
            break;
        }
    }
    ServerAnswer answer{303, ""};
    answer.location = next;
    return answer;
}

ApprovalCounts Approval::counts() const
{
    const std::lock_guard lock(mutex_);
    return counts_of(items_);
}

} // namespace integral
