// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/suite_accept.h"

#include "integral/base/folders.h"
#include "integral/compare/suite_run.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include <unistd.h>

namespace integral {
namespace {

namespace fs = std::filesystem;

/// The documents next to a picture that may contain its geometry.
std::vector<std::string> documents_of(const std::string& picture)
{
    return {picture + ".json", fs::path(picture).replace_extension(".json").string()};
}

/// A path relative to a folder; the path itself if there is no such path.
std::string name_within(const std::string& folder, const std::string& path)
{
    std::error_code error;
    const fs::path name = fs::relative(path, folder, error);
    return error ? path : name.string();
}

/// Deletes a file, if it is there.
void remove_file(const std::string& path, const std::string& why)
{
    std::error_code error;
    if (fs::exists(path, error) && unlink(path.c_str()) != 0)
        throw OutputError(path + ": cannot be deleted; " + why);
}

} // namespace

void accept_results(const std::vector<std::string>& given, const SuiteFolders& folders,
                    const Accepted& accepted)
{
    const auto results = pictures_in(folders.results, folders.references);
    std::error_code error;
    std::vector<std::string> names;
    for (const std::string& name : given) {
        names.push_back(results.count(name) ? name : name_within(folders.results, name));
        if (results.count(names.back())) {
            read_frame(folders.result(names.back()));
            continue;
        }
        names.back() = name;
        if (!references_in(folders).count(name))
            throw InputError(folders.result(name) +
                             ": there is no such picture to accept; give its name within " +
                             folders.results + ", or its path");
    }
    for (const std::string& name : names) {
        const std::string from = folders.result(name), to = folders.reference(name);
        const auto old_documents = documents_of(to), new_documents = documents_of(from);
        if (!results.count(name)) {
            remove_file(to, "its result is gone");
            for (const std::string& document : old_documents)
                remove_file(document, "its picture is removed");
            accepted(name, to, "is removed");
            continue;
        }
        const bool is_new = !fs::exists(to, error);
        make_folder(fs::path(to).parent_path().string());
        for (std::size_t i = 0; i < new_documents.size(); ++i)
            if (fs::exists(new_documents[i], error))
                write_file(old_documents[i], read_file(new_documents[i]));
            else
                remove_file(old_documents[i], "the new reference has its geometry elsewhere");
        write_file(to, read_file(from));
        accepted(name, to, is_new ? "is new" : "is replaced");
    }
}

std::vector<std::string> results_without_reference(const SuiteFolders& folders)
{
    const auto results = pictures_in(folders.results, folders.references);
    const auto references = references_in(folders);
    std::vector<std::string> names;
    std::set_difference(results.begin(), results.end(), references.begin(), references.end(),
                        std::back_inserter(names));
    return names;
}

} // namespace integral
