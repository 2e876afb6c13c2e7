#include "LogFiles.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <thread>

#if defined(_WIN32)
#include <io.h>
#define dup _dup
#define dup2 _dup2
#define fileno _fileno
#define close _close
#else
#include <unistd.h>
#endif

#include "StandardError.h"
#include "SystemPath.h"

using badlog::SystemPath;
using badlog::TextOf;

namespace {

constexpr int MAX_PRINT_MILLISECONDS = 60'000;

bool SendStandardErrorTo(const std::filesystem::path& path) {
#if defined(_WIN32)
    return _wfreopen(path.c_str(), L"wb", stderr) != nullptr;
#else
    return std::freopen(path.c_str(), "w", stderr) != nullptr;
#endif
}

}  // namespace

Folder::Folder() {
    std::random_device random;
    m_path = TextOf(std::filesystem::temp_directory_path() / ("badlog" + std::to_string(random()) + std::to_string(random())));
    std::filesystem::create_directories(SystemPath(m_path));
}

Folder::~Folder() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{1};
    std::error_code failure;
    std::filesystem::remove_all(SystemPath(m_path), failure);
    // Windows does not delete open files, and a log's own thread closes its file a little after Close() has returned.
    while (failure && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
        std::filesystem::remove_all(SystemPath(m_path), failure);
    }
}

std::string Read(const std::string& path) {
    std::ifstream file{SystemPath(path), std::ios::binary};
    return {std::istreambuf_iterator<char>{file}, {}};
}

std::vector<std::string> Rows(const std::string& bag) {
    std::vector<std::string> lines;
    std::istringstream stream{bag};
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    lines.erase(lines.begin(), lines.begin() + 2);
    return lines;
}

std::vector<std::string> RowsIn(const std::string& path) {
    return Rows(Read(path));
}

std::string Logged(const std::function<void()>& create, const std::function<void(badlog::BadLog&)>& loop) {
    const Folder folder;
    auto log = badlog::BadLog::Init(folder / "test.bag");
    create();
    log.FinishInitialization();
    loop(log);
    log.Close();
    return Read(folder / "test.bag");
}

std::string StandardErrorOf(const std::function<void()>& action) {
    const Folder folder;
    badlog::AwaitPrinted(MAX_PRINT_MILLISECONDS);
    std::fflush(stderr);
    const int before = dup(fileno(stderr));
    if (!SendStandardErrorTo(SystemPath(folder / "messages"))) std::abort();
    action();
    badlog::AwaitPrinted(MAX_PRINT_MILLISECONDS);
    std::fflush(stderr);
    dup2(before, fileno(stderr));
    close(before);
    return Read(folder / "messages");
}

void Row(const badlog::BadLog& log) {
    log.UpdateTopics();
    log.Log();
}
