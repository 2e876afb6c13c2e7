#include "LogFile.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <utility>

#if defined(_WIN32)
#include <io.h>
#include <sys/stat.h>
#else
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace badlog {
namespace {

std::error_code LastError() {
    return {errno, std::generic_category()};
}

#if defined(_WIN32)
int OpenNew(const char* path) {
    return _open(path, _O_WRONLY | _O_CREAT | _O_TRUNC | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}
int64_t WriteSome(int descriptor, const char* bytes, size_t size) {
    return _write(descriptor, bytes, static_cast<unsigned>(size));
}
bool SyncToDisk(int descriptor) { return _commit(descriptor) == 0; }
bool CutTo(int descriptor, int64_t length) {
    return _chsize_s(descriptor, length) == 0 && _lseeki64(descriptor, length, SEEK_SET) >= 0;
}
bool CloseFile(int descriptor) { return _close(descriptor) == 0; }
#else
int OpenNew(const char* path) {
    return open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}
int64_t WriteSome(int descriptor, const char* bytes, size_t size) {
    return write(descriptor, bytes, size);
}
bool SyncToDisk(int descriptor) { return fsync(descriptor) == 0; }
bool CutTo(int descriptor, int64_t length) {
    return ftruncate(descriptor, length) == 0 && lseek(descriptor, length, SEEK_SET) >= 0;
}
bool CloseFile(int descriptor) { return close(descriptor) == 0; }
#endif

}  // namespace

LogFile::LogFile(std::string path) : m_path{std::move(path)} {
    m_folder = std::filesystem::path{m_path}.parent_path().string();
    m_failure = Open();
}

LogFile::~LogFile() {
    Close();
}

std::error_code LogFile::Open() {
    std::error_code failure;
    if (!m_folder.empty()) std::filesystem::create_directories(m_folder, failure);
    m_descriptor = OpenNew(m_path.c_str());
    return IsOpen() ? std::error_code{} : LastError();
}

std::error_code LogFile::Append(std::string_view bytes) {
    if (m_isTorn) {
        if (const auto failure = CutTornEnd()) return failure;
    }
    const auto size = static_cast<int64_t>(bytes.size());
    while (!bytes.empty()) {
        const auto count = WriteSome(m_descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            const auto failure = LastError();
            m_isTorn = true;
            // Tried again before the next row; a file that has vanished cannot be cut.
            CutTornEnd();
            return failure;
        }
        bytes.remove_prefix(static_cast<size_t>(count));
    }
    m_length += size;
    return {};
}

std::error_code LogFile::Sync() {
    return SyncToDisk(m_descriptor) ? std::error_code{} : LastError();
}

void LogFile::SyncFolder() {
#if !defined(_WIN32)
    const int folder = open(m_folder.empty() ? "." : m_folder.c_str(), O_RDONLY | O_CLOEXEC);
    if (folder < 0) return;
    fsync(folder);
    close(folder);
#endif
    // Windows does not open folders; it writes names to the disk by itself.
}

bool LogFile::Exists() const {
    // Not with std::filesystem, which allocates an object for each name.
    struct stat found {};
    return stat(m_path.c_str(), &found) == 0;
}

std::error_code LogFile::Close() {
    if (!IsOpen()) return {};
    const auto isClosed = CloseFile(std::exchange(m_descriptor, -1));
    return isClosed ? std::error_code{} : LastError();
}

std::error_code LogFile::CutTornEnd() {
    if (!CutTo(m_descriptor, m_length)) return LastError();
    m_isTorn = false;
    return {};
}

}  // namespace badlog
