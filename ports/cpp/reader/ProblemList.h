#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "badlog/Recording.h"

namespace badlog::reader {

/** Collects problems in bounded memory: of each kind and topic the first ten are kept, the others counted. */
class ProblemList {
public:
    using Line = std::optional<int64_t>;
    using TopicName = std::optional<std::string>;

    void Add(std::string_view kind, std::string message, Line line = {}, TopicName topic = {}, int64_t count = 1);

    /** The problems in the order in which they were added, then one for each kind that occurred more often. */
    std::vector<Problem> ToList() const;

private:
    using Key = std::pair<std::string_view, TopicName>;

    std::vector<Problem> m_problems;
    std::map<Key, int> m_seen;
    std::map<Key, Problem> m_overflow;
};

}  // namespace badlog::reader
