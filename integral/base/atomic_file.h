// SPDX-License-Identifier: AGPL-3.0-or-later
// Temporary files that are written in the folder of the file they replace, and renamed to it when
// they are complete.
#ifndef INTEGRAL_BASE_ATOMIC_FILE_H
#define INTEGRAL_BASE_ATOMIC_FILE_H

#include <string>
#include <sys/types.h>

namespace integral {

/// The file that a path refers to after all symbolic links are resolved: the one to replace.
std::string target_of(const std::string& path);

/// Whether a path is a device, a pipe or a socket, which must not be replaced by a file. False for
/// a folder.
bool is_special(const std::string& path);

/// Creates a temporary file for `target` in its folder, for reading and writing. The file is always
/// new, its name is unpredictable but recognised by sweep_unfinished(), and no symbolic link is
/// followed. Files that killed processes left in the folder are deleted, once per process. Returns
/// the file's descriptor, and its path in `name`; -1, with the reason in errno, if it fails.
int create_unfinished(const std::string& target, std::string& name);

/// Permissions for a new file: its target's if the target exists, else the umask's default.
mode_t mode_for(const std::string& target);

/// Owner of a temporary file, which the caller writes by any means. finish() renames it to its
/// target. If finish() is not called, the destructor deletes it, and an older file of the
/// target's name stays.
class AtomicFile {
public:
    /// Owns a file that the caller creates. `name` and `target` must be in the same folder.
    AtomicFile(const std::string& name, const std::string& target);
    /// Creates the file (create_unfinished) for target_of(path), to be opened by its name. If that
    /// fails, name() is empty and errno has the reason.
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::string& name() const { return name_; }
    const std::string& target() const { return target_; }

    /// Gives the file its permissions and renames it to its target. Returns 0, or errno if that
    /// failed; the destructor then deletes the file.
    int finish();

private:
    std::string name_, target_;
    bool finished_ = false;
};

/// This machine's name.
std::string host_name();

/// The number of the PID namespace in which this process runs. Two containers may share a host
/// name, but the same process number means a different process in each namespace. Empty if /proc is
/// missing or belongs to another namespace, so that no process can be looked up.
std::string process_namespace();

/// The name of a temporary file of this process: ".integral-NAME.HOST.NAMESPACE.PROCESS".
/// write_file uses such names.
std::string unfinished_name(const std::string& name);

/// Deletes the temporary files that killed processes left in a folder. Files of this machine and
/// PID namespace are deleted if their process has ended. Other files, whose process cannot be
/// looked up, are deleted if they are a day old (also files that earlier versions named without a
/// namespace).
void sweep_unfinished(const std::string& folder);

} // namespace integral

#endif
