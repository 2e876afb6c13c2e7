#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ProblemList.h"

namespace badlog::reader {

/**
 * Returns the end of the line: its LF or CR, or a NUL, where the original bytes are lost. Returns `until`
 * if there is none.
 */
size_t LineEndIn(std::string_view data, size_t start, size_t until);

/** Returns the start of the line after the one that ends at `end`; for a NUL, the NUL itself. */
size_t AfterLineEnd(std::string_view data, size_t end);

/** The bytes of a file, and the place up to which they are read. */
class Cursor {
public:
    explicit Cursor(std::string_view bytes) : data{bytes} {}

    std::string_view data;
    size_t start = 0;
    /** The physical line, from 1, that `start` is in. */
    int64_t line = 1;
    /** The line on which a run of NULs was skipped last; 0 before any. */
    int64_t holeLine = 0;
    /** Whether a line that was read ended in a carriage return. */
    bool sawCarriageReturn = false;

    size_t End() const { return data.size(); }
    /** Whether the beginning of the line that `start` is in was lost in a run of NULs. */
    bool IsAfterHole() const { return line == holeLine; }
    std::string_view Piece(size_t from, size_t until) const { return data.substr(from, until - from); }

    /** Records that everything before `following` is read. */
    void AdvanceTo(size_t following);
    /** Skips the blank line that ends at `end`, before `following`; returns where the next one begins. */
    size_t PassBlankLine(size_t end, size_t following, ProblemList& problems);
    /** Skips NULs; returns whether anything is left. */
    bool PassHole(ProblemList& problems);
};

}  // namespace badlog::reader
