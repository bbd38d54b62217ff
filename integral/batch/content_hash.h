// SPDX-License-Identifier: AGPL-3.0-or-later
// SHA-256 of texts and files, by which a batch detects changes.
#ifndef INTEGRAL_BATCH_CONTENT_HASH_H
#define INTEGRAL_BATCH_CONTENT_HASH_H

#include <memory>
#include <string>

namespace integral {

/// Hashes a sequence of texts. The same characters, divided otherwise, give another hash.
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

/// The SHA-256 of a file's bytes, as sha256sum prints it. Throws InputError if the file cannot be
/// read.
std::string hash_of_file(const std::string& path);

} // namespace integral

#endif
