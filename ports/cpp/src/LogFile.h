#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace badlog {

/** A file that only grows: one write for each Append. A failed Append leaves the file unchanged. */
class LogFile {
public:
    /** Creates or empties the file at a path in UTF-8, and its folders; see IsOpen and Failure. */
    explicit LogFile(std::string path);
    ~LogFile();
    LogFile(const LogFile&) = delete;
    LogFile& operator=(const LogFile&) = delete;

    const std::string& Path() const { return m_path; }
    bool IsOpen() const { return m_descriptor >= 0; }
    /** The reason why it could not be opened. */
    std::error_code Failure() const { return m_failure; }
    /** The number of bytes that were appended. */
    int64_t Length() const { return m_length; }

    /** Returns an error if not all bytes could be written; then none are, and the next call may try again. */
    std::error_code Append(std::string_view bytes);
    /** Waits until everything is on the disk. Only for a thread that has nothing else to do. */
    std::error_code Sync();
    /**
     * Syncs the names of its folder's files to the disk. Otherwise, a loss of power could remove even the name of a
     * new file.
     */
    void SyncFolder();
    /** Whether it still exists; a deleted file can still be written to. */
    bool Exists() const;
    std::error_code Close();

    /** Whether it was found to be deleted. */
    std::atomic<bool> isMissing{false};

private:
    std::error_code Open();
    std::error_code CutTornEnd();

    std::string m_path;
    std::filesystem::path m_place;
    std::filesystem::path m_folder;
    std::error_code m_failure;
    int m_descriptor = -1;
    int64_t m_length = 0;
    bool m_isTorn = false;
};

}  // namespace badlog
