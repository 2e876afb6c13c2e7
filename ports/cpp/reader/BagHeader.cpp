#include "BagHeader.h"

#include "Json.h"

namespace badlog::reader {
namespace {

/** Returns the text of a member, or its JSON if it has another type. Returns nothing if it is missing or null. */
std::optional<std::string> TextOf(const JsonValue& object, std::string_view key) {
    const auto* const value = object.Member(key);
    if (value == nullptr) return std::nullopt;
    if (value->text) return value->text;
    return value->json == "null" ? std::nullopt : std::optional{value->json};
}

std::vector<JsonValue> ItemsOf(const JsonValue& object, std::string_view key) {
    const auto* const value = object.Member(key);
    return value != nullptr && value->items ? *value->items : std::vector<JsonValue>{};
}

}  // namespace

std::vector<std::string> BagHeader::Names() const {
    std::vector<std::string> names;
    for (const auto& topic : topics) names.push_back(topic.name);
    return names;
}

std::optional<BagHeader> ReadHeader(std::string_view line) {
    const auto object = ReadJsonObject(line);
    if (!object) return std::nullopt;
    BagHeader header;
    for (const auto& item : ItemsOf(*object, "topics")) {
        if (!item.members) continue;
        auto& topic = header.topics.emplace_back();
        topic.name = TextOf(item, "name").value_or("");
        topic.unit = TextOf(item, "unit").value_or("ul");
        for (const auto& attribute : ItemsOf(item, "attrs")) topic.attributes.push_back(attribute.text.value_or(attribute.json));
    }
    for (const auto& item : ItemsOf(*object, "values")) {
        if (item.members) header.values.push_back({TextOf(item, "name").value_or(""), TextOf(item, "value").value_or("")});
    }
    return header;
}

}  // namespace badlog::reader
