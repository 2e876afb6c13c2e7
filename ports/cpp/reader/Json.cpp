#include "Json.h"

#include <cstdint>

#include "Cell.h"
#include "Text.h"
#include "Utf8.h"

namespace badlog::reader {
namespace {

constexpr int MAX_DEPTH = 100;  // far deeper than any header

bool IsDigit(char byte) {
    return byte >= '0' && byte <= '9';
}

/**
 * Returns whether a word is a JSON number. It has no sign but a minus, no leading zero, and digits on both sides of the point.
 */
bool IsNumber(std::string_view word) {
    if (!word.empty() && word.front() == '-') word.remove_prefix(1);
    if (word.empty() || !IsDigit(word[0]) || (word.size() > 1 && word[0] == '0' && IsDigit(word[1]))) return false;
    const auto point = word.find('.');
    if (point != std::string_view::npos && (point + 1 == word.size() || !IsDigit(word[point + 1]))) return false;
    return ReadDecimal(word, '.').has_value();
}

/** Reads JSON; each function returns false if the text is malformed. */
class JsonReader {
public:
    explicit JsonReader(std::string_view text) : m_text{text} {}

    bool Document(JsonValue& value) {
        if (!Read(value, 0)) return false;
        SkipBlanks();
        return m_at == m_text.size();
    }

private:
    bool Read(JsonValue& value, int depth) {
        if (depth > MAX_DEPTH) return false;
        SkipBlanks();
        const auto start = m_at;
        bool isRead = false;
        if (Peek() == '{') {
            isRead = Members(value.members.emplace(), depth);
        } else if (Peek() == '[') {
            isRead = Items(value.items.emplace(), depth);
        } else if (Peek() == '"') {
            isRead = String(value.text.emplace());
        } else {
            isRead = Word();
        }
        value.json = m_text.substr(start, m_at - start);
        return isRead;
    }

    bool Members(std::vector<std::pair<std::string, JsonValue>>& members, int depth) {
        if (IsEmpty('}')) return true;
        do {
            SkipBlanks();
            auto& member = members.emplace_back();
            if (Peek() != '"' || !String(member.first)) return false;
            SkipBlanks();
            if (!Skip(':') || !Read(member.second, depth + 1)) return false;
            SkipBlanks();
        } while (Skip(','));
        return Skip('}');
    }

    bool Items(std::vector<JsonValue>& items, int depth) {
        if (IsEmpty(']')) return true;
        do {
            if (!Read(items.emplace_back(), depth + 1)) return false;
            SkipBlanks();
        } while (Skip(','));
        return Skip(']');
    }

    bool IsEmpty(char end) {
        m_at++;
        SkipBlanks();
        return Skip(end);
    }

    bool String(std::string& string) {
        m_at++;
        while (m_at < m_text.size()) {
            const char byte = m_text[m_at++];
            if (byte == '"') return true;
            if (byte != '\\') {
                string += byte;
            } else if (!Escaped(string)) {
                return false;
            }
        }
        return false;
    }

    bool Escaped(std::string& string) {
        static constexpr std::string_view LETTERS = "\"\\/bfnrt";
        static constexpr std::string_view MEANINGS = "\"\\/\b\f\n\r\t";
        const char letter = Peek();
        m_at++;
        const auto place = LETTERS.find(letter);
        if (place != std::string_view::npos) {
            string += MEANINGS[place];
            return true;
        }
        uint32_t code = 0;
        if (letter != 'u' || !Unit(code)) return false;
        if (code >= 0xD800 && code < 0xDC00 && m_text.substr(m_at, 2) == "\\u") {
            const auto before = m_at;
            m_at += 2;
            uint32_t low = 0;
            if (!Unit(low)) return false;
            if (low >= 0xDC00 && low < 0xE000) {
                code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
            } else {
                m_at = before;
            }
        }
        AppendCharacter(string, code);
        return true;
    }

    bool Unit(uint32_t& code) {
        if (m_at + 4 > m_text.size()) return false;
        for (int i = 0; i < 4; i++) {
            static constexpr std::string_view DIGITS = "0123456789abcdef";
            const char byte = m_text[m_at++];
            const auto digit = DIGITS.find(byte >= 'A' && byte <= 'F' ? static_cast<char>(byte | 0x20) : byte);
            if (digit == std::string_view::npos) return false;
            code = code * 16 + static_cast<uint32_t>(digit);
        }
        return true;
    }

    bool Word() {
        const auto start = m_at;
        while (m_at < m_text.size()) {
            const auto character = CharacterAt(m_text, m_at);
            if (!IsLetterOrDigit(character.code) && std::string_view{"+-."}.find(m_text[m_at]) == std::string_view::npos) break;
            m_at += character.length;
        }
        const auto word = m_text.substr(start, m_at - start);
        return word == "true" || word == "false" || word == "null" || IsNumber(word);
    }

    void SkipBlanks() {
        while (m_at < m_text.size() && std::string_view{" \t\n\r"}.find(m_text[m_at]) != std::string_view::npos) m_at++;
    }

    /** Returns the next character; at the end NUL, which is malformed anywhere outside strings. */
    char Peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }

    bool Skip(char byte) {
        if (m_at >= m_text.size() || m_text[m_at] != byte) return false;
        m_at++;
        return true;
    }

    std::string_view m_text;
    size_t m_at = 0;
};

}  // namespace

const JsonValue* JsonValue::Member(std::string_view key) const {
    if (!members) return nullptr;
    for (auto member = members->rbegin(); member != members->rend(); member++) {
        if (member->first == key) return &member->second;
    }
    return nullptr;
}

std::optional<JsonValue> ReadJsonObject(std::string_view text) {
    JsonValue value;
    if (!JsonReader{text}.Document(value) || !value.members) return std::nullopt;
    return value;
}

}  // namespace badlog::reader
