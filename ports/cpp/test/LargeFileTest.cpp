// Before the system's first header, for files above 2 GiB and times after 2038.
#undef _FILE_OFFSET_BITS
#define _FILE_OFFSET_BITS 64
#undef _TIME_BITS
#define _TIME_BITS 64

#include <doctest/doctest.h>

// Windows would fill such a file with zeros, which takes minutes and fills the disk.
#if !defined(_WIN32)

#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "LogFile.h"
#include "LogFiles.h"
#include "SystemFile.h"

using badlog::BadLog;
using badlog::LogState;

namespace {

constexpr int64_t TWO_GIB = int64_t{1} << 31;
constexpr int64_t YEAR_2050 = 2'524'608'000;

/** Returns the content of a file from a position on. */
std::string ReadFrom(const std::string& path, int64_t place) {
    std::ifstream file{path, std::ios::binary};
    file.seekg(place);
    std::string bytes(1000, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<size_t>(file.gcount()));
    return bytes;
}

/** The descriptor by which this program has a file open. */
int DescriptorOf(const std::string& path) {
    struct stat wanted {};
    REQUIRE(stat(path.c_str(), &wanted) == 0);
    for (int descriptor = 0; descriptor < 1000; descriptor++) {
        struct stat found {};
        if (fstat(descriptor, &found) == 0 && found.st_ino == wanted.st_ino && found.st_dev == wanted.st_dev) return descriptor;
    }
    return -1;
}

/** Dates a file or a folder to 2050. Returns false if the C library or the disk does not support such a time. */
bool IsDated2050(const std::string& path) {
    if constexpr (sizeof(time_t) < sizeof(int64_t)) {
        return false;
    } else {
        const timespec times[2] = {{static_cast<time_t>(YEAR_2050), 0}, {static_cast<time_t>(YEAR_2050), 0}};
        struct stat status {};
        return utimensat(AT_FDCWD, path.c_str(), times, 0) == 0 && stat(path.c_str(), &status) == 0 &&
               status.st_mtime == static_cast<time_t>(YEAR_2050);
    }
}

}  // namespace

TEST_CASE("a file is cut and continued above 2 GiB") {
    const Folder folder;
    const auto path = folder / "large";
    const int file = badlog::OpenNew(path);
    REQUIRE(file >= 0);
    // Holes take no room on the disk.
    REQUIRE(badlog::CutTo(file, TWO_GIB + 7));
    CHECK(badlog::WriteSome(file, "torn", 4) == 4);
    REQUIRE(badlog::CutTo(file, TWO_GIB + 7));
    CHECK(badlog::WriteSome(file, "whole", 5) == 5);
    CHECK(badlog::SyncToDisk(file));
    CHECK(badlog::Exists(path));
    CHECK(badlog::CloseDescriptor(file));
    CHECK(ReadFrom(path, TWO_GIB + 7) == "whole");
}

TEST_CASE("a log continues above 2 GiB, does not count as deleted, and is not replaced by the next one") {
    const Folder folder;
    const auto path = folder / "a.bag";
    const auto log = BadLog::Init(path);
    BadLog::CreateTopic("A", "ul", [] { return 1; });
    log.FinishInitialization();
    const auto start = TWO_GIB - 10;
    REQUIRE(badlog::CutTo(DescriptorOf(path), start));
    for (int i = 0; i < 5; i++) Row(log);
    CHECK(log.State() == LogState::LOGGING);
    CHECK(log.Counters().rowsMissed == 0);
    log.Close();
    CHECK(ReadFrom(path, start) == "1.0000\n1.0000\n1.0000\n1.0000\n1.0000\n");
    CHECK(BadLog::FreePath(path) == folder / "a_2.bag");

    badlog::LogFile file{folder / "b.bag"};
    REQUIRE(badlog::CutTo(DescriptorOf(folder / "b.bag"), TWO_GIB + 10));
    CHECK_FALSE(file.Append("row\n"));
    CHECK_FALSE(file.Sync());
    CHECK(file.Exists());
    CHECK(ReadFrom(folder / "b.bag", TWO_GIB + 10) == "row\n");
}

TEST_CASE("folders and logs that were changed after 2038 are found") {
    const Folder folder;
    const auto logs = folder / "logs";
    std::filesystem::create_directory(logs);
    if (!IsDated2050(logs)) {
        MESSAGE("Not tried: this C library, or this disk, knows no times after 2038.");
        return;
    }
    CHECK(badlog::Exists(logs));
    CHECK_FALSE(badlog::CreateFolders(logs));
    REQUIRE(IsDated2050(logs));
    badlog::LogFile file{logs + "/new/a.bag"};
    CHECK(file.IsOpen());
    REQUIRE(IsDated2050(logs + "/new/a.bag"));
    CHECK(file.Exists());
    CHECK(BadLog::FreePath(logs + "/new/a.bag") == logs + "/new/a_2.bag");
}

#endif
