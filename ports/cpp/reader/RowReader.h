#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "Cell.h"
#include "Column.h"
#include "Cursor.h"
#include "ProblemList.h"
#include "RowSplitter.h"

namespace badlog::reader {

/**
 * Reads one row after another, even quoted, cut, split, too short and too long ones. A line that is a complete row by
 * itself is never merged into a damaged one before it.
 */
class RowReader {
public:
    /** `endsInNewline` says that every whole row of this file ends in a newline. A last row without one is cut. */
    RowReader(Cursor& cursor, std::vector<Column>& columns, ProblemList& problems, bool endsInNewline);

    int64_t rowCount = 0;
    /** Whether reading stopped because the bytes that follow are not rows at all. */
    bool gaveUp = false;

    /** Reads from the cursor on, which is at the start of a line. Returns where the next row begins. */
    size_t Read();

private:
    using Next = std::optional<size_t>;

    size_t Repair();
    Next QuotedLines(size_t start, size_t secondLine);
    bool HasSameNumbers() const;
    bool ReadWithOddQuotes(size_t start, size_t end, bool mayBeOpen);
    Next JoinedLines(size_t start, size_t newline, size_t secondLine);
    bool IsTextTornAt(size_t newline, size_t following) const;
    bool ContinuesText(size_t start, size_t end);
    bool IsCompleteRow(size_t start, size_t until);
    size_t TakeUneven(size_t start, size_t end, size_t following);
    size_t Tail(size_t start, size_t until, bool isCut);
    void DropLastCell();
    size_t Take(bool undouble, size_t following);
    Cell CellOf(size_t index, bool undouble) const;
    CellKind KindOf(size_t index) const;
    std::string Quotation(size_t start, size_t until) const;
    size_t GiveUp(std::string_view kind, std::string message);

    Cursor& m_cursor;
    std::vector<Column>& m_columns;
    const size_t m_wanted;
    ProblemList& m_problems;
    const bool m_endsInNewline;
    RowSplitter m_splitter;
    std::vector<bool> m_numbersBefore;
    /** The row that was found, if one was. */
    std::optional<std::vector<Cell>> m_row;
    /** The number of physical lines that were read. */
    int64_t m_linesPassed = 0;
};

}  // namespace badlog::reader
