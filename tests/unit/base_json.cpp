// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the reader of JSON documents: values, line numbers and limits.
#include "integral/base/json.h"
#include "integral/base/json_fields.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(base_json)

namespace {

/// The error messages of each way of reading a document; empty if it is accepted.
std::string refusal(const std::string& text)
{
    std::string plain, lined;
    try {
        parse_json(text);
    } catch (const JsonError& error) {
        plain = error.what();
        BOOST_TEST(plain == "line " + std::to_string(error.line) + ": " + error.reason);
    }
    try {
        const LinedJson document(text);
    } catch (const JsonError& error) {
        lined = error.what();
    }
    BOOST_TEST(plain == lined);
    return plain;
}

std::string repeated(const std::string& text, std::size_t count)
{
    std::string all;
    for (std::size_t k = 0; k < count; ++k)
        all += text;
    return all;
}

std::string fields(std::size_t count)
{
    std::string text = "{";
    for (std::size_t k = 0; k < count; ++k)
        text += (k == 0 ? "\"field " : ",\"field ") + std::to_string(k) + "\":" + std::to_string(k);
    return text + "}";
}

} // namespace

BOOST_AUTO_TEST_CASE(values_are_those_that_the_library_reads)
{
    for (const char* text :
         {"null", "true", "-0", "18446744073709551615", "-9223372036854775808", "1e5", "0.1",
          "\"\"", "\"a\\u00e9\\n\"", "[]", "{}", " [1, [2, {}], []] ",
          "{\"b\": {\"z\": 1, \"a\": [true, null, \"x\"]}, \"a\": -1.5, \"\": 0}",
          "\xef\xbb\xbf[1]"}) {
        const Json requested = Json::parse(text), read = parse_json(text);
        BOOST_TEST(read == requested, text);
        BOOST_TEST(read.dump() == requested.dump(),
                   text); // also equal kinds of numbers and order of fields
        BOOST_TEST(LinedJson(text).root().dump() == requested.dump(), text);
    }
}

BOOST_AUTO_TEST_CASE(values_know_their_lines)
{
    const LinedJson document("\n{\"a\": [\n 1,\n\n 2], \"b\":\n {\"a\": \"x\" }\n}\n");
    const Json& root = document.root();
    BOOST_TEST(document.line_of(root) == 2);
    BOOST_TEST(document.line_of(root["a"]) == 2);
    BOOST_TEST(document.line_of(root["a"][0]) == 3);
    BOOST_TEST(document.line_of(root["a"][1]) == 5);
    BOOST_TEST(document.line_of(root["b"]) == 6);
    BOOST_TEST(document.line_of(root["b"]["a"]) == 6);
    const LinedJson bare("\n\n7");
    BOOST_TEST(bare.line_of(bare.root()) == 3);
}

BOOST_AUTO_TEST_CASE(what_is_no_json_is_refused_with_its_line)
{
    BOOST_TEST(refusal("") == "line 1: this is no JSON: it is empty");
    BOOST_TEST(refusal("{\n\"a\": 1,\n}") ==
               "line 3: this is no JSON: unexpected '}'; expected string literal");
    BOOST_TEST(refusal("[1]\n[2]") ==
               "line 2: this is no JSON: unexpected '['; expected end of input");
    BOOST_TEST(refusal("[\n1e999]") == "line 2: a number is out of range");
    BOOST_TEST(refusal("{\"a\": 1,\n\"b\": {\"a\": 2},\n\"a\": 3}") ==
               "line 3: the field a stands twice in one object");
    BOOST_TEST(refusal("[\"\xff\"]").find("line 1: this is no JSON: invalid string") == 0);
}

BOOST_AUTO_TEST_CASE(depth_is_limited)
{
    const auto nested = [](std::size_t depth) {
        return repeated("[\n", depth) + repeated("]", depth);
    };
    const auto objects = [](std::size_t depth) {
        return repeated("{\"a\":", depth) + "1" + repeated("}", depth);
    };
    BOOST_TEST(refusal(nested(deepest_json)) == "");
    BOOST_TEST(refusal(objects(deepest_json)) == "");
    BOOST_TEST(refusal(nested(deepest_json + 1)) ==
               "line 65: objects and lists are nested more than 64 deep; nest them less");
    for (const std::string& text :
         {objects(deepest_json + 1), objects(200000), repeated("[", 1000000),
          repeated("{\"a\":[", 300000), repeated("[[],", 300000)})
        BOOST_TEST(refusal(text) ==
                   "line 1: objects and lists are nested more than 64 deep; nest them less");
}

BOOST_AUTO_TEST_CASE(an_objects_fields_are_limited)
{
    const Json most = parse_json(fields(most_json_fields));
    BOOST_TEST(most.size() == most_json_fields);
    BOOST_TEST(most.at("field 99999") == 99999);
    BOOST_TEST(refusal(fields(most_json_fields + 1)) ==
               "line 1: an object has more than 100000 fields; leave some out");
    BOOST_TEST(refusal("[" + fields(60000) + "," + fields(60000) + "]") == "");
    const std::string longest(longest_json_name, 'n');
    BOOST_TEST(refusal("{\"" + longest + "\": 1}") == "");
    BOOST_TEST(refusal("{\n\"" + longest + "n\": 1}") ==
               "line 2: the name of a field has more than 4096 bytes; shorten it");
}

BOOST_AUTO_TEST_CASE(a_documents_size_is_limited)
{
    const std::size_t bytes = most_json_megabytes << 20;
    BOOST_TEST(refusal("7" + std::string(bytes - 1, ' ')) == "");
    BOOST_TEST(refusal("7" + std::string(bytes, ' ')) ==
               "line 1: the document has more than 16 MB; leave some of it out");
    BOOST_TEST(refusal("[" + repeated("0,", most_json_values - 2) + "0]") == "");
    BOOST_TEST(refusal("[" + repeated("0,", most_json_values - 1) + "0]") ==
               "line 1: the document has more than 1000000 values; leave some out");
    BOOST_TEST(refusal("\"" + std::string(1000000, 'x') + "\"") == "");
}

BOOST_AUTO_TEST_CASE(messages_are_short)
{
    const std::string megabyte(1000000, 'x');
    for (const std::string& text :
         {megabyte, "\"" + megabyte, "{\"" + megabyte + "\": 1}", "[1" + megabyte + "]",
          "{\"a\": 1,\"a\": \"" + megabyte + "\"}"})
        BOOST_TEST(refusal(text).size() < 250, refusal(text).substr(0, 100));
    const std::string name(1000, 'n');
    BOOST_TEST(refusal("{\"" + name + "\": 1, \"" + name + "\": 2}") ==
               "line 1: the field " + std::string(80, 'n') + "... stands twice in one object");
}

BOOST_AUTO_TEST_CASE(a_refused_field_lists_the_legal_fields)
{
    const Json json = parse_json("{\"b\": 1, \"d\": 2}");
    std::string reason;
    try {
        throw_on_unknown_fields({json, "thing"}, {"a", "b", "c"});
    } catch (const std::exception& error) {
        reason = error.what();
    }
    BOOST_TEST(reason == "thing.d is not a field of it: those are a, b and c");
    BOOST_CHECK_NO_THROW(throw_on_unknown_fields({json, "thing"}, {"a", "b", "d"}));
}

BOOST_AUTO_TEST_SUITE_END()
