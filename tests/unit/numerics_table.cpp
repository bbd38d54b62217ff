// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares the errors measured in this run with the ones in doc/numerics.md. With
// NUMERICS_TABLE=FILE in the environment, writes the table of this run to that file, in Markdown.
#include "tests/unit/numerics_table.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace {

constexpr int columns = 4;

/// Largest error, and largest ratio of error to allowed error. Nothing was measured if count is 0.
struct Cell {
    long count = 0;
    double error = 0, share = 0;
};

struct Row {
    std::string what, quantity;
    std::array<Cell, columns> cells;
};

/// The rows, in the order in which they were first recorded.
std::vector<Row>& rows()
{
    static std::vector<Row> all;
    return all;
}

/// Two digits, rounded up.
std::string two_digits(double value)
{
    if (value == 0)
        return "0";
    int exponent = static_cast<int>(std::floor(std::log10(value)));
    long digits = static_cast<long>(std::ceil(value / std::pow(10.0, exponent - 1) * (1 - 1e-12)));
    if (digits >= 100) {
        digits = 10;
        ++exponent;
    }
    std::ostringstream text;
    text << digits / 10 << '.' << digits % 10;
    if (exponent)
        text << 'e' << exponent;
    return text.str();
}

std::string text_of(const Cell& cell)
{
    return cell.count ? two_digits(cell.error) + " (" + two_digits(cell.share) + ")" : "";
}

void write_table(std::ostream& out)
{
    out << "| what | quantity | usual sheets | 1e-12 allowed | to 1e-6 | to 0.1 "
           "|\n|---|---|---|---|---|---|\n";
    for (const Row& row : rows()) {
        out << "| " << row.what << " | " << row.quantity << " |";
        for (const Cell& cell : row.cells)
            out << ' ' << text_of(cell) << (cell.count ? " |" : "|");
        out << '\n';
    }
}

struct TableFile {
    ~TableFile()
    {
        const char* name = std::getenv("NUMERICS_TABLE");
        if (!name || !*name || rows().empty())
            return;
        std::ofstream file(name);
        write_table(file);
        if (!file.flush())
            std::abort(); // nothing else fails the program this late
    }
};

std::string trimmed(const std::string& text)
{
    const auto first = text.find_first_not_of(' ');
    return first == std::string::npos ? ""
                                      : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The rows of the document's table: what and quantity, then the columns' texts.
std::map<std::string, std::vector<std::string>> documented(std::istream& document)
{
    std::map<std::string, std::vector<std::string>> table;
    bool inside = false;
    for (std::string line; std::getline(document, line);) {
        if (line.rfind("<!-- table", 0) == 0)
            inside = true;
        else if (line.rfind("<!-- end", 0) == 0)
            inside = false;
        if (!inside || line.rfind("| ", 0) != 0 || line.rfind("| what |", 0) == 0)
            continue;
        std::istringstream fields(line.substr(1));
        std::vector<std::string> cells;
        for (std::string field; std::getline(fields, field, '|');)
            cells.push_back(trimmed(field));
        BOOST_REQUIRE(cells.size() == 2 + columns);
        table[cells[0] + ": " + cells[1]] = {cells.begin() + 2, cells.end()};
    }
    return table;
}

} // namespace

void numerics::record(const std::string& what, const std::string& quantity, bool usual,
                      double error, double allowed)
{
    if (!(allowed <= 0.1))
        return;
    auto row = rows().begin();
    while (row != rows().end() && (row->what != what || row->quantity != quantity))
        ++row;
    if (row == rows().end())
        row = rows().insert(row, {what, quantity, {}});
    Cell& cell = row->cells[usual ? 0 : allowed <= 1e-12 ? 1 : allowed <= 1e-6 ? 2 : 3];
    ++cell.count;
    cell.error = std::fmax(cell.error, error);
    cell.share = std::fmax(cell.share, error / allowed);
}

BOOST_TEST_GLOBAL_FIXTURE(TableFile);

// Runs after the suites that record.
BOOST_AUTO_TEST_SUITE(optics_numerics, *boost::unit_test::depends_on("optics_rays") *
                                           boost::unit_test::depends_on("optics_beam"))

BOOST_AUTO_TEST_CASE(figures_are_rounded_up_to_two_digits)
{
    BOOST_TEST(two_digits(0.1) == "1.0e-1");
    BOOST_TEST(two_digits(1.21e-15) == "1.3e-15");
    BOOST_TEST(two_digits(9.95e-3) == "1.0e-2");
    BOOST_TEST(two_digits(3) == "3.0");
    BOOST_TEST(std::stod(two_digits(1.2345e-13)) >= 1.2345e-13);
}

BOOST_AUTO_TEST_CASE(the_document_states_what_is_measured)
{
    const char* top = std::getenv("TOP");
    std::ifstream document(std::string(top ? top : ".") + "/doc/numerics.md");
    BOOST_REQUIRE_MESSAGE(document,
                          "doc/numerics.md cannot be read; TOP names the folder that holds doc");
    auto table = documented(document);
    for (const Row& row : rows()) {
        const std::string name = row.what + ": " + row.quantity;
        const auto stated = table.find(name);
        BOOST_TEST((stated != table.end()),
                   name << " is not in doc/numerics.md; LONG=1 make numerics writes it");
        if (stated == table.end())
            continue;
        for (int column = 0; column < columns; ++column) {
            const Cell& cell = row.cells[column];
            if (!cell.count)
                continue;
            double error = -1, share = -1;
            char bracket;
            std::istringstream(stated->second[column]) >> error >> bracket >> share;
            const auto where = name + ", column " + std::to_string(column + 1) + ": stated " +
                               stated->second[column];
            BOOST_TEST(cell.error <= error * (1 + 1e-9), where << ", measured " << text_of(cell));
            BOOST_TEST(cell.share <= share * (1 + 1e-9), where << ", measured " << text_of(cell));
        }
        table.erase(stated);
    }
    for (const auto& [name, cells] : table)
        BOOST_ERROR(name << " is in doc/numerics.md, but nothing measures it");
}

BOOST_AUTO_TEST_SUITE_END()
