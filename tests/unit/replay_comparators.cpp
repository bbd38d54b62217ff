// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks that a suite's report holds comparisons only up to its limit. compare_approve.test opens
// one in a browser.
#include "integral/io/image_file.h"
#include "integral/replay/suite_comparators.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>

#include <stdlib.h>

using namespace integral;

BOOST_AUTO_TEST_SUITE(replay_comparators)

namespace {

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_report_does_not_grow_beyond_its_limit)
{
    std::string folder = (std::filesystem::temp_directory_path() / "suite.XXXXXX").string();
    BOOST_REQUIRE(mkdtemp(folder.data()));
    Suite suite;
    suite.folders = {folder + "/it's", folder + "/references"};
    for (const std::string& path : {suite.folders.results, suite.folders.references})
        std::filesystem::create_directory(path);
    const Frame picture{make_image<std::uint8_t>(40, 30, 3, Encoding{}), std::nullopt};
    for (const char* name : {"a.png", "b.png", "c.png", "passed.png", "new.png", "damaged.png"}) {
        SuitePair pair;
        pair.name = name;
        pair.has_result = true;
        pair.has_reference = pair.name != "new.png";
        pair.state = pair.name == "passed.png"    ? PairState::passed
                     : pair.name == "new.png"     ? PairState::no_reference
                     : pair.name == "damaged.png" ? PairState::damaged
                                                  : PairState::over_limit;
        write_frame(suite.folders.result(name), picture);
        write_frame(suite.folders.reference(name), picture);
        suite.pairs.push_back(pair);
    }
    write_file(suite.folders.result("damaged.png"), "no picture");

    add_comparators(suite);
    const std::size_t each = suite.pairs[0].comparator.size();
    for (int k = 0; k < 3; ++k)
        BOOST_TEST(has(suite.pairs[k].comparator,
                       "data-comparison=\"comparison-" + std::to_string(k + 1) + "\""));
    for (int k = 3; k < 6; ++k)
        BOOST_TEST(suite.pairs[k].comparator == "");
    BOOST_TEST(has(suite.comparator, "id=\"comparison-shell\""));

    // Room for one and a half.
    add_comparators(suite, each + each / 2);
    BOOST_TEST(has(suite.pairs[0].comparator, "data-comparison"));
    for (int k : {1, 2}) {
        BOOST_TEST(!has(suite.pairs[k].comparator, "data-comparison"));
        BOOST_TEST(has(suite.pairs[k].comparator, "integral compare "));
        BOOST_TEST(has(suite.pairs[k].comparator, "&#39;\\&#39;&#39;")); // the folder's apostrophe
    }
    BOOST_TEST(suite.pairs[5].comparator == "");
    std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_SUITE_END()
