// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests message texts: one line without control characters, of limited length.
#include "integral/base/file_bytes.h"
#include "integral/base/message_text.h"

#include <boost/test/unit_test.hpp>

#include <new>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(base_message_text)

BOOST_AUTO_TEST_CASE(excerpts)
{
    BOOST_TEST(excerpt("") == "");
    BOOST_TEST(excerpt(std::string(80, 'a')) == std::string(80, 'a'));
    BOOST_TEST(excerpt(std::string(81, 'a')) == std::string(80, 'a') + "...");
    BOOST_TEST(excerpt("abcdef", 3) == "abc...");
    BOOST_TEST(excerpt("a\xc3\xa9"
                       "bc",
                       2) == "a..."); // not half of an é
    BOOST_TEST(excerpt("a\xc3\xa9"
                       "bc",
                       3) == "a\xc3\xa9...");
    BOOST_TEST(excerpt("\xf0\x9f\x99\x82\xf0\x9f\x99\x82", 7) == "\xf0\x9f\x99\x82...");
    BOOST_TEST(excerpt(std::string(100, '\x80')).size() >= 77); // also for text that is not UTF-8
}

BOOST_AUTO_TEST_CASE(lines)
{
    BOOST_TEST(one_line("a\nb\tc\x7f") == "a?b?c?");
    BOOST_TEST(one_line("\xc3\xa9") == "\xc3\xa9");
    const std::string line = one_line("file.png: " + std::string(1000000, '\n'));
    BOOST_TEST(line == "file.png: " + std::string(1990, '?') + "...");
}

BOOST_AUTO_TEST_CASE(reasons)
{
    BOOST_TEST(reason_of(std::bad_alloc()) == "it needs more memory than there is");
    BOOST_TEST(reason_of(std::runtime_error("it is empty")) == "it is empty");
}

BOOST_AUTO_TEST_CASE(one_line_has_no_control_characters)
{
    BOOST_TEST(one_line("a\tb\n\033]0;x\a\x7f") == "a?b??]0;x??");
    BOOST_TEST(one_line("\xc2\x9b"
                        "31m \xc2\x80\xc2") == "??31m ??\xc2");
    BOOST_TEST(one_line("caf\xc3\xa9 \xc2\xa0\xe2\x82\xac") == "caf\xc3\xa9 \xc2\xa0\xe2\x82\xac");
    BOOST_TEST(InputError("a\033").what() == std::string("a?"));
    BOOST_TEST(OutputError("a\033").what() == std::string("a?"));
}

BOOST_AUTO_TEST_SUITE_END()
