#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "Cursor.h"

namespace badlog::reader {

/** Whether there are bytes that no text has. */
bool HasControls(std::string_view line);

/** What the first lines from the titles on look like; the rows show whether a line of titles is damaged or only odd. */
class FirstLines {
public:
    /** A line without its end. */
    struct Line {
        size_t start;
        size_t end;
        /** Where the next line begins. */
        size_t following;
        /** The number of its cells; 0 if its quotes or its bytes are not those of a row. */
        size_t cells;
        /** The number of them that are numbers, or true or false. */
        size_t numbers;
        size_t texts;

        /** Whether it is a line of titles rather than a row: all of its cells are texts. */
        bool IsTitles() const { return texts == cells; }
    };

    /** Looks at the titles, at the cursor, and some lines after them. */
    explicit FirstLines(const Cursor& cursor);

    std::vector<Line> lines;
    /** The number of cells that most of the lines after the titles have; 0 if that is not clear. */
    size_t width = 0;
    /** Whether there are rows with numbers among them. */
    bool hasRows = false;
    /** Whether they are the bytes of a picture, an archive or a program: damage leaves more text than that. */
    bool isBinary = false;

    /** The number of cells of a row, if line 1 has that many names; 0 if it is not clear. */
    size_t ClearWidth(size_t names) const;
    /** The end of the lines that damage tore off the line of titles: they are not rows. */
    size_t RestOfTitles(size_t following, size_t cells) const;

private:
    void FindWidth();
};

}  // namespace badlog::reader
