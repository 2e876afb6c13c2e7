#include "OpenFailure.h"

#include <filesystem>

#include "SystemFile.h"
#include "SystemPath.h"

namespace badlog {
namespace {

constexpr const char* OTHER_FOLDER = "use a folder that exists and can be written to, such as /home/lvuser/logs";

bool IsReadOnly(std::error_code failure) {
    return failure == std::errc::permission_denied || failure == std::errc::operation_not_permitted ||
           failure == std::errc::read_only_file_system;
}

std::string NameOf(const std::filesystem::path& folder) {
    return folder.empty() ? "the current folder" : "the folder " + TextOf(folder);
}

/** Returns why nothing can be created in a folder. */
std::string ReadOnlyReason(const std::filesystem::path& folder, bool isDisk) {
    auto present = folder;
    while (!present.empty() && present != present.parent_path() && !Exists(present)) present = present.parent_path();
    const auto readOnly = NameOf(present) + (isDisk ? " is on a read-only disk" : " is read-only for this program");
    return present == folder ? readOnly : NameOf(folder) + " does not exist, and " + readOnly;
}

}  // namespace

std::string OpenFailureText(const std::string& path, std::error_code failure) {
    const auto file = SystemPath(path);
    auto reason = failure.message();
    std::string next = OTHER_FOLDER;
    if (IsFolder(file)) {
        reason = "it is a folder";
        next = "name a file in it, such as " + TextOf(file / "robot.bag");
    } else if (IsReadOnly(failure)) {
        const bool isDisk = failure == std::errc::read_only_file_system;
        if (Exists(file) && !isDisk) {
            reason = "a read-only file has that name";
            next = "delete that file, or use another name";
        } else {
            reason = ReadOnlyReason(file.parent_path(), isDisk);
        }
    }
    return "The log " + path + " cannot be created: " + reason + ". Nothing is logged; " + next + ".";
}

}  // namespace badlog
