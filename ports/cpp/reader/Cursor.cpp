#include "Cursor.h"

#include <algorithm>
#include <string>

namespace badlog::reader {

size_t LineEndIn(std::string_view data, size_t start, size_t until) {
    return std::min(data.substr(0, until).find_first_of(std::string_view{"\n\r\0", 3}, start), until);
}

size_t AfterLineEnd(std::string_view data, size_t end) {
    if (end == data.size() || data[end] == '\0') return end;
    return data[end] == '\r' && end + 1 < data.size() && data[end + 1] == '\n' ? end + 2 : end + 1;
}

void Cursor::AdvanceTo(size_t following) {
    const auto read = data.substr(start, following - start);
    const auto last = read.size() >= 2 ? read.substr(read.size() - 2) : read;
    if (last == "\r\n" || (!last.empty() && last.back() == '\r')) sawCarriageReturn = true;
    start = following;
}

size_t Cursor::PassBlankLine(size_t end, size_t following, ProblemList& problems) {
    // The rest of a line after a hole is not a blank line.
    if (!IsAfterHole()) problems.Add("BLANK_LINE", "A blank line was skipped.", line);
    if (following > end) line++;
    return following;
}

bool Cursor::PassHole(ProblemList& problems) {
    if (start < End() && data[start] == '\0') {
        const auto at = std::min(data.find_first_not_of('\0', start), End());
        problems.Add(
            "NUL_HOLE",
            "NUL bytes (" + std::to_string(at - start) + ") have replaced data, probably after a power loss; that data is lost.", line);
        AdvanceTo(at);
        holeLine = line;
    }
    return start < End();
}

}  // namespace badlog::reader
