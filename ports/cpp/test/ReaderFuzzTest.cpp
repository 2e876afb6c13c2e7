#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "LogFiles.h"
#include "SystemPath.h"
#include "badlog/Recording.h"

namespace {

constexpr int MUTANTS = 20'000;

/** Returns the files of the corpus, in the same order on every machine. */
std::vector<std::string> Corpus() {
    std::set<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator{badlog::SystemPath(BADLOG_ROOT "/core/conformance")}) {
        if (entry.path().extension() == ".bag") paths.insert(badlog::TextOf(entry.path()));
    }
    std::vector<std::string> files;
    for (const auto& path : paths) files.push_back(Read(path));
    return files;
}

/** Returns a file with a few pieces changed, cut, doubled, or taken from another file. */
std::string Mutant(const std::vector<std::string>& corpus, std::mt19937& random) {
    static const std::vector<std::string> PIECES = {
        ",", "\"", "\"\"", "\n", "\r", "\r\n", std::string(3, '\0'), "{", "}", "[", "\\u00", "\\ud83d", "NaN", "-inf", "1e999", "1,5",
        "true", " ", "\t", ";", "\xEF\xBB\xBF", "\xFF", "é", "null", "\"name\":", "-0.0", "9999999999999999999999"};
    auto file = corpus[random() % corpus.size()];
    for (auto left = random() % 4 + 1; left > 0; left--) {
        const auto at = random() % (file.size() + 1);
        const auto size = random() % (random() % 3 == 0 ? 60 : 4);
        switch (random() % 5) {
            case 0:
                file.insert(at, PIECES[random() % PIECES.size()]);
                break;
            case 1:
                file.erase(at, size);
                break;
            case 2:
                file.insert(at, file.substr(file.empty() ? 0 : random() % file.size(), size));
                break;
            case 3:
                if (at < file.size()) file[at] = static_cast<char>(random());
                break;
            default:
                const auto& other = corpus[random() % corpus.size()];
                file = file.substr(0, at) + other.substr(other.empty() ? 0 : random() % other.size());
        }
    }
    return file;
}

}  // namespace

TEST_CASE("any bytes are read, and each topic has a cell for each row") {
    const auto corpus = Corpus();
    std::mt19937 random{20261122};
    for (int i = 0; i < MUTANTS; i++) {
        const auto file = Mutant(corpus, random);
        INFO(file);
        const auto recording = badlog::ReadBag(file);
        std::set<std::string> names;
        for (const auto& topic : recording.topics) {
            REQUIRE(names.insert(topic.name).second);
            REQUIRE(topic.counts.Total() == recording.rowCount);
            REQUIRE(static_cast<int64_t>(topic.samples.size()) == recording.rowCount);
            REQUIRE(static_cast<int64_t>(topic.texts.size()) == topic.counts.texts);
        }
        if (recording.topics.empty() || recording.rowCount == 0) REQUIRE_FALSE(recording.problems.empty());
    }
}
