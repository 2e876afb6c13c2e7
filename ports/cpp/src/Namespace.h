#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "HeaderText.h"
#include "Topics.h"

namespace badlog {

/** The topics and values of a log during setup, each with a unique name. Guarded by the log's lock. */
class Namespace {
public:
    /** Adds a topic. Returns false if its name is taken. */
    bool Add(std::shared_ptr<Topic> topic);
    /** Adds a value. Returns false if the name is taken. */
    bool AddValue(std::string_view name, std::string_view text);

    const std::vector<std::shared_ptr<Topic>>& Topics() const { return m_topics; }
    /** Returns the subscriber topic of a name, or null. */
    SubscribedTopic* Subscriber(std::string_view name) const;

    /** Returns lines 1 and 2 of the file. */
    std::string HeaderLines() const;

private:
    bool Claim(std::string_view name);

    std::set<std::string, std::less<>> m_names;
    std::vector<NamedValue> m_values;
    std::vector<std::shared_ptr<Topic>> m_topics;
};

}  // namespace badlog
