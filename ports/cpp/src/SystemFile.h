#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <system_error>

namespace badlog {

// The system's calls for files. They work for any path on Windows, and for lengths above 2 GiB and times after 2038 even
// on 32-bit systems. A call that fails leaves its reason for LastError.

/** The reason why the last call of this thread failed. */
std::error_code LastError();

/** Creates or empties a file; returns its descriptor, or -1. */
int OpenNew(const std::filesystem::path& path);
/** Returns how many of the bytes were written, or -1. */
int64_t WriteSome(int descriptor, const char* bytes, size_t size);
/** Waits until everything is on the disk. */
bool SyncToDisk(int descriptor);
/** Sets the length of a file; the next bytes are written there. */
bool CutTo(int descriptor, int64_t length);
bool CloseDescriptor(int descriptor);

/** Syncs the names of a folder's files to the disk, if the system does not do so by itself. Allocates nothing. */
void SyncNames(const std::filesystem::path& folder);
/** Returns whether there is a file or a folder of that name. Allocates nothing. */
bool Exists(const std::filesystem::path& path);
bool IsFolder(const std::filesystem::path& path);
/** Creates the folders of a path that are missing. */
std::error_code CreateFolders(const std::filesystem::path& folder);

}  // namespace badlog
