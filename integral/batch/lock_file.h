// SPDX-License-Identifier: AGPL-3.0-or-later
// Locks between processes, also of several machines that share a folder. A lock is a file that only
// one process can succeed in making.
#ifndef INTEGRAL_BATCH_LOCK_FILE_H
#define INTEGRAL_BATCH_LOCK_FILE_H

#include <string>

namespace integral {

/// Holds at most one lock. Takes over the lock file of a dead holder. A holder on the same machine
/// and in the same PID namespace is dead if the process named in the file has ended. Any other
/// holder is dead if its file is too old, because living holders refresh their files. Files of
/// earlier versions, which name no namespace, are judged by age, too.
class LockFile {
public:
    LockFile() = default;
    ~LockFile() { release(); }
    LockFile(LockFile&& other) noexcept : path_(std::move(other.path_)) { other.path_.clear(); }
    LockFile& operator=(LockFile&& other) noexcept;

    /// Tries to take the lock at that path. If another process holds the lock, returns false and
    /// sets `holder` to that process: "process 12 on HOST". Throws OutputError if the folder cannot
    /// be written.
    bool take(const std::string& path, std::string& holder);
    bool held() const { return !path_.empty(); }
    /// Shows other machines that the holder is alive. Must be called at least every
    /// `seconds_of_silence`.
    void refresh() const;
    void release();

    static constexpr int seconds_of_silence = 120;

private:
    std::string path_;
};

} // namespace integral

#endif
