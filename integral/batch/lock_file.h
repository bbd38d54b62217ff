// SPDX-License-Identifier: AGPL-3.0-or-later
// Locks between processes, also of several machines that share a folder: files that are made in one
// go.
#ifndef INTEGRAL_BATCH_LOCK_FILE_H
#define INTEGRAL_BATCH_LOCK_FILE_H

#include <string>

namespace integral {

/// Holds at most one lock. A process that was killed leaves its file behind. In the same PID
/// namespace of the same machine that is seen at once, by its process; from another machine or
/// container, by the file's age, as holders refresh theirs. Locks of earlier versions, which do not
/// name their namespace, are judged by age as well.
class LockFile {
public:
    LockFile() = default;
    ~LockFile() { release(); }
    LockFile(LockFile&& other) noexcept : path_(std::move(other.path_)) { other.path_.clear(); }
    LockFile& operator=(LockFile&& other) noexcept;

    /// Tries to take it; false if another holds it: then `holder` says who, "process 12 on HOST".
    /// Throws OutputError where the folder cannot be written.
    bool take(const std::string& path, std::string& holder);
    bool held() const { return !path_.empty(); }
    /// Shows others that the holder is alive: to be called every few seconds, at least once in
    /// `seconds_of_silence`.
    void refresh() const;
    void release();

    static constexpr int seconds_of_silence = 120;

private:
    std::string path_;
};

} // namespace integral

#endif
