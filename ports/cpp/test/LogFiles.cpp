#include "LogFiles.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

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

namespace {

constexpr int SAID_MILLISECONDS = 60'000;

}  // namespace

Folder::Folder() {
    std::random_device random;
    m_path = (std::filesystem::temp_directory_path() / ("badlog" + std::to_string(random()) + std::to_string(random()))).string();
    std::filesystem::create_directories(m_path);
}

Folder::~Folder() {
    std::error_code failure;
    std::filesystem::remove_all(m_path, failure);
}

std::string Read(const std::string& path) {
    std::ifstream file{path, std::ios::binary};
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
    badlog::AwaitSaid(SAID_MILLISECONDS);
    std::fflush(stderr);
    const int before = dup(fileno(stderr));
    if (std::freopen((folder / "said").c_str(), "w", stderr) == nullptr) std::abort();
    action();
    badlog::AwaitSaid(SAID_MILLISECONDS);
    std::fflush(stderr);
    dup2(before, fileno(stderr));
    close(before);
    return Read(folder / "said");
}

void Row(const badlog::BadLog& log) {
    log.UpdateTopics();
    log.Log();
}
