#include "LogFile.h"

#include <cerrno>
#include <utility>

#include "SystemFile.h"
#include "SystemPath.h"

namespace badlog {

LogFile::LogFile(std::string path) : m_path{std::move(path)}, m_place{SystemPath(m_path)}, m_folder{m_place.parent_path()} {
    m_failure = Open();
}

LogFile::~LogFile() {
    Close();
}

std::error_code LogFile::Open() {
    if (const auto failure = CreateFolders(m_folder)) return failure;
    m_descriptor = OpenNew(m_place);
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
            // Tried again before the next row; a file that has disappeared cannot be truncated.
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
    SyncNames(m_folder);
}

bool LogFile::Exists() const {
    return badlog::Exists(m_place);
}

std::error_code LogFile::Close() {
    if (!IsOpen()) return {};
    const auto isClosed = CloseDescriptor(std::exchange(m_descriptor, -1));
    return isClosed ? std::error_code{} : LastError();
}

std::error_code LogFile::CutTornEnd() {
    if (!CutTo(m_descriptor, m_length)) return LastError();
    m_isTorn = false;
    return {};
}

}  // namespace badlog
