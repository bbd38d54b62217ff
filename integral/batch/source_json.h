// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads JSON documents that people write: each message about a value names its line and field.
#ifndef INTEGRAL_BATCH_SOURCE_JSON_H
#define INTEGRAL_BATCH_SOURCE_JSON_H

#include "integral/base/json.h"

#include <memory>
#include <string>
#include <vector>

namespace integral {

/// A value of a JSON document with its line and field. All values of a document share it and keep
/// it alive.
class SourceJson {
public:
    /// Throws InputError, "PATH:LINE: ...", for malformed JSON or a repeated field.
    static SourceJson parse(const std::string& path, const std::string& text);

    bool has(const char* field) const;
    /// A field of an object. Throws InputError if it is missing.
    SourceJson field(const char* name) const;
    /// Throws InputError, listing `names`, for the first field with another name; also if this is
    /// no object.
    void allow(const std::vector<const char*>& names) const;
    /// The values of a list. Throws InputError if this is none.
    std::vector<SourceJson> list() const;
    /// The fields of an object, by name.
    std::vector<std::pair<std::string, SourceJson>> fields() const;

    /// Each throws InputError if the value is of another kind.
    std::string text() const;
    std::vector<std::string> texts() const;
    int whole(int least, int most) const;
    const Json& json() const { return *value_; }

    int line() const;
    std::string place() const; ///< "PATH:LINE: FIELD", or "PATH:LINE" for the document
    /// Throws InputError: "PATH:LINE: FIELD: `what`".
    [[noreturn]] void throw_input(const std::string& what) const;

private:
    struct Document {
        Document(const std::string& name, const std::string& text) : path(name), json(text) {}
        std::string path;
        LinedJson json;
    };
    SourceJson(std::shared_ptr<const Document> document, const Json* value, std::string name);
    SourceJson at(const Json& value, const std::string& name) const;

    std::shared_ptr<const Document> document_;
    const Json* value_;
    std::string name_; ///< e.g. scenes[0].file
};

} // namespace integral

#endif
