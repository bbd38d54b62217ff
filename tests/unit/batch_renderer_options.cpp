// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests that povray-integral's options are read as POV-Ray reads them.
#include "integral/batch/renderer_options.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(batch_renderer_options)

namespace {

/// "k:NAME=VALUE" for a keyword, "l:NAME=VALUE" for letters, "p:PATH", separated by " | ".
std::string read(const std::string& word)
{
    std::string text;
    for (const RendererOption& option : renderer_options_in(word)) {
        text += text.empty() ? "" : " | ";
        if (option.kind == RendererOption::Kind::path)
            text += "p:" + option.value;
        else
            text += (option.kind == RendererOption::Kind::keyword ? "k:" : "l:") + option.name +
                    "=" + option.value;
    }
    return text;
}

} // namespace

BOOST_AUTO_TEST_CASE(words_are_split)
{
    BOOST_TEST(read("") == "");
    BOOST_TEST(read(" \t\n") == "");
    BOOST_TEST(read("+A0.3") == "l:A0.3=");
    BOOST_TEST(read(" +A0.3\t-d ") == "l:A0.3= | l:d=");
    BOOST_TEST(read("+O\"a file\"+W3") == "l:O=a file | l:W3=");
    BOOST_TEST(read("-GA'x \"y\".txt'") == "l:GA=x \"y\".txt");
    BOOST_TEST(read("Width=3 Create_Ini=\"a b\"") == "k:Width=3 | k:Create_Ini=a b");
    BOOST_TEST(read("quick.ini[draft] \"my scene.pov\" lib/") ==
               "p:quick.ini[draft] | p:my scene.pov | p:lib/");
    BOOST_TEST(read("Integral_camera=square { pitch 1 } +W3") ==
               "k:integral_camera=square { pitch 1 } +W3");
    BOOST_TEST(read(" Integral_Camera=x y") == "k:Integral_Camera=x | p:y");
    BOOST_TEST(read("\"never ends") == "p:never ends");
    BOOST_TEST(read("+A;+B#Width=3") == "l:A= | l:B= | k:Width=3");
    BOOST_TEST(read("=3 [a] + -") == "k:=3 | p:[a] | l:= | l:=");
}

BOOST_AUTO_TEST_CASE(the_last_value_counts)
{
    BOOST_TEST(value_of_option({"+WT2", "+A0.3 work_threads=3"}, "work_threads", "wt") == "3");
    BOOST_TEST(value_of_option({"Work_Threads=3", "-wt\"4\"", "+W5"}, "work_threads", "wt") == "4");
    BOOST_TEST(value_of_option({"+LFolder/A"}, "library_path", "l") == "Folder/A");
    BOOST_TEST(value_of_option({"Depth=a.exr", "Depth="}, "depth", "") == "");
    BOOST_TEST(value_of_option({"+L"}, "library_path", "l") == "");
    BOOST_TEST(
        values_of_option({"+La Library_Path=\"b c\"", "+L'd'"}, "library_path", "l").size() == 3u);
}

BOOST_AUTO_TEST_CASE(names_are_quoted)
{
    for (const std::string name : {"a b.pov", "a\"b.pov", "it's.pov", "+W300 x=3.pov"}) {
        BOOST_TEST(can_be_quoted(name), name);
        BOOST_TEST(read("+I" + quoted(name)) == "l:I=" + name);
    }
    BOOST_TEST(!can_be_quoted("\"it's\""));
}

BOOST_AUTO_TEST_SUITE_END()
