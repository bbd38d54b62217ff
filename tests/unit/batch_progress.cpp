// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests how the steps of a batch add up to jobs: when a job ends, whether it failed, how much of
// the work is done.
#include "integral/batch/batch_progress.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

namespace {

/// Two jobs: frames of 100 x 50 and 200 x 50 pixels, and two prints of each.
BatchPlan plan_of_two()
{
    BatchPlan plan;
    for (int job = 0; job < 2; ++job) {
        const int frame = int(plan.steps.size());
        plan.frames.push_back(frame);
        for (int k = 0; k < 3; ++k) {
            BatchStep step;
            step.job = job;
            if (k == 0)
                step.size = {100 * (job + 1), 50};
            else {
                step.kind = StepKind::print;
                step.frame = frame;
            }
            plan.steps.push_back(step);
        }
    }
    return plan;
}

struct Fixture {
    BatchPlan plan = plan_of_two();
    std::vector<BatchJob> jobs{BatchJob(), BatchJob()};
    Fixture()
    {
        jobs[0].name = "first";
        jobs[1].name = "second";
    }
    WorkMeter meter() const { return WorkMeter(plan, jobs, {0, 1, 2, 3, 4, 5}); }
};

} // namespace

BOOST_AUTO_TEST_SUITE(batch_progress)

BOOST_AUTO_TEST_CASE(a_job_has_failed_if_any_of_its_steps_has)
{
    const Fixture batch;
    for (int failing = -1; failing < 3; ++failing) {
        WorkMeter meter = batch.meter();
        BOOST_TEST(!meter.end(0, failing == 0, 5));
        BOOST_TEST(!meter.end(4, false, 1));
        BOOST_TEST(!meter.end(1, failing == 1, 2));
        const auto job = meter.end(2, failing == 2, 3);
        BOOST_REQUIRE(job.has_value());
        BOOST_TEST(job->job == "first");
        BOOST_TEST(job->failed == (failing >= 0), "failing step " << failing);
        BOOST_TEST(job->seconds == 10);
        BOOST_TEST(job->ended == 1);
        BOOST_TEST(job->jobs == 2);
        meter.end(3, false, 1);
        const auto next = meter.end(5, false, 1);
        BOOST_REQUIRE(next.has_value());
        BOOST_TEST(next->job == "second");
        BOOST_TEST(!next->failed);
        BOOST_TEST(next->ended == 2);
    }
}

BOOST_AUTO_TEST_CASE(work_is_pixels_and_a_hundredth_of_them_for_what_follows)
{
    const Fixture batch;
    WorkMeter meter = batch.meter();
    const double all = 1.02 * (5000 + 10000);
    BOOST_TEST(meter.state({}, 10).done == 0);
    BOOST_TEST(!meter.state({}, 10).seconds_left);
    meter.end(0, false, 5);
    BOOST_TEST(std::fabs(meter.state({}, 10).done - 5000 / all) < 1e-12);
    const BatchState state = meter.state({{1, 0.5}, {3, 0.25}}, 10);
    const double done = (5000 + 25 + 2500) / all;
    BOOST_TEST(std::fabs(state.done - done) < 1e-12);
    BOOST_TEST(std::fabs(state.seconds_left.value() - 10 * (1 - done) / done) < 1e-9);
    BOOST_TEST((state.jobs == std::vector<std::string>{"first", "second"}));
    BOOST_TEST(!meter.state({}, 1).seconds_left);
}

BOOST_AUTO_TEST_SUITE_END()
