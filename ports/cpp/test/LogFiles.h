#pragma once

#include <functional>
#include <string>
#include <vector>

#include "badlog/BadLog.h"

/** A new folder, deleted at the end. */
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string operator/(const std::string& name) const { return m_path + "/" + name; }

private:
    std::string m_path;
};

/** Returns all bytes of a file. */
std::string Read(const std::string& path);

/** Returns the lines of a bag after its two header lines, without the empty one at the end. */
std::vector<std::string> RowsIn(const std::string& path);

/** Logs to a new file: `create` makes topics, `loop` is the robot's loop. Returns the file's bytes. */
std::string Logged(const std::function<void()>& create, const std::function<void(badlog::BadLog&)>& loop);

/** Returns the rows in the bytes that Logged returns. */
std::vector<std::string> Rows(const std::string& bag);

/** Returns the text that an action writes to standard error. */
std::string StandardErrorOf(const std::function<void()>& action);

void Row(const badlog::BadLog& log);
