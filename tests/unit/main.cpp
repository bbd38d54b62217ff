// SPDX-License-Identifier: AGPL-3.0-or-later
// The unit tests' program. Every other file of this folder adds its own BOOST_AUTO_TEST_SUITE. If
// tests/run starts it (which sets HARNESS_ACTIVE in the environment), it prints TAP, with a line
// for each test case; otherwise it prints Boost.Test's own output.
#define BOOST_TEST_MODULE unit
#include <boost/test/framework.hpp>
#include <boost/test/results_collector.hpp>
#include <boost/test/tree/observer.hpp>
#include <boost/test/unit_test.hpp>
#include <boost/test/unit_test_log.hpp>

#include <cstdlib>
#include <iostream>
#include <sstream>

namespace {

using namespace boost::unit_test;

class Tap : public test_observer {
public:
    Tap()
    {
        if (std::getenv("HARNESS_ACTIVE"))
            framework::register_observer(*this);
    }

private:
    void test_unit_start(const test_unit&) override { unit_test_log.set_stream(log_); }
    void test_unit_finish(const test_unit& unit, unsigned long) override
    {
        if (unit.p_type != TUT_CASE)
            return;
        const bool passed = results_collector.results(unit.p_id).passed();
        std::cout << (passed ? "ok " : "not ok ") << ++count_ << " - " << unit.full_name() << '\n';
        if (!passed)
            say_log();
        log_.str("");
    }
    void test_unit_skipped(const test_unit& unit, const_string reason) override
    {
        if (unit.p_type == TUT_CASE)
            std::cout << "ok " << ++count_ << " - " << unit.full_name() << " # SKIP " << reason
                      << '\n';
    }
    /// Errors outside of test cases make no line of TAP; the exit status reports them.
    void test_finish() override
    {
        say_log();
        unit_test_log.set_stream(std::cout);
        std::cout << "1.." << count_ << std::endl;
    }
    int priority() override
    {
        return 5;
    } // called after Boost.Test's own observers, whose results
      // it prints

    void say_log()
    {
        std::istringstream lines(log_.str());
        for (std::string line; std::getline(lines, line);)
            std::cout << "# " << line << '\n';
    }
    int count_ = 0;
    std::ostringstream log_;
} tap;

} // namespace
