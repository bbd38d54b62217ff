// SPDX-License-Identifier: AGPL-3.0-or-later
// Locks between processes, also of several machines that share a folder. A lock is a file that only
// one process can succeed in making.
#ifndef INTEGRAL_BATCH_LOCK_FILE_H
#define INTEGRAL_BATCH_LOCK_FILE_H

#include <string>

namespace integral {

/// Holds at most one lock. A process that was killed leaves its file behind, which is then taken
/// over. On the same machine and in the same PID namespace that is known by the process that the
/// file names; elsewhere by the age of the file, as holders refresh theirs. The files of earlier
/// versions, which do not name their namespace, are judged by age, too.
class LockFile {
public:
    LockFile() = default;
    ~LockFile() { release(); }
    LockFile(LockFile&& other) noexcept : path_(std::move(other.path_)) { other.path_.clear(); }
    LockFile& operator=(LockFile&& other) noexcept;

    /// Tries to take the lock of that path. Returns false if another process holds it, which
    /// `holder` then names: "process 12 on HOST". Throws OutputError if the folder cannot be
    /// written.
    bool take(const std::string& path, std::string& holder);
    bool held() const { return !path_.empty(); }
    /// Shows other machines that the holder is alive. Must be called at least once in
    /// `seconds_of_silence`.
    void refresh() const;
    void release();

    static constexpr int seconds_of_silence = 120;

private:
    std::string path_;
};

} // namespace integral

#endif
