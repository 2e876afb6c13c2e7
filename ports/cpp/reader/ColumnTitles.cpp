#include "ColumnTitles.h"

#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "Text.h"
#include "Utf8.h"

namespace badlog::reader {
namespace {

constexpr size_t NAMES_PER_MATCH = 4;  // if one title in this many is in line 1's order, line 1's order counts

std::string Joined(const Names& names) {
    std::string line;
    for (const auto& name : names) line += (&name == names.data() ? "" : ",") + name;
    return line;
}

/** Removes the first of that name from a list. Returns false if there is none. */
bool Remove(Names& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return false;
    names.erase(found);
    return true;
}

bool EndsWith(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Pairs names with titles if some of them differ. */
ColumnTitles Paired(const Names& names, const Names& titles) {
    size_t same = 0;
    Names waiting;
    for (size_t i = 0; i < titles.size(); i++) {
        if (titles[i] == names[i]) {
            same++;
        } else {
            waiting.push_back(names[i]);
        }
    }
    // If line 2 has its own order, each title is at its place there.
    const bool isReordered = same * 2 < names.size();
    auto result = ColumnTitles::Certain(titles);
    for (size_t i = 0; i < titles.size(); i++) {
        if (titles[i] != names[i]) result.isDoubtful[i] = !(isReordered && Remove(waiting, titles[i]));
    }
    for (size_t i = 0; i < titles.size(); i++) {
        if (!result.isDoubtful[i]) continue;
        if (!isReordered && Remove(waiting, names[i])) {
            result.titles[i] = names[i];
        } else {
            result.titles[i] = waiting.front();
            waiting.erase(waiting.begin());
        }
    }
    return result;
}

/** Uses the names because there are too few or too many titles. */
ColumnTitles OfNames(const Names& names, const Names& titles) {
    std::map<std::string, std::deque<size_t>> places;
    for (size_t i = 0; i < names.size(); i++) places[names[i]].push_back(i);
    std::vector<size_t> found;
    for (const auto& title : titles) {
        auto& left = places[title];
        if (left.empty()) continue;
        found.push_back(left.front());
        left.pop_front();
    }
    const bool isAtEnd = titles.front() == names.front() || titles.back() == names.back();
    const bool ascends = std::is_sorted(found.begin(), found.end());
    // A hole may leave only the beginning or the end of a name.
    const auto line = Joined(names);
    const auto rest = Joined(titles);
    if ((isAtEnd && found.size() * NAMES_PER_MATCH >= names.size() && ascends) || line.compare(0, rest.size(), rest) == 0 || EndsWith(line, rest)) {
        return ColumnTitles::Certain(names);
    }
    // Line 2 had its own order, which is known from both ends of the line inwards.
    auto left = names;
    size_t first = 0;
    while (first < titles.size() && Remove(left, titles[first])) first++;
    auto last = titles.size();
    while (last > first && Remove(left, titles[last - 1])) last--;
    Names all{titles.begin(), titles.begin() + static_cast<std::ptrdiff_t>(first)};
    all.insert(all.end(), left.begin(), left.end());
    all.insert(all.end(), titles.begin() + static_cast<std::ptrdiff_t>(last), titles.end());
    return ColumnTitles::Doubtful(all);
}

Names UniqueNames(const Names& titles, int64_t line, ProblemList& problems) {
    Names names;
    std::set<std::string> given;
    std::map<std::string, int> copies;
    for (size_t i = 0; i < titles.size(); i++) {
        const auto wanted = titles[i].empty() ? "Column " + std::to_string(i + 1) : titles[i];
        auto& copy = copies.try_emplace(wanted, 2).first->second;
        auto name = wanted;
        while (!given.insert(name).second) name = wanted + " (" + std::to_string(copy++) + ")";
        if (name != wanted) {
            problems.Add(
                "DUPLICATE_TOPIC", "There are several topics named “" + wanted + "”; this one is shown as “" + name + "”.", line, name);
        }
        names.push_back(name);
    }
    return names;
}

/** Returns the first character of a name that is neither a letter, nor a digit, nor one of ` _/`. */
std::optional<std::string> OddCharacter(const std::string& name) {
    for (size_t i = 0; i < name.size();) {
        const auto character = CharacterAt(name, i);
        const bool isUsual = character.code == ' ' || character.code == '_' || character.code == '/' || IsLetterOrDigit(character.code);
        if (!isUsual) return name.substr(i, character.length);
        i += character.length;
    }
    return std::nullopt;
}

}  // namespace

bool HaveSameNames(Names one, Names other) {
    std::sort(one.begin(), one.end());
    std::sort(other.begin(), other.end());
    return one == other;
}

ColumnTitles ColumnTitles::Of(const Names& names, const Names& titles, size_t width) {
    if (width == 0 || (titles.size() == width && names.size() != width) || HaveSameNames(names, titles)) return Certain(titles);
    if (names.size() == width) return titles.size() == width ? Paired(names, titles) : OfNames(names, titles);
    auto padded = titles;
    padded.resize(width);
    return Doubtful(padded);
}

HeaderColumns HeaderColumns::Match(const BagHeader* header, const Names& titles, int64_t line, ProblemList& problems) {
    const std::vector<BagTopic> none;
    const auto& described = header != nullptr ? header->topics : none;
    std::map<std::string, std::deque<size_t>> waiting;
    for (size_t i = 0; i < described.size(); i++) waiting[described[i].name].push_back(i);
    HeaderColumns columns;
    std::vector<size_t> places;
    for (size_t i = 0; i < titles.size(); i++) {
        auto& left = waiting[titles[i]];
        places.push_back(left.empty() ? described.size() + i : left.front());
        columns.topics.push_back(left.empty() ? nullptr : &described[left.front()]);
        if (!left.empty()) left.pop_front();
    }
    std::vector<size_t> missing;
    for (const auto& [name, left] : waiting) missing.insert(missing.end(), left.begin(), left.end());
    std::sort(missing.begin(), missing.end());
    for (const auto i : missing) {
        const auto& name = described[i].name;
        problems.Add(
            "TOPIC_WITHOUT_COLUMN", "The header describes “" + name + "”, but line " + std::to_string(line) + " has no such column.", line, name);
    }
    columns.names = UniqueNames(titles, line, problems);
    for (size_t i = 0; i < titles.size() && header != nullptr; i++) {
        const auto& name = columns.names[i];
        if (columns.topics[i] == nullptr) {
            problems.Add(
                "COLUMN_WITHOUT_TOPIC", "Column “" + name + "” is not described in the header; it is shown without a unit.", line, name);
        }
        if (const auto odd = OddCharacter(titles[i])) {
            problems.Add(
                "UNUSUAL_NAME",
                "The name “" + name + "” has a “" + *odd + "”; names are safest with letters, digits, space, _ and / only.", line, name);
        }
    }
    columns.order.resize(titles.size());
    std::iota(columns.order.begin(), columns.order.end(), size_t{0});
    std::sort(columns.order.begin(), columns.order.end(), [&](size_t one, size_t other) { return places[one] < places[other]; });
    return columns;
}

}  // namespace badlog::reader
