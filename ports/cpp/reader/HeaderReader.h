#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "BagHeader.h"
#include "ColumnTitles.h"
#include "Cursor.h"
#include "FirstLines.h"
#include "ProblemList.h"

namespace badlog::reader {

constexpr std::string_view NOT_A_LOG = "This file is neither a bag nor a CSV file";

/** Reads the lines before the rows: the line of JSON, if there is one, and the line of column titles. */
class HeaderReader {
public:
    HeaderReader(Cursor& cursor, ProblemList& problems) : m_cursor{cursor}, m_problems{problems} {}

    /** Whether there is a line of JSON, readable or not. */
    bool hasLine = false;
    /** The content of that line; nothing if it is missing or cannot be read. */
    std::optional<BagHeader> header;
    /** The columns; nothing if the line of titles is missing. */
    std::optional<HeaderColumns> columns;
    bool isDone = false;
    /** Whether the bytes turned out not to be a log. */
    bool isNotLog = false;

    const BagHeader* Header() const { return header ? &*header : nullptr; }

    /** Reads one line of the header. Returns where the next begins. */
    size_t Read();

private:
    size_t ReadSignature();
    size_t TakeFirstLine(size_t lineEnd, size_t following);
    size_t TakeTitles(size_t lineEnd, size_t following);
    size_t TakeWithHeader(const Names& titles, size_t following, bool isCut);
    size_t TakeWithoutHeader(const Names& titles, size_t lineEnd, size_t following);
    size_t TakeUntitled(size_t width);
    size_t SkipTo(const FirstLines::Line& titles, size_t firstEnd);
    HeaderColumns ColumnsOf(const ColumnTitles& known, const Names& titles);
    std::optional<std::string> OtherSeparator(const std::string& title, const FirstLines& firstLines, size_t width) const;
    Names Titles(size_t lineEnd, const Names& names);
    int64_t LinesIn(size_t start, size_t until) const;
    void ReportUnreadable(std::string message);
    void ReportEncoding();
    size_t Refuse(std::string message);

    Cursor& m_cursor;
    ProblemList& m_problems;
    bool m_isAtSignature = true;
    bool m_isAtFirstLine = true;
    bool m_mayBeUtf16 = false;
    bool m_sawOtherText = false;
};

}  // namespace badlog::reader
