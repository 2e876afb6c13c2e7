#include "Namespace.h"

#include "RowWriter.h"
#include "StandardError.h"

namespace badlog {
namespace {

/** Whether a byte is usual in a name; all bytes beyond ASCII are. */
bool IsUsual(char byte) {
    const auto letter = static_cast<char>(byte | 0x20);
    return (static_cast<unsigned char>(byte) & 0x80) != 0 || (letter >= 'a' && letter <= 'z') || (byte >= '0' && byte <= '9') ||
           byte == ' ' || byte == '_' || byte == '/';
}

}  // namespace

bool Namespace::Add(std::shared_ptr<Topic> topic) {
    if (!Claim(topic->Name())) return false;
    m_topics.push_back(std::move(topic));
    return true;
}

bool Namespace::AddValue(std::string_view name, std::string_view text) {
    if (!Claim(name)) return false;
    m_values.push_back({std::string{name}, std::string{text}});
    return true;
}

SubscribedTopic* Namespace::Subscriber(std::string_view name) const {
    for (const auto& topic : m_topics) {
        if (topic->Name() == name) return dynamic_cast<SubscribedTopic*>(topic.get());
    }
    return nullptr;
}

std::string Namespace::HeaderLines() const {
    std::vector<const TopicDescription*> descriptions;
    RowWriter titles;
    for (const auto& topic : m_topics) {
        descriptions.push_back(&topic->Description());
        titles.Text(TitleOf(topic->Name()));
    }
    titles.EndRow();
    return HeaderText(descriptions, m_values) + "\n" + std::string{titles.Bytes()};
}

bool Namespace::Claim(std::string_view name) {
    if (!m_names.emplace(name).second) {
        PrintOnStandardError(
            "There is already a topic or value \"" + std::string{name} + "\" in this log. Give one of the two another name.");
        return false;
    }
    for (const char byte : name) {
        if (IsUsual(byte)) continue;
        PrintOnStandardError(
            "The name \"" + std::string{name} + "\" has the character '" + byte + "'; letters, digits, spaces, _ and / are safer.");
        break;
    }
    return true;
}

}  // namespace badlog
