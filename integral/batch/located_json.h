// SPDX-License-Identifier: AGPL-3.0-or-later
// JSON documents that people write: each message about a value names its line and field.
#ifndef INTEGRAL_BATCH_LOCATED_JSON_H
#define INTEGRAL_BATCH_LOCATED_JSON_H

#include "integral/base/json.h"

#include <memory>
#include <string>
#include <vector>

namespace integral {

/// A value of a JSON document that knows its line and its field. All values of a document share it
/// and keep it alive.
class Located {
public:
    /// Throws InputError, "PATH:LINE: ...", for JSON that is malformed or has a field twice.
    static Located parse(const std::string& path, const std::string& text);

    bool has(const char* field) const;
    /// A field of an object. Throws InputError where it is missing.
    Located field(const char* name) const;
    /// Throws InputError for the first field that is not among `names`, with those that are; and
    /// where this is no object.
    void allow(const std::vector<const char*>& names) const;
    /// The values of a list. Throws InputError where this is none.
    std::vector<Located> list() const;
    /// The fields of an object, by name.
    std::vector<std::pair<std::string, Located>> fields() const;

    /// Each throws InputError where the value is of another kind.
    std::string text() const;
    std::vector<std::string> texts() const;
    int whole(int least, int most) const;
    const Json& json() const { return *value_; }

    int line() const;
    std::string place() const; ///< "PATH:LINE: FIELD", or "PATH:LINE" of the document
    /// Throws InputError: "PATH:LINE: FIELD: `what`".
    [[noreturn]] void refuse(const std::string& what) const;

private:
    struct Document {
        Document(const std::string& name, const std::string& text) : path(name), json(text) {}
        std::string path;
        LinedJson json;
    };
    Located(std::shared_ptr<const Document> document, const Json* value, std::string name);
    Located at(const Json& value, const std::string& name) const;

    std::shared_ptr<const Document> document_;
    const Json* value_;
    std::string name_; ///< scenes[0].file
};

} // namespace integral

#endif
