#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace badlog::reader {

/** A value of a JSON text: its JSON as it is written there, and what it means. */
struct JsonValue {
    std::string json;
    std::optional<std::string> text;
    std::optional<std::vector<JsonValue>> items;
    std::optional<std::vector<std::pair<std::string, JsonValue>>> members;

    /** The last of an object's members of that key, or null. */
    const JsonValue* Member(std::string_view key) const;
};

/**
 * The JSON object that a text is, or nothing if it is not exactly one. Follows RFC 8259 with one exception: strings may
 * contain unescaped control characters.
 */
std::optional<JsonValue> ReadJsonObject(std::string_view text);

}  // namespace badlog::reader
