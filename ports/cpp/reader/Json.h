#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace badlog::reader {

/** A value of a JSON text: its JSON exactly as in the text, and its content. */
struct JsonValue {
    std::string json;
    std::optional<std::string> text;
    std::optional<std::vector<JsonValue>> items;
    std::optional<std::vector<std::pair<std::string, JsonValue>>> members;

    /** Returns the last of an object's members with that key, or null. */
    const JsonValue* Member(std::string_view key) const;
};

/**
 * Returns the JSON object in a text, or nothing if the text is not exactly one. Follows RFC 8259 with one exception:
 * strings may contain unescaped control characters.
 */
std::optional<JsonValue> ReadJsonObject(std::string_view text);

}  // namespace badlog::reader
