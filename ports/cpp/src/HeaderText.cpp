#include "HeaderText.h"

#include <algorithm>

#include "Utf8.h"

namespace badlog {
namespace {

constexpr std::string_view ESCAPED = "\"\\/\b\f\n\r\t";
constexpr std::string_view LETTERS = "\"\\/bfnrt";

void AppendHexadecimal(std::string& out, uint32_t code) {
    out += "\\u";
    for (int shift = 12; shift >= 0; shift -= 4) out += "0123456789ABCDEF"[code >> shift & 0xF];
}

void AppendQuoted(std::string& out, std::string_view text) {
    out += '"';
    for (size_t i = 0; i < text.size();) {
        const auto character = CharacterAt(text, i);
        const auto code = character.code;
        const auto letter = character.length == 1 ? ESCAPED.find(text[i]) : std::string_view::npos;
        if (!character.isValid) {
            out += REPLACEMENT;
        } else if (letter != std::string_view::npos) {
            out += '\\';
            out += LETTERS[letter];
        } else if (code < ' ' || (code >= 0x7F && code < 0xA0) || (code >= 0x2000 && code < 0x2100)) {
            AppendHexadecimal(out, code);
        } else {
            out += text.substr(i, character.length);
        }
        i += character.length;
    }
    out += '"';
}

template <typename Items, typename Append>
void AppendArray(std::string& out, const Items& items, Append append) {
    out += '[';
    bool isFirst = true;
    for (const auto& item : items) {
        if (!isFirst) out += ',';
        isFirst = false;
        append(item);
    }
    out += ']';
}

void AppendTopic(std::string& out, const TopicDescription& topic) {
    out += "{\"unit\":";
    AppendQuoted(out, topic.unit);
    out += ",\"name\":";
    AppendQuoted(out, TitleOf(topic.name));
    out += ",\"attrs\":";
    AppendArray(out, topic.attributes, [&](const std::string& attribute) { AppendQuoted(out, attribute); });
    out += '}';
}

void AppendValue(std::string& out, const NamedValue& value) {
    out += "{\"name\":";
    AppendQuoted(out, value.name);
    out += ",\"value\":";
    AppendQuoted(out, value.text);
    out += '}';
}

}  // namespace

bool TopicDescription::Has(std::string_view attribute) const {
    return std::find(attributes.begin(), attributes.end(), attribute) != attributes.end();
}

std::string TitleOf(std::string_view name) {
    std::string title;
    for (size_t i = 0; i < name.size();) {
        const auto character = CharacterAt(name, i);
        if (character.code == '\n' || character.code == '\r') {
            title += ' ';
        } else if (character.isValid && character.code != 0) {
            title += name.substr(i, character.length);
        } else {
            title += REPLACEMENT;
        }
        i += character.length;
    }
    return title;
}

std::string HeaderText(const std::vector<const TopicDescription*>& topics, const std::vector<NamedValue>& values) {
    std::string out = "{\"topics\":";
    AppendArray(out, topics, [&](const TopicDescription* topic) { AppendTopic(out, *topic); });
    out += ",\"values\":";
    AppendArray(out, values, [&](const NamedValue& value) { AppendValue(out, value); });
    return out + '}';
}

}  // namespace badlog
