// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/obj_file.h"

#include "integral/base/atomic_file.h"
#include "integral/base/file_bytes.h"
#include "integral/frame/encoding.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <unistd.h>

namespace integral {
namespace {

using Word = std::string_view;

Colour from_file(double r, double g, double b)
{
    const Encoding srgb;
    return {float(decode(srgb, r)), float(decode(srgb, g)), float(decode(srgb, b)), 1};
}

/// The statements of a file, one after the other: their words, and the line they begin at.
class Statements {
public:
    explicit Statements(const std::string& path) : path_(path), text_(read_file(path)), rest_(text_)
    {
    }
    Statements(const Statements&) = delete; // rest_ is a part of text_

    /// The next statement that is not empty; false at the end. A line that ends in a backslash
    /// continues on the next.
    bool next(std::vector<Word>& words)
    {
        words.clear();
        while (words.empty() && !rest_.empty()) {
            line_ = next_line_;
            bool continues = true;
            while (continues && !rest_.empty())
                continues = add_line(words);
        }
        return !words.empty();
    }

    /// A message about the statement: the file's name, the line, what is wrong.
    std::string located(const std::string& what) const
    {
        return display_name(path_, "standard input") + ": line " + std::to_string(line_) + ": " +
               what;
    }

    [[noreturn]] void fail(const std::string& what) const { throw InputError(located(what)); }

    double number(Word word) const
    {
        double value = 0;
        const char* end = word.data() + word.size();
        const char* begin = word.data() + (!word.empty() && word[0] == '+');
        const auto read = std::from_chars(begin, end, value);
        if (read.ec != std::errc() || read.ptr != end || !(std::fabs(value) <= 1e30))
            fail(excerpt(std::string(word)) + " is no number");
        return value;
    }

private:
    /// Returns whether the line continues on the next.
    bool add_line(std::vector<Word>& words)
    {
        const std::size_t end = rest_.find('\n');
        Word line = rest_.substr(0, end);
        rest_ = end == Word::npos ? Word{} : rest_.substr(end + 1);
        ++next_line_;
        line = line.substr(0, line.find('#'));
        while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
            line.remove_suffix(1);
        const bool continues = !line.empty() && line.back() == '\\';
        if (continues)
            line.remove_suffix(1);
        constexpr const char* blanks = " \t";
        for (std::size_t at = line.find_first_not_of(blanks); at != Word::npos;) {
            const std::size_t stop = std::min(line.find_first_of(blanks, at), line.size());
            words.push_back(line.substr(at, stop - at));
            at = line.find_first_not_of(blanks, stop);
        }
        return continues;
    }

    std::string path_, text_;
    Word rest_;
    int line_ = 0, next_line_ = 1;
};

/// The name in a statement: all of its words after the first, as names may have spaces.
std::string name_in(const std::vector<Word>& words)
{
    std::string name(words.size() > 1 ? words[1] : Word());
    for (std::size_t k = 2; k < words.size(); ++k)
        name += " " + std::string(words[k]);
    return name;
}

using Materials = std::map<std::string, Colour>;

/// Adds the diffuse colours (Kd) of an MTL file.
void read_materials(Statements& file, Materials& materials)
{
    std::vector<Word> words;
    Colour* current = nullptr;
    while (file.next(words)) {
        if (words[0] == "newmtl" && words.size() > 1)
            current = &materials.insert_or_assign(name_in(words), Colour{1, 1, 1, 1}).first->second;
        if (words[0] != "Kd")
            continue;
        if (words.size() != 4 || !current)
            file.fail("a material's colour is newmtl NAME, then Kd R G B");
        *current = from_file(file.number(words[1]), file.number(words[2]), file.number(words[3]));
    }
}

class ObjReader {
public:
    ObjReader(const std::string& path, const MeshReading& how) : path_(path), how_(how), file_(path)
    {
    }

    Mesh read()
    {
        std::vector<Word> words;
        while (file_.next(words))
            read_statement(words);
        if (mesh_.vertices.empty())
            throw InputError(display_name(path_, "standard input") +
                             ": it has no vertices (statements v)");
        mesh_.is_cloud = mesh_.points.empty() && mesh_.lines.empty() && mesh_.triangles.empty();
        if (mesh_.is_cloud)
            for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v)
                mesh_.points.push_back({v, colour_at(v)});
        keep_each_edge_once(mesh_);
        return std::move(mesh_);
    }

private:
    void read_statement(const std::vector<Word>& words)
    {
        const Word what = words[0];
        if (what == "v")
            return add_vertex(words);
        if (what == "f")
            return add_face(words);
        if (what == "l")
            return add_lines(words);
        if (what == "p") {
            at_least(words, 1, "p needs a vertex");
            for (std::size_t k = 1; k < words.size(); ++k) {
                const std::uint32_t v = vertex(words[k]);
                mesh_.points.push_back({v, colour_at(v)});
            }
            return;
        }
        if (what == "usemtl")
            return use_material(words);
        if (what == "mtllib")
            return read_library(words);
        const Word skipped[] = {"vt", "vn", "o", "g", "s"};
        if (std::find(std::begin(skipped), std::end(skipped), what) == std::end(skipped))
            file_.fail(excerpt(std::string(what)) +
                       " is not read; vertices (v), points (p), lines (l) and faces (f) are");
    }

    void at_least(const std::vector<Word>& words, std::size_t most, const char* what) const
    {
        if (words.size() < most + 1)
            file_.fail(what);
    }

