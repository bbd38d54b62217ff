// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/suite_run.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace integral {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& path)
{
    const std::string extension = extension_of(path.filename().string());
    return extension == "png" || extension == "exr" || extension == "tif" || extension == "tiff";
}

std::string without_slash_at_end(std::string path)
{
    while (path.size() > 1 && path.back() == '/')
        path.pop_back();
    return path;
}

/// The folder `references` next to another.
std::string references_beside(const std::string& folder)
{
    return ((fs::path(folder) / "..").lexically_normal() / "references")
        .lexically_normal()
        .string();
}

} // namespace

SuiteFolders suite_folders(const std::string& results, const std::optional<std::string>& references,
                           bool may_be_new)
{
    SuiteFolders folders;
    folders.results = without_slash_at_end(results);
    folders.references = references ? without_slash_at_end(*references)
                                    : references_beside(folders.results);
    std::error_code ignored;
    if (!fs::is_directory(folders.results, ignored))
        throw InputError(
            folders.results +
            ": there is no such folder; --suite names the folder of pictures to check");
    if (!fs::is_directory(folders.references, ignored) &&
        !(may_be_new && !fs::exists(folders.references, ignored)))
        throw InputError(folders.references +
                         ": there is no such folder of references; on a first run, --create makes "
                         "the results references, or --accept " +
                         folders.results +
                         "/*.png some of them; or name the folder with --references");
    if (fs::equivalent(folders.results, folders.references, ignored))
        throw std::invalid_argument("--suite and --references are the same folder");
    return folders;
}

std::set<std::string> pictures_in(const std::string& folder, const std::string& other)
{
    std::set<std::string> names;
    try {
        for (auto entry = fs::recursive_directory_iterator(folder);
             entry != fs::recursive_directory_iterator(); ++entry) {
            std::error_code ignored;
            const bool hidden = entry->path().filename().string()[0] == '.';
            if (entry->is_directory(ignored) &&
                (hidden || fs::equivalent(entry->path(), other, ignored)))
                entry.disable_recursion_pending();
            else if (!hidden && is_picture(entry->path()) && entry->is_regular_file(ignored))
                names.insert(entry->path().lexically_relative(folder).string());
            stop_if_interrupted();
        }
    } catch (const fs::filesystem_error& error) {
        throw InputError((error.path1().empty() ? folder : error.path1().string()) +
                         ": the folder cannot be read: " + error.code().message());
    }
    return names;
}

std::set<std::string> references_in(const SuiteFolders& folders)
{
    std::error_code error;
    return fs::is_directory(folders.references, error)
               ? pictures_in(folders.references, folders.results)
               : std::set<std::string>();
}

SuiteTolerances read_tolerances(const SuiteFolders& folders, const std::optional<std::string>& file)
{
    SuiteTolerances read;
    read.file = file ? *file : folders.reference("suite.json");
    std::error_code ignored;
    if (!file && !fs::exists(read.file, ignored)) {
        read.file.clear();
        return read;
    }
    try {
        read.tolerances = tolerances_from_json(read_file(read.file));
    } catch (const std::invalid_argument& error) {
        throw InputError(read.file + ": " + error.what());
    }
    return read;
}

Suite suite_of(const SuiteFolders& folders, const SuiteTolerances& limits)
{
    Suite suite;
    suite.folders = folders;
    suite.tolerances = limits.file;
    const auto results = pictures_in(folders.results, folders.references),
               references = references_in(folders);
    std::set<std::string> names = results;
    names.insert(references.begin(), references.end());
    if (names.empty())
        throw InputError(folders.results + ": neither here nor in " + folders.references +
                         " is there a picture; PNG, EXR and TIFF are compared");
    const fs::path folder = fs::path(limits.file).parent_path(); // an absolute mask replaces it
    for (const std::string& name : names) {
        SuitePair pair;
        pair.name = name;
        pair.has_result = results.count(name) > 0;
        pair.has_reference = references.count(name) > 0;
        pair.limits = limits_for(limits.tolerances, name);
        pair.rules = rules_for(limits.tolerances, name);
        if (!pair.rules.mask.empty())
            pair.rules.mask = (folder / pair.rules.mask).string();
        suite.pairs.push_back(pair);
    }
    for (const auto& entry : limits.tolerances.entries)
        if (std::none_of(names.begin(), names.end(),
                         [&](const std::string& name) { return matches(entry.pattern, name); }))
            suite.unused.push_back("line " + std::to_string(entry.line) + ": \"" +
                                   excerpt(entry.pattern) + "\" matches no file");
    return suite;
}

bool compare_suite(Suite& suite, const SuitePictures& pictures, const CompareSeen& compare_seen,
                   int threads, const Progress& progress)
{
    return for_each_row(
        int(suite.pairs.size()), threads,
        [&](int i) {
            compare_pair(suite.pairs[std::size_t(i)], suite.folders, pictures, compare_seen);
        },
        progress);
}

} // namespace integral
