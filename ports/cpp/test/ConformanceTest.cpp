#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "Json.h"
#include "LogFiles.h"
#include "SystemPath.h"
#include "badlog/Recording.h"

using badlog::reader::JsonValue;

namespace {

std::vector<JsonValue> Items(const JsonValue& object, const char* key) {
    const auto* const member = object.Member(key);
    REQUIRE(member != nullptr);
    REQUIRE(member->items);
    return *member->items;
}

/** A member's text, or its JSON. */
std::string Text(const JsonValue& object, const char* key) {
    const auto* const member = object.Member(key);
    REQUIRE(member != nullptr);
    return member->text.value_or(member->json);
}

int64_t Number(const JsonValue& object, const char* key) {
    return std::stoll(Text(object, key));
}

/** A text that is equal only for equal numbers. */
std::string Exact(double number) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", number);
    return text;
}

std::string Sample(const badlog::RecordedTopic& topic, size_t row) {
    const bool isWritten = std::find(topic.writtenNans.begin(), topic.writtenNans.end(), static_cast<int64_t>(row)) != topic.writtenNans.end();
    if (std::isnan(topic.samples[row])) return isWritten ? "NaN" : "null";
    if (std::isinf(topic.samples[row])) return topic.samples[row] > 0 ? "Infinity" : "-Infinity";
    return Exact(topic.samples[row]);
}

std::string KindName(badlog::TopicKind kind) {
    static const char* const NAMES[] = {"empty", "numeric", "boolean", "state", "event"};
    return NAMES[static_cast<int>(kind)];
}

std::vector<std::string> Problems(const std::vector<badlog::Problem>& problems) {
    std::vector<std::string> all;
    for (const auto& problem : problems) {
        const auto line = problem.line ? std::to_string(*problem.line) : "null";
        all.push_back(std::string{problem.kind} + " " + line + " " + problem.topic.value_or("null"));
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<std::string> ExpectedProblems(const JsonValue& expected) {
    std::vector<std::string> all;
    for (const auto& problem : Items(expected, "problems")) {
        all.push_back(Text(problem, "kind") + " " + Text(problem, "line") + " " + Text(problem, "topic"));
    }
    std::sort(all.begin(), all.end());
    return all;
}

void CheckTopic(const badlog::RecordedTopic& topic, const JsonValue& expected, int64_t rows) {
    INFO(topic.name);
    CHECK(topic.name == Text(expected, "name"));
    CHECK(topic.unit == Text(expected, "unit"));
    std::vector<std::string> attributes;
    for (const auto& attribute : Items(expected, "attributes")) attributes.push_back(attribute.text.value_or(""));
    CHECK(topic.attributes == attributes);
    CHECK(KindName(topic.counts.Kind()) == Text(expected, "kind"));
    const auto* const counts = expected.Member("counts");
    REQUIRE(counts != nullptr);
    CHECK(topic.counts.numbers == Number(*counts, "numbers"));
    CHECK(topic.counts.notFinite == Number(*counts, "notFinite"));
    CHECK(topic.counts.truthValues == Number(*counts, "truthValues"));
    CHECK(topic.counts.texts == Number(*counts, "texts"));
    CHECK(topic.counts.empty == Number(*counts, "empty"));
    const auto samples = Items(expected, "samples");
    REQUIRE(topic.samples.size() == static_cast<size_t>(rows));
    REQUIRE(samples.size() == topic.samples.size());
    for (size_t row = 0; row < samples.size(); row++) {
        const bool isWord = samples[row].text.has_value() || samples[row].json == "null";
        CHECK(Sample(topic, row) == (isWord ? samples[row].text.value_or("null") : Exact(std::stod(samples[row].json))));
    }
    const auto texts = Items(expected, "texts");
    REQUIRE(texts.size() == topic.texts.size());
    for (size_t i = 0; i < texts.size(); i++) {
        REQUIRE(texts[i].items);
        CHECK(topic.texts[i].first == std::stoll(texts[i].items->at(0).json));
        CHECK(topic.texts[i].second == texts[i].items->at(1).text.value_or(""));
    }
}

}  // namespace

TEST_CASE("each file of the conformance corpus is read as expected") {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator{badlog::SystemPath(BADLOG_ROOT "/core/conformance")}) {
        auto path = entry.path();
        if (path.extension() != ".bag") continue;
        files++;
        INFO(badlog::TextOf(path.stem()));
        const auto recording = badlog::ReadBag(Read(badlog::TextOf(path)));
        const auto expected = badlog::reader::ReadJsonObject(Read(badlog::TextOf(path.replace_extension(".json"))));
        REQUIRE(expected);
        CHECK((recording.isBag ? "bag" : "csv") == Text(*expected, "format"));
        CHECK(recording.rowCount == Number(*expected, "rowCount"));
        const auto values = Items(*expected, "values");
        REQUIRE(values.size() == recording.values.size());
        for (size_t i = 0; i < values.size(); i++) {
            CHECK(recording.values[i].name == Text(values[i], "name"));
            CHECK(recording.values[i].text == Text(values[i], "value"));
        }
        const auto topics = Items(*expected, "topics");
        REQUIRE(topics.size() == recording.topics.size());
        for (size_t i = 0; i < topics.size(); i++) CheckTopic(recording.topics[i], topics[i], recording.rowCount);
        const auto found = Problems(recording.problems);
        const auto wanted = ExpectedProblems(*expected);
        std::string difference;
        for (const auto& problem : found) difference += "found " + problem + "\n";
        for (const auto& problem : wanted) difference += "wanted " + problem + "\n";
        INFO(difference);
        CHECK(found == wanted);
    }
    CHECK(files > 100);
}

TEST_CASE("columns separated otherwise are refused even with decimal commas") {
    for (const auto& [byte, name] : {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}}) {
        for (const char point : {'.', ','}) {
            std::string file = std::string{"Zeit"} + byte + "Spannung" + byte + "Strom\n";
            for (int row = 0; row < 10; row++) {
                const auto number = std::to_string(row);
                file += std::string{"0"} + point + "0" + number + byte + "1" + number + point + "5" + byte + number + "\n";
            }
            const auto recording = badlog::ReadBag(file);
            CHECK(recording.topics.empty());
            REQUIRE(recording.problems.size() > 0);
            CHECK(recording.problems[0].message.rfind(std::string{"The columns are separated by "} + name, 0) == 0);
        }
    }
}
