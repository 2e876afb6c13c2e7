#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "Cursor.h"

namespace badlog::reader {

/** Returns whether there are bytes that do not occur in text. */
bool HasControls(std::string_view line);

/** The first lines from the titles on: the rows show whether a line of titles is damaged or merely unusual. */
class FirstLines {
public:
    /** A line without its end. */
    struct Line {
        size_t start;
        size_t end;
        /** Where the next line begins. */
        size_t following;
        /** The number of its cells; 0 if its quotes or bytes cannot be in a row. */
        size_t cells;
        /** The number of cells with a number, `true` or `false`. */
        size_t numbers;
        size_t texts;

        /** Whether it is a line of titles rather than a row: all of its cells are texts. */
        bool IsTitles() const { return texts == cells; }
    };

    /** Examines the titles, which are at the cursor, and some lines after them. */
    explicit FirstLines(const Cursor& cursor);

    std::vector<Line> lines;
    /** The number of cells that most of the lines after the titles have; 0 if that is not clear. */
    size_t width = 0;
    /** Whether there are rows with numbers among them. */
    bool hasRows = false;
    /** Whether the bytes are a picture, an archive or a program: even a damaged log has more text than those. */
    bool isBinary = false;

    /** Returns the number of cells in a row; 0 if that is not clear. */
    size_t ClearWidth(size_t names) const;
    /** Returns the end of the lines that damage split off the line of titles: they are not rows. */
    size_t RestOfTitles(size_t following, size_t cells) const;

private:
    void FindWidth();
};

}  // namespace badlog::reader
