// SPDX-License-Identifier: AGPL-3.0-or-later
// Files that are written beside the ones that they replace, and renamed when they are whole.
#ifndef INTEGRAL_BASE_UNFINISHED_FILE_H
#define INTEGRAL_BASE_UNFINISHED_FILE_H

#include <string>

namespace integral {

/// The file that a path means, through any symbolic links: what is to be replaced.
std::string target_of(const std::string& path);

/// Whether a path is a device, a pipe or a socket: something that no file can replace. A folder is
/// none.
bool is_special(const std::string& path);

/// A file under the name that it has until it is whole. Whoever makes one writes it by any means;
/// finish() gives it its own name. Without that, the destructor deletes it, so that a file that was
/// there before stays.
class UnfinishedFile {
public:
    /// Makes no file yet. `name` and `target` have to be in one folder.
    UnfinishedFile(const std::string& name, const std::string& target);
    /// The same beside the file that a path means: its name with ".tmp" behind it.
    explicit UnfinishedFile(const std::string& path);
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    const std::string& name() const { return name_; }
    const std::string& target() const { return target_; }

    /// Renames it. Returns 0, or errno where that failed; the file is deleted then.
    int finish();

private:
    std::string name_, target_;
    bool finished_ = false;
};

/// This machine's name.
std::string host_name();

/// The number of the PID namespace in which this process runs. Containers of one host name have
/// different ones, and a process number means another process in each. Empty where /proc is missing
/// or shows another namespace's processes: then no process can be looked up.
std::string process_namespace();

/// The name under which this process may make a file of a folder before that gets its own:
/// ".integral-NAME.HOST.NAMESPACE.PROCESS". write_file uses such names.
std::string unfinished_name(const std::string& name);

/// Deletes the files of such names in a folder whose makers were killed: those of this machine and
/// PID namespace at once; others, whose makers cannot be asked, once they are a day old, also those
/// that earlier versions named without a namespace.
void sweep_unfinished(const std::string& folder);

} // namespace integral

#endif
