// SPDX-License-Identifier: AGPL-3.0-or-later
// SHA-256 of texts and files, by which a batch knows whether anything has changed.
#ifndef INTEGRAL_BATCH_CONTENT_HASH_H
#define INTEGRAL_BATCH_CONTENT_HASH_H

#include <memory>
#include <string>

namespace integral {

/// The hash of a sequence of texts. The same characters divided otherwise have another hash.
class ContentHash {
public:
    ContentHash();
    ~ContentHash();
    ContentHash(const ContentHash&) = delete;
    ContentHash& operator=(const ContentHash&) = delete;
    void add(const std::string& piece);
    /// 64 hexadecimal digits. Nothing can be added afterwards.
    std::string digits();

    struct State;

private:
    std::unique_ptr<State> state_;
};

/// The SHA-256 of a file's bytes, as sha256sum prints it. Throws InputError where it cannot be
/// read.
std::string hash_of_file(const std::string& path);

} // namespace integral

#endif
