// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/compare_suite.h"

#include "integral/base/message_text.h"
#include "integral/cli/compare_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/compare/suite_report.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include <unistd.h>

namespace integral {
namespace {

namespace fs = std::filesystem;

constexpr const char* suite_options[] = {"suite", "references", "tolerances",
                                         "junit", "accept",     "threads"};

bool is_picture(const fs::path& path)
{
    const std::string extension = extension_of(path.filename().string());
    return extension == "png" || extension == "exr" || extension == "tif" || extension == "tiff";
}

/// The pictures in a folder and those below it, by their paths relative to it; nothing hidden, and
/// nothing in the folder `other`.
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

SuiteFolders folders_from(const options::variables_map& arguments)
{
    SuiteFolders folders;
    const auto plain = [](std::string path) { // without a slash at its end
        while (path.size() > 1 && path.back() == '/')
            path.pop_back();
        return path;
    };
    folders.results = plain(text_of(arguments, "suite"));
    folders.references = given(arguments, "references")
                             ? plain(text_of(arguments, "references"))
                             : ((fs::path(folders.results) / "..").lexically_normal() /
                                "references")
                                   .lexically_normal()
                                   .string();
    for (const std::string& folder : {folders.results, folders.references})
        if (std::error_code ignored; !fs::is_directory(folder, ignored))
            throw InputError(folder + ": there is no such folder; " +
                             (folder == folders.references
                                  ? "say where the references are with --references"
                                  : "--suite names the folder of pictures to check"));
    std::error_code ignored;
    if (fs::equivalent(folders.results, folders.references, ignored))
        throw UsageError("--suite and --references are the same folder");
    return folders;
}

/// The tolerances, and the name of their file in the suite. What the command line says takes the
/// place of the file's defaults.
Tolerances tolerances_from(const options::variables_map& arguments, const SuiteFolders& folders,
                           std::string& file)
{
    Tolerances tolerances;
    file = given(arguments, "tolerances") ? text_of(arguments, "tolerances")
                                          : folders.reference("suite.json");
    std::error_code ignored;
    if (given(arguments, "tolerances") || fs::exists(file, ignored)) {
        try {
            tolerances = tolerances_from_json(read_file(file));
        } catch (const std::invalid_argument& error) {
            throw InputError(file + ": " + error.what());
        }
    } else {
        file.clear();
    }
    const Limits limits = limits_from(arguments);
    for (std::size_t kind = 0; kind < limit_count; ++kind)
        if (limits[kind])
            tolerances.defaults[kind] = limits[kind];
    return tolerances;
}

Suite suite_of(const SuiteFolders& folders, const Tolerances& tolerances,
               const std::string& tolerance_file)
{
    Suite suite;
    suite.folders = folders;
    suite.tolerances = tolerance_file;
    const auto results = pictures_in(folders.results, folders.references),
               references = pictures_in(folders.references, folders.results);
    std::set<std::string> names = results;
    names.insert(references.begin(), references.end());
    if (names.empty())
        throw InputError(folders.results + ": neither here nor in " + folders.references +
                         " is there a picture; PNG, EXR and TIFF are compared");
    for (const std::string& name : names) {
        SuitePair pair;
        pair.name = name;
        pair.has_result = results.count(name) > 0;
        pair.has_reference = references.count(name) > 0;
        pair.limits = limits_for(tolerances, name);
        suite.pairs.push_back(pair);
    }
    for (const auto& entry : tolerances.entries)
        if (std::none_of(names.begin(), names.end(),
                         [&](const std::string& name) { return matches(entry.pattern, name); }))
            suite.unused.push_back("line " + std::to_string(entry.line) + ": \"" +
                                   excerpt(entry.pattern) + "\" matches no file");
    return suite;
}

/// The documents beside a picture that may hold its geometry.
std::vector<std::string> documents_of(const std::string& picture)
{
    return {picture + ".json", fs::path(picture).replace_extension(".json").string()};
}

/// Replaces references by results, those named and no others.
int accept(const std::vector<std::string>& names, const SuiteFolders& folders)
{
    const auto results = pictures_in(folders.results, folders.references);
    for (const std::string& name : names) { // all of them, before any is replaced
        if (!results.count(name))
            throw InputError(
                folders.result(name) +
                ": there is no such picture to accept; name it as it is called within " +
                folders.results);
        read_frame(folders.result(name));
    }
    for (const std::string& name : names) {
        const std::string from = folders.result(name), to = folders.reference(name);
        std::error_code error;
        const bool is_new = !fs::exists(to, error);
        fs::create_directories(fs::path(to).parent_path(), error); // where it fails, writing says
                                                                   // why
        const auto old_documents = documents_of(to), new_documents = documents_of(from);
        for (std::size_t i = 0; i < new_documents.size(); ++i)
            if (fs::exists(new_documents[i], error))
                write_file(old_documents[i], read_file(new_documents[i]));
            else if (fs::exists(old_documents[i], error) && unlink(old_documents[i].c_str()) != 0)
                throw OutputError(
                    old_documents[i] +
                    ": cannot be deleted; the new reference has its geometry elsewhere");
        write_file(to, read_file(from));
        std::printf("accepted %s: %s %s\n", name.c_str(), to.c_str(),
                    is_new ? "is new" : "is replaced");
    }
    std::fflush(stdout);
    return exit_done;
}

/// What does not go together.
void check_options(const options::variables_map& arguments)
{
    if (!inputs_of(arguments).empty())
        throw UsageError(
            "with --suite no pictures are named; the folders are --suite and --references");
    if (given(arguments, "sheet"))
        throw UsageError("--sheet and --suite do not go together: each frame has its own geometry");
    for (const char* option : {"suite", "references", "tolerances", "junit"})
        if (given(arguments, option) && text_of(arguments, option).empty())
            throw UsageError(std::string("--") + option + ": a name is expected");
    const std::string output = text_of(arguments, "output"), extension = extension_of(output);
    if (!output.empty() && output != "-" && extension != "html" && extension != "htm")
        throw UsageError("-o " + output + ": with --suite it is a report, NAME.html");
    if (given(arguments, "accept"))
        for (const char* other : {"output", "junit", "tolerances", "json"})
            if (given(arguments, other))
                throw UsageError(
                    std::string("--accept and --") + other +
                    " do not go together: references are replaced, nothing is compared");
    if (output == "-" && text_of(arguments, "junit") == "-")
        throw UsageError("-o and --junit do not both go to standard output");
}

/// Compares all pairs, several at a time.
void compare_pairs(Suite& suite, int threads, const SuitePictures& pictures)
{
    const bool all = for_each_row(
        int(suite.pairs.size()), threads,
        [&](int i) { compare_pair(suite.pairs[std::size_t(i)], suite.folders, pictures); },
        progress_bar("comparing"));
    if (!all)
        throw Interrupted();
}

} // namespace

void add_suite_options(options::options_description& all)
{
    const auto text = [](const char* name) {
        return options::value<std::string>()->value_name(name);
    };
    options::options_description group("With --suite");
    group.add_options()("suite", text("FOLDER"),
                        "compare the pictures of a folder with their references. -o writes a "
                        "report, one HTML page; --json "
                        "prints all figures; the limits above take the place of the file's "
                        "defaults; --gain multiplies the report's differences, "
                        "by itself each so that it is seen")(
        "references", text("FOLDER"),
        "where the references are (default: the folder references beside --suite's)")(
        "tolerances", text("FILE"),
        "limits for all pictures and for some (default: suite.json among the references, if it is "
        "there)")("junit", text("FILE"), "write the outcome as JUnit XML, for CI systems")(
        "accept",
        options::value<std::vector<std::string>>()->multitoken()->composing()->value_name(
            "NAME..."),
        "compare nothing: make these results, by their names within the folder, the references")(
        "threads", options::value<int>()->value_name("N")->default_value(0),
        "threads to work with (0: one per core)");
    all.add(group);
}

void refuse_suite_options(const options::variables_map& arguments)
{
    for (const char* option : suite_options)
        if (given(arguments, option) && !arguments[option].defaulted())
            throw UsageError(std::string("--") + option + " goes with --suite FOLDER");
}

int run_suite(const options::variables_map& arguments)
{
    check_options(arguments);
    const int threads = in_range(arguments, "threads", 0, 1024);
    const std::string output = text_of(arguments, "output"), junit = text_of(arguments, "junit");
    SuitePictures pictures;
    pictures.wanted = !output.empty();
    if (!arguments["gain"].defaulted())
        pictures.gain = parse_number("gain", text_of(arguments, "gain"), "a number");
    const SuiteFolders folders = folders_from(arguments);
    if (given(arguments, "accept"))
        return accept(arguments["accept"].as<std::vector<std::string>>(), folders);

    std::string tolerance_file;
    const Tolerances tolerances = tolerances_from(arguments, folders, tolerance_file);
    for (const std::string& path : {output, junit})
        if (!path.empty())
            check_writable(path);
    Suite suite = suite_of(folders, tolerances, tolerance_file);
    compare_pairs(suite, threads, pictures);

    if (!output.empty())
        write_file(
            output,
            suite_page(suite, output == "-" ? "" : fs::absolute(output).parent_path().string()));
    if (!junit.empty())
        write_file(junit, suite_junit(suite));
    for (const SuitePair& pair : suite.pairs)
        for (const std::string& fault : pair.faults)
            say("compare", pair.name + ": " + fault);
    for (const std::string& fault : suite.unused)
        say("compare", suite.tolerances + ": " + fault);
    const std::string said = given(arguments, "json") ? suite_json(suite)
                                                      : suite_summary(suite) + "\n";
    if (output == "-" || junit == "-") // which has standard output
        std::fputs(said.c_str(), stderr);
    else
        write_file("-", said);
    return suite.passed() ? exit_done : exit_check_failed;
}

} // namespace integral
