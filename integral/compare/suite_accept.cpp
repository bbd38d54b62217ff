// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/suite_accept.h"

#include "integral/base/folders.h"
#include "integral/compare/suite_run.h"
#include "integral/io/image_file.h"

#include <filesystem>

#include <unistd.h>

namespace integral {
namespace {

namespace fs = std::filesystem;

/// The documents beside a picture in which its geometry may stand.
std::vector<std::string> documents_of(const std::string& picture)
{
    return {picture + ".json", fs::path(picture).replace_extension(".json").string()};
}

/// The name within a folder of a path that leads into it; of other paths, something else.
std::string name_within(const std::string& folder, const std::string& path)
{
    std::error_code error;
    const fs::path name = fs::relative(path, folder, error);
    return error ? path : name.string();
}

} // namespace

void accept_results(const std::vector<std::string>& given, const SuiteFolders& folders,
                    const Accepted& accepted)
{
    const auto results = pictures_in(folders.results, folders.references);
    std::vector<std::string> names;
    for (const std::string& name : given) {
        names.push_back(results.count(name) ? name : name_within(folders.results, name));
        if (!results.count(names.back()))
            throw InputError(folders.result(name) +
                             ": there is no such picture to accept; give its name within " +
                             folders.results + ", or its path");
        read_frame(folders.result(names.back()));
    }
    for (const std::string& name : names) {
        const std::string from = folders.result(name), to = folders.reference(name);
        std::error_code error;
        const bool is_new = !fs::exists(to, error);
        make_folder(fs::path(to).parent_path().string());
        const auto old_documents = documents_of(to), new_documents = documents_of(from);
        for (std::size_t i = 0; i < new_documents.size(); ++i)
            if (fs::exists(new_documents[i], error))
                write_file(old_documents[i], read_file(new_documents[i]));
            else if (fs::exists(old_documents[i], error) && unlink(old_documents[i].c_str()) != 0)
                throw OutputError(
                    old_documents[i] +
                    ": cannot be deleted; the new reference has its geometry elsewhere");
        write_file(to, read_file(from));
        accepted(name, to, is_new);
    }
}

} // namespace integral
