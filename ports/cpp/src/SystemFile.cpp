// Before the system's first header: 64 bits for lengths and, if the C library has them, for times.
#undef _FILE_OFFSET_BITS
#define _FILE_OFFSET_BITS 64
#undef _TIME_BITS
#define _TIME_BITS 64

#include "SystemFile.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>

#if defined(_WIN32)
#include <direct.h>
#include <io.h>
#include <share.h>
#else
#include <unistd.h>

static_assert(sizeof(off_t) == sizeof(int64_t), "Compile this file on its own, or everything with -D_FILE_OFFSET_BITS=64.");
#endif

namespace badlog {
namespace {

#if defined(_WIN32)
using Status = struct _stat64;

bool IsFound(const std::filesystem::path& path, Status& status) { return _wstat64(path.c_str(), &status) == 0; }
bool MakeFolder(const std::filesystem::path& folder) { return _wmkdir(folder.c_str()) == 0; }
#else
using Status = struct stat;

bool IsFound(const std::filesystem::path& path, Status& status) { return stat(path.c_str(), &status) == 0; }
bool MakeFolder(const std::filesystem::path& folder) { return mkdir(folder.c_str(), 0777) == 0; }
#endif

}  // namespace

std::error_code LastError() {
    return {errno, std::generic_category()};
}

#if defined(_WIN32)
int OpenNew(const std::filesystem::path& path) {
    int descriptor = -1;
    // Other programs may read it meanwhile. Microsoft's compiler warns of the shorter _wopen.
    _wsopen_s(&descriptor, path.c_str(), _O_WRONLY | _O_CREAT | _O_TRUNC | _O_BINARY | _O_NOINHERIT, _SH_DENYNO, _S_IREAD | _S_IWRITE);
    return descriptor;
}
int64_t WriteSome(int descriptor, const char* bytes, size_t size) {
    return _write(descriptor, bytes, static_cast<unsigned>(size));
}
bool SyncToDisk(int descriptor) { return _commit(descriptor) == 0; }
bool CutTo(int descriptor, int64_t length) {
    return _chsize_s(descriptor, length) == 0 && _lseeki64(descriptor, length, SEEK_SET) >= 0;
}
bool CloseDescriptor(int descriptor) { return _close(descriptor) == 0; }
void SyncNames(const std::filesystem::path&) {
    // Windows does not open folders; it writes names to the disk by itself.
}
#else
int OpenNew(const std::filesystem::path& path) {
    return open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}
int64_t WriteSome(int descriptor, const char* bytes, size_t size) {
    return write(descriptor, bytes, size);
}
bool SyncToDisk(int descriptor) { return fsync(descriptor) == 0; }
bool CutTo(int descriptor, int64_t length) {
    return ftruncate(descriptor, length) == 0 && lseek(descriptor, length, SEEK_SET) >= 0;
}
bool CloseDescriptor(int descriptor) { return close(descriptor) == 0; }
void SyncNames(const std::filesystem::path& folder) {
    const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}
#endif

bool Exists(const std::filesystem::path& path) {
    Status status{};
    return IsFound(path, status);
}

bool IsFolder(const std::filesystem::path& path) {
    Status status{};
    return IsFound(path, status) && (status.st_mode & S_IFMT) == S_IFDIR;
}

std::error_code CreateFolders(const std::filesystem::path& folder) {
    // Not by std::filesystem, which on a 32-bit system refuses folders that were changed after 2038.
    if (folder.empty() || Exists(folder)) return {};
    const auto parent = folder.parent_path();
    if (parent != folder) {
        if (const auto failure = CreateFolders(parent)) return failure;
    }
    if (MakeFolder(folder)) return {};
    const auto failure = LastError();
    // Another program may have created it meanwhile; and `logs/` was already created as its parent `logs`.
    return Exists(folder) ? std::error_code{} : failure;
}

}  // namespace badlog
