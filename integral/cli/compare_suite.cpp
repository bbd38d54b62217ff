// SPDX-License-Identifier: AGPL-3.0-or-later
// integral compare --suite: the pictures of two folders.
#include "integral/base/file_bytes.h"
#include "integral/cli/compare_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/compare/suite_accept.h"
#include "integral/compare/suite_renames.h"
#include "integral/compare/suite_run.h"
#include "integral/compare/suite_summary.h"
#include "integral/replay/compare_seen.h"
#include "integral/replay/suite_comparators.h"
#include "integral/studio/approval_page.h"

#include <cstdio>
#include <filesystem>

namespace integral {
namespace {

/// Throws UsageError for options that --suite excludes.
void check_suite_options(const CompareOptions& o)
{
    if (!o.inputs.empty())
        throw UsageError(
            "with --suite no pictures are named; the folders are --suite and --references");
    if (o.sheet)
        throw UsageError("--sheet and --suite do not go together: each frame has its own geometry");
    if (o.html)
        throw UsageError("--html and --suite do not go together: the suite's report is -o");
    if (o.flip_map)
        throw UsageError("--flip-map and --suite do not go together: the report has the maps");
    const auto is_empty = [](const std::optional<std::string>& text) {
        return text && text->empty();
    };
    if (const char* option = first_given({{"suite", is_empty(o.suite)},
                                          {"references", is_empty(o.references)},
                                          {"tolerances", is_empty(o.tolerances)},
                                          {"junit", is_empty(o.junit)},
                                          {"summary", is_empty(o.summary)}}))
        throw UsageError(std::string("--") + option + ": a name is expected");
    const std::string output = o.output.value_or(""), extension = extension_of(output);
    if (!output.empty() && output != "-" && extension != "html" && extension != "htm")
        throw UsageError("-o " + output + ": with --suite it is a report, NAME.html");
    if (const char* other = first_given({{"output", o.output},
                                         {"junit", o.junit},
                                         {"summary", o.summary},
                                         {"create", o.create},
                                         {"tolerances", o.tolerances},
                                         {"json", o.json}});
        o.accept && other)
        throw UsageError(std::string("--accept and --") + other +
                         " do not go together: references are replaced, nothing is compared");
    if (const char* other = first_given({{"accept", bool(o.accept)},
                                         {"output", o.output},
                                         {"junit", o.junit},
                                         {"summary", o.summary},
                                         {"create", o.create},
                                         {"json", o.json}});
        o.approve && other)
        throw UsageError(std::string("--approve and --") + other +
                         " do not go together: its page shows the outcome, and references are "
                         "replaced there");
    if (!o.approve)
        throw_if_given({{"port", o.port}, {"no-browser", o.no_browser}}, "is for --approve");
    if ((output == "-") + (o.junit == "-") + (o.summary == "-") > 1)
        throw UsageError("only one of -o, --junit and --summary goes to standard output");
}

/// Accepts results as references; prints a line for each, to standard error if `errors`.
void accept(const Arguments& names, const SuiteFolders& folders, const char* verb, bool errors)
{
    accept_results(names, folders,
                   [&](const std::string& name, const std::string& reference, const char* now) {
                       std::fprintf(errors ? stderr : stdout, "%s %s: %s %s\n", verb, name.c_str(),
                                    reference.c_str(), now);
                   });
    std::fflush(stdout);
}

/// Writes and prints the outcome of the comparison. Returns an ExitStatus.
int report(const Suite& suite, const CompareOptions& o)
{
    const std::string output = o.output.value_or(""), junit = o.junit.value_or("");
    if (!output.empty()) {
        const std::string folder = output == "-"
                                       ? ""
                                       : std::filesystem::absolute(output).parent_path().string();
        write_file(output, suite_page(suite, folder));
    }
    if (!junit.empty())
        write_file(junit, suite_junit(suite));
    if (o.summary)
        write_suite_summary(suite, *o.summary);
    for (const SuitePair& pair : suite.pairs)
        for (const std::string& fault : pair.faults)
            say("compare", pair.name + ": " + fault);
    for (const std::string& fault : suite.unused)
        say("compare", suite.tolerances + ": " + fault);
    const std::string said = o.json ? suite_json(suite) : suite_summary(suite) + "\n";
    print_figures(said, output == "-" || junit == "-" || o.summary == "-");
    return suite.passed() ? exit_done : exit_check_failed;
}

/// Serves the page on which pictures are accepted. Returns exit_done if all were accepted.
int approve(const Suite& suite, const CompareOptions& o)
{
    for (const std::string& fault : suite.unused)
        say("compare", suite.tolerances + ": " + fault);
    Approval approval(suite,
                      [](const std::string& name, const std::string& reference, const char* now) {
                          std::printf("accepted %s: %s %s\n", name.c_str(), reference.c_str(), now);
                          std::fflush(stdout);
                      });
    if (approval.counts().undecided == 0) {
        std::printf("%s: nothing to accept\n", suite_summary(suite).c_str());
        return suite.passed() ? exit_done : exit_check_failed;
    }
    Server server(o.port ? in_range("port", *o.port, 1, 65535) : 0,
                  [&](const ServerRequest& request) { return approval.answer(request); });
    std::printf("%s; the page: %s\n", suite_summary(suite).c_str(), server.address().c_str());
    std::fflush(stdout);
    if (!o.no_browser)
        open_in_browser(server.address());
    server.run([&] { return approval.has_ended(); });
    const ApprovalCounts counts = approval.counts();
    std::printf("%s\n", approval_summary(counts).c_str());
    std::fflush(stdout);
    if (!approval.has_ended())
        throw Interrupted();
    return counts.rejected + counts.undecided == 0 && suite.unused.empty() ? exit_done
                                                                           : exit_check_failed;
}

} // namespace

int run_suite(const CompareOptions& o)
{
    check_suite_options(o);
    const int threads = o.threads.count();
    SuitePictures pictures;
    pictures.requested = !o.output.value_or("").empty();
    read_number("gain", o.gain, pictures.gain);
    pictures.thumbnails = o.summary && o.summary != "-";
    const SuiteFolders folders = suite_folders(*o.suite, o.references,
                                               o.accept || o.create || o.approve);
    if (o.accept) {
        accept(*o.accept, folders, "accepted", false);
        return exit_done;
    }

    SuiteTolerances tolerances = read_tolerances(folders, o.tolerances);
    const Limits limits = limits_of(o);
    for (std::size_t kind = 0; kind < limit_count; ++kind)
        if (limits[kind])
            tolerances.tolerances.defaults[kind] = limits[kind];
    change_rules(tolerances.tolerances.default_rules, o, limits);
    for (const std::string& path :
         {o.output.value_or(""), o.junit.value_or(""), o.summary.value_or("")})
        if (!path.empty())
            check_writable(path);
    if (o.create)
        accept(results_without_reference(folders), folders, "created", true);
    Suite suite = suite_of(folders, tolerances);
    if (!compare_suite(suite, pictures, compare_seen, threads, progress_bar("comparing")))
        throw Interrupted();
    note_renames(suite);
    if (o.approve)
        return approve(suite, o);
    if (pictures.requested)
        add_comparators(suite);
    return report(suite, o);
}

} // namespace integral
