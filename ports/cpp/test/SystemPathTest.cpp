#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "LogFiles.h"
#include "SystemPath.h"

using badlog::BadLog;

namespace {

/** The names in a folder, in UTF-8. */
std::set<std::string> NamesIn(const std::string& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator{badlog::SystemPath(folder)}) names.insert(badlog::TextOf(entry.path().filename()));
    return names;
}

void LogOneRow(const std::string& path) {
    const auto log = BadLog::Init(path);
    BadLog::CreateTopic("A", "ul", [] { return 1; });
    log.FinishInitialization();
    Row(log);
    log.Close();
}

}  // namespace

TEST_CASE("paths are UTF-8 on every system: of the log, of its folders, and of a free path") {
    const Folder folder;
    const std::string name = "Prüfung Ω 机器人 🤖";
    const auto path = folder / (name + "/" + name + ".bag");
    LogOneRow(BadLog::FreePath(path));
    const auto free = BadLog::FreePath(path);
    CHECK(free == folder / (name + "/" + name + "_2.bag"));
    LogOneRow(free);
    CHECK(NamesIn(folder / ".") == std::set<std::string>{name});
    CHECK(NamesIn(folder / name) == std::set<std::string>{name + ".bag", name + "_2.bag"});
    CHECK(RowsIn(path) == std::vector<std::string>{"1.0000"});
}

TEST_CASE("a file without an ending, a hidden file, and a path without a folder have free paths, too") {
    const auto before = std::filesystem::current_path();
    const Folder folder;
    std::filesystem::current_path(badlog::SystemPath(folder / "."));
    for (const std::string name : {"log", ".log", "a.b.bag"}) LogOneRow(name);
    CHECK(BadLog::FreePath("new.bag") == "new.bag");
    CHECK(BadLog::FreePath("log") == "log_2");
    CHECK(BadLog::FreePath(".log") == ".log_2");
    CHECK(BadLog::FreePath("a.b.bag") == "a.b_2.bag");
    std::filesystem::current_path(before);
}

#if defined(_WIN32)
TEST_CASE("an invalid byte of a path becomes U+FFFD on Windows, whose names are UTF-16") {
    const Folder folder;
    LogOneRow(folder / "a\xFF.bag");
    CHECK(NamesIn(folder / ".") == std::set<std::string>{"a\uFFFD.bag"});
}
#endif
