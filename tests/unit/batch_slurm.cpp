// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests what is made of Slurm's answers, with a squeue of our own. tests/cli/integral_slurm.test
// uses a real Slurm.
#include "integral/base/file_bytes.h"
#include "integral/batch/slurm.h"

#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <filesystem>

using namespace integral;

BOOST_AUTO_TEST_SUITE(batch_slurm)

namespace {

/// A folder, first on PATH, with a squeue that is this shell script. In it $jobs is the list of
/// jobs.
struct OwnSqueue {
    explicit OwnSqueue(const std::string& script)
    {
        char name[] = "/tmp/integral-unit.XXXXXX";
        BOOST_REQUIRE(mkdtemp(name));
        folder = name;
        write_file(folder + "/squeue",
                   "#!/bin/sh\nfor jobs; do :; done\njobs=${jobs#--jobs=}\n" + script);
        std::filesystem::permissions(folder + "/squeue", std::filesystem::perms::owner_all);
        setenv("PATH", (folder + ":" + path).c_str(), 1);
    }
    ~OwnSqueue()
    {
        setenv("PATH", path.c_str(), 1);
        std::filesystem::remove_all(folder);
    }
    std::string folder, path = std::getenv("PATH");
};

} // namespace

BOOST_AUTO_TEST_CASE(jobs_that_slurm_has_forgotten_hide_no_others)
{
    const OwnSqueue squeue(
        "case $jobs in\n"
        "7) echo '7_0|RUNNING|None'; echo '7_3|PENDING|Resources' ;;\n"
        "9) echo '9_1|PENDING|Priority' ;;\n"
        "*) echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1 ;;\n"
        "esac\n");
    const auto tasks = slurm_queue({"7", "8", "9"});
    BOOST_REQUIRE(tasks.size() == 3u);
    BOOST_TEST((tasks[0].job == "7" && tasks[0].task == 0 && tasks[0].state == "RUNNING"));
    BOOST_TEST((tasks[1].job == "7" && tasks[1].task == 3 && tasks[1].reason == "Resources"));
    BOOST_TEST((tasks[2].job == "9" && tasks[2].task == 1 && tasks[2].reason == "Priority"));
    BOOST_TEST(slurm_queue({"8"}).empty());
}

BOOST_AUTO_TEST_CASE(a_queue_that_is_not_read_to_its_end_is_an_error)
{
    // The controller goes after the first job.
    const OwnSqueue squeue(
        "case $jobs in\n"
        "7) echo '7_0|RUNNING|None' ;;\n"
        "9) echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1 ;;\n"
        "*) echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1 ;;\n"
        "esac\n");
    BOOST_CHECK_EXCEPTION(slurm_queue({"7", "8", "9"}), InputError, [](const InputError& error) {
        return std::string(error.what()) ==
               "squeue: slurm_load_jobs error: Unable to contact slurm controller";
    });
}

BOOST_AUTO_TEST_SUITE_END()
