#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace badlog {

/** A topic as the first line of a bag describes it. */
struct TopicDescription {
    std::string name;
    std::string unit;
    std::vector<std::string> attributes;

    bool Has(std::string_view attribute) const;
};

/** A name and a text that are known when a log begins. */
struct NamedValue {
    std::string name;
    std::string text;
};

/** Returns the title of a topic: its name, with replacements for characters that a line of titles cannot hold. */
std::string TitleOf(std::string_view name);

/** Returns the first line of a bag, without its newline, in the same bytes as badlog for Java. */
std::string HeaderText(const std::vector<const TopicDescription*>& topics, const std::vector<NamedValue>& values);

}  // namespace badlog
