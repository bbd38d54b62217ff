// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/notices.h"

#include "integral/base/message_text.h"

#include <mutex>
#include <set>

namespace integral {
namespace {

struct Notices {
    std::mutex mutex;
    std::function<void(const std::string&)> receiver;
    std::set<std::string> given;
};

Notices& notices()
{
    static Notices all;
    return all;
}

} // namespace

void give_notice(const std::string& line)
{
    Notices& all = notices();
    const std::string text = one_line(line);
    const std::lock_guard<std::mutex> lock(all.mutex);
    if (all.receiver && all.given.insert(text).second)
        all.receiver(text);
}

void receive_notices(std::function<void(const std::string&)> receiver)
{
    Notices& all = notices();
    const std::lock_guard<std::mutex> lock(all.mutex);
    all.receiver = std::move(receiver);
    all.given.clear();
}

} // namespace integral
