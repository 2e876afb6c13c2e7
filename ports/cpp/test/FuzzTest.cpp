#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "LogFiles.h"
#include "Utf8.h"

using badlog::BadLog;

namespace {

/** Returns random bytes, with those that have a meaning in a bag more often. */
std::string AnyText(std::mt19937& random) {
    static const std::vector<std::string> PIECES = {
        ",", "\"", "\n", "\r", " ", "\t", std::string(1, '\0'), "\\", "{", "é", "🤖", "\u00A0", "\u2028", "\xED\xA0\xBE", "\xF0\x9F", "1.5"};
    std::string text;
    for (auto left = random() % 12; left > 0; left--) {
        const auto choice = random() % (PIECES.size() * 2);
        text += choice < PIECES.size() ? PIECES[choice] : std::string(1, static_cast<char>(random()));
    }
    return text;
}

/** Returns the rows of a CSV text by RFC 4180; empty if it is not one. */
std::vector<std::vector<std::string>> Cells(const std::string& csv) {
    std::vector<std::vector<std::string>> rows{{""}};
    bool isQuoted = false;
    for (size_t i = 0; i < csv.size(); i++) {
        auto& cell = rows.back().back();
        if (isQuoted) {
            if (csv[i] != '"') {
                cell += csv[i];
            } else if (i + 1 < csv.size() && csv[i + 1] == '"') {
                cell += csv[++i];
            } else {
                isQuoted = false;
            }
        } else if (csv[i] == '"') {
            if (!cell.empty()) return {};
            isQuoted = true;
        } else if (csv[i] == ',') {
            rows.back().emplace_back();
        } else if (csv[i] == '\n') {
            rows.push_back({""});
        } else {
            cell += csv[i];
        }
    }
    rows.pop_back();
    return rows;
}

bool IsText(const std::string& bytes) {
    for (size_t i = 0; i < bytes.size();) {
        const auto character = badlog::CharacterAt(bytes, i);
        if (!character.isValid || character.code == 0) return false;
        i += character.length;
    }
    return true;
}

}  // namespace

TEST_CASE("any names, values, texts and events give well-formed lines and cells in UTF-8") {
    std::mt19937 random{20261122};
    for (int round = 0; round < 500; round++) {
        std::string bag;
        constexpr size_t ROWS = 3;
        std::vector<std::string> names;
        std::vector<std::string> texts;
        StandardErrorOf([&] {
            bag = Logged(
                [&] {
                    BadLog::CreateValue("value" + AnyText(random), AnyText(random));
                    for (int i = 0; i < 2; i++) {
                        names.push_back("topic" + std::to_string(i) + AnyText(random));
                        BadLog::CreateTopicStr(names.back(), AnyText(random), [&] {
                            texts.push_back(AnyText(random));
                            return texts.back();
                        }, {AnyText(random)});
                    }
                },
                [&](BadLog& log) {
                    const auto events = BadLog::CreateEvents("too late");
                    for (size_t i = 0; i < ROWS; i++) {
                        events.Event(AnyText(random));
                        BadLog::Publish(AnyText(random), AnyText(random));
                        Row(log);
                    }
                });
        });
        INFO(bag);
        REQUIRE(IsText(bag));
        const auto header = bag.substr(0, bag.find('\n'));
        REQUIRE(header.find("]}") != std::string::npos);
        for (const char byte : header) REQUIRE(static_cast<unsigned char>(byte) >= ' ');
        const auto rows = Cells(bag.substr(header.size() + 1));
        REQUIRE(rows.size() == ROWS + 1);
        for (const auto& row : rows) REQUIRE(row.size() == 2);
        for (size_t i = 0; i < texts.size(); i++) {
            if (IsText(texts[i])) REQUIRE(rows[1 + i / 2][i % 2] == texts[i]);
        }
    }
}