    void add_vertex(const std::vector<Word>& words)
    {
        const std::size_t n = words.size() - 1;
        if (n != 3 && n != 4 && n != 6)
            file_.fail("a vertex is v X Y Z, perhaps with a colour R G B after it");
        mesh_.vertices.push_back(
            {file_.number(words[1]), file_.number(words[2]), file_.number(words[3])});
        if (n == 6 && !how_.ignore_colours) {
            colours_.resize(mesh_.vertices.size());
            colours_.back() = from_file(file_.number(words[4]), file_.number(words[5]),
                                        file_.number(words[6]));
        }
    }

    /// The vertex named by a word such as 7, 7/1, 7//3 or 7/1/3; negative numbers count from the
    /// last.
    std::uint32_t vertex(Word word) const
    {
        const Word digits = word.substr(0, word.find('/'));
        const char* end = digits.data() + digits.size();
        long long number = 0;
        const auto read = std::from_chars(digits.data(), end, number);
        if (read.ec != std::errc() || read.ptr != end)
            file_.fail(excerpt(std::string(word)) + " names no vertex");
        const long long count = (long long)mesh_.vertices.size();
        const long long index = number < 0 ? count + number : number - 1;
        if (index < 0 || index >= count)
            file_.fail("vertex " + std::to_string(number) + " is not among the " +
                       std::to_string(count) + " that come before");
        return std::uint32_t(index);
    }

    Colour colour_at(std::uint32_t vertex) const
    {
        if (vertex < colours_.size() && colours_[vertex])
            return *colours_[vertex];
        return material_ ? *material_ : how_.plain;
    }

    MeshLine line(std::uint32_t a, std::uint32_t b) const
    {
        return {{a, b}, {colour_at(a), colour_at(b)}};
    }

    void add_lines(const std::vector<Word>& words)
    {
        at_least(words, 2, "l needs two vertices or more");
        for (std::size_t k = 2; k < words.size(); ++k)
            mesh_.lines.push_back(line(vertex(words[k - 1]), vertex(words[k])));
    }

    void add_face(const std::vector<Word>& words)
    {
        at_least(words, 3, "f needs three vertices or more");
        corners_.clear();
        Colour sum{0, 0, 0, 1};
        for (std::size_t k = 1; k < words.size(); ++k) {
            corners_.push_back(vertex(words[k]));
            const Colour c = colour_at(corners_.back());
            sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b, 1};
        }
        const std::size_t n = corners_.size();
        const float part = 1 / float(n);
        const Colour mean{part * sum.r, part * sum.g, part * sum.b, 1};
        for (std::size_t k = 2; k < n; ++k)
            mesh_.triangles.push_back({{corners_[0], corners_[k - 1], corners_[k]}, mean});
        for (std::size_t k = 0; k < n; ++k) {
            const std::uint32_t a = corners_[k], b = corners_[(k + 1) % n];
            mesh_.face_edges.push_back(line(std::min(a, b), std::max(a, b)));
        }
    }

    /// Colours matter less than shape: a missing library is only a warning.
    void read_library(const std::vector<Word>& words)
    {
        if (how_.ignore_colours)
            return;
        at_least(words, 1, "mtllib needs the name of a file");
        // One name with spaces, or several names.
        const std::string all = name_in(words);
        if (words.size() == 2 || access(beside(all).c_str(), F_OK) == 0)
            return read_library(all);
        for (std::size_t k = 1; k < words.size(); ++k)
            read_library(std::string(words[k]));
    }

    void read_library(const std::string& name)
    {
        const std::string path = beside(name);
        if (is_special(path)) // a pipe or a device may never end
            file_.fail(excerpt(name) + " is not a regular file");
        std::optional<Statements> library;
        try {
            library.emplace(path);
        } catch (const InputError& error) {
            lacks_library_ = true;
            return how_.warn(file_.located("material library " + std::string(error.what()) +
                                           "; its materials take the default colour"));
        }
        read_materials(*library, materials_);
    }

    void use_material(const std::vector<Word>& words)
    {
        if (how_.ignore_colours)
            return;
        at_least(words, 1, "usemtl needs a name");
        const std::string name = name_in(words);
        const auto match = materials_.find(name);
        material_ = match == materials_.end() ? std::nullopt : std::optional(match->second);
        // The warning about a missing library covers its materials.
        if (!material_ && !lacks_library_ && unknown_.insert(name).second)
            how_.warn(file_.located("material " + excerpt(name) +
                                    " is in no file that mtllib names; what has it takes the "
                                    "default colour"));
    }

    /// Resolves a path that the file gives relative to its own folder.
    std::string beside(const std::string& name) const
    {
        const std::size_t folder = path_.find_last_of('/');
        return name[0] == '/' || folder == std::string::npos ? name
                                                             : path_.substr(0, folder + 1) + name;
    }

    std::string path_;
    MeshReading how_;
    Statements file_;
    Mesh mesh_;
    std::vector<std::optional<Colour>> colours_; ///< by vertex; those after the end have none
    Materials materials_;
    std::optional<Colour> material_;
    bool lacks_library_ = false;
    std::set<std::string> unknown_; ///< materials that a warning was given for
    std::vector<std::uint32_t> corners_;
};

} // namespace

Mesh read_obj(const std::string& path, const MeshReading& how)
{
    return ObjReader(path, how).read();
}

} // namespace integral
