#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "LogFiles.h"
#include "OpenFailure.h"
#include "SystemPath.h"

#if !defined(_WIN32)
#include <unistd.h>
#endif
#if defined(__linux__)
#include <sys/prctl.h>
#endif

using badlog::BadLog;
using badlog::LogState;

namespace {

/** Returns the message about a log that cannot be created; checks that it logs nothing. */
std::string RefusalOf(const std::string& path) {
    return StandardErrorOf([&] {
        const auto log = BadLog::Init(path);
        BadLog::CreateTopic("A", "ul", [] { return 1; });
        log.FinishInitialization();
        Row(log);
        CHECK(log.State() == LogState::FAILING);
        CHECK(log.Counters().rowsMissed == 1);
        log.Close();
    });
}

std::string Reason(const std::string& path, std::errc failure) {
    return badlog::OpenFailureText(path, std::make_error_code(failure));
}

#if !defined(_WIN32)
/** While it lives, the program has an ordinary user's rights: permissions have no effect on root. */
class WithoutRoot {
public:
    WithoutRoot() {
        if (m_isRoot) REQUIRE(seteuid(NOBODY) == 0);
    }
    ~WithoutRoot() {
        if (!m_isRoot) return;
        CHECK(seteuid(0) == 0);
#if defined(__linux__)
        // Linux removes this right with the change of users, and AddressSanitizer needs it to find leaks.
        prctl(PR_SET_DUMPABLE, 1);
#endif
    }
    WithoutRoot(const WithoutRoot&) = delete;
    WithoutRoot& operator=(const WithoutRoot&) = delete;

private:
    static constexpr uid_t NOBODY = 65534;
    const bool m_isRoot = geteuid() == 0;
};
#endif

}  // namespace

#if !defined(_WIN32)
TEST_CASE("the message about a read-only folder names the reason and the next step") {
    const Folder folder;
    const auto readOnly = folder / "read-only";
    std::filesystem::create_directory(readOnly);
    std::filesystem::permissions(readOnly, std::filesystem::perms{0555});
    const WithoutRoot withoutRoot;
    CHECK(
        RefusalOf(readOnly + "/a.bag") ==
        "badlog: The log " + readOnly + "/a.bag cannot be created: the folder " + readOnly +
            " is read-only for this program. Nothing is logged; use a folder that exists and can be written to, such as "
            "/home/lvuser/logs.\n");
    CHECK(
        RefusalOf(readOnly + "/new/logs/a.bag") ==
        "badlog: The log " + readOnly + "/new/logs/a.bag cannot be created: the folder " + readOnly +
            "/new/logs does not exist, and the folder " + readOnly +
            " is read-only for this program. Nothing is logged; use a folder that exists and can be written to, such as "
            "/home/lvuser/logs.\n");
}
#endif

TEST_CASE("the message about a read-only file names it") {
    const Folder folder;
    const auto path = folder / "a.bag";
    std::ofstream{badlog::SystemPath(path)} << "old";
    std::filesystem::permissions(badlog::SystemPath(path), std::filesystem::perms{0444});
    {
#if !defined(_WIN32)
        const WithoutRoot withoutRoot;
#endif
        if (std::ofstream{badlog::SystemPath(path), std::ios::app}.is_open()) {
            MESSAGE("Not tried: this system, such as Wine for root, opens read-only files.");
        } else {
            CHECK(
                RefusalOf(path) == "badlog: The log " + path +
                                       " cannot be created: a read-only file has that name. Nothing is logged; delete that file, "
                                       "or use another name.\n");
        }
    }
    CHECK(Read(path) == "old");
    // Windows does not delete it otherwise.
    std::filesystem::permissions(badlog::SystemPath(path), std::filesystem::perms{0666});
}

TEST_CASE("the message about a folder at the log's path names it") {
    const Folder folder;
    const auto path = folder / "logs";
    std::filesystem::create_directory(badlog::SystemPath(path));
    const auto messages = RefusalOf(path);
    CHECK(messages.find("cannot be created: it is a folder. Nothing is logged; name a file in it, such as ") != std::string::npos);
    CHECK(messages.find("robot.bag.\n") != std::string::npos);
}

TEST_CASE("the message about a read-only disk names it and the missing folder") {
    const Folder folder;
    const auto disk = badlog::TextOf(badlog::SystemPath(folder / "logs").parent_path());
    CHECK(
        Reason(folder / "a.bag", std::errc::read_only_file_system).find("cannot be created: the folder " + disk + " is on a read-only disk. ") !=
        std::string::npos);
    CHECK(
        Reason(folder / "logs/a.bag", std::errc::read_only_file_system)
            .find("the folder " + (folder / "logs") + " does not exist, and the folder " + disk + " is on a read-only disk. ") !=
        std::string::npos);
    CHECK(Reason("a.bag", std::errc::permission_denied).find("the current folder is read-only for this program. ") != std::string::npos);
}

TEST_CASE("any other failure is reported in the system's words") {
    const auto text = Reason("a.bag", std::errc::no_space_on_device);
    CHECK(text.find("The log a.bag cannot be created: " + std::make_error_code(std::errc::no_space_on_device).message()) == 0);
}
