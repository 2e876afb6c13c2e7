#include "ProblemList.h"

namespace badlog::reader {
namespace {

constexpr int MAX_LISTED = 10;

}  // namespace

void ProblemList::Add(std::string_view kind, std::string message, Line line, TopicName topic, int64_t count) {
    const Key key{kind, topic};
    if (++m_seen[key] <= MAX_LISTED) {
        m_problems.push_back({kind, std::move(message), line, std::move(topic), count});
        return;
    }
    const auto added = m_overflow.try_emplace(key, Problem{kind, std::move(message), line, std::move(topic), 0}).first;
    added->second.count += count;
}

std::vector<Problem> ProblemList::ToList() const {
    auto all = m_problems;
    for (const auto& [key, problem] : m_overflow) all.push_back(problem);
    return all;
}

}  // namespace badlog::reader
