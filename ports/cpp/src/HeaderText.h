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

/** The title of a topic: its name, with what a line of titles cannot hold replaced. */
std::string TitleOf(std::string_view name);

/** The first line of a bag, without its newline, in the bytes of badlog for Java. */
std::string HeaderText(const std::vector<const TopicDescription*>& topics, const std::vector<NamedValue>& values);

}  // namespace badlog
