#include "RowReader.h"

#include <algorithm>

#include "Text.h"

namespace badlog::reader {
namespace {

constexpr int64_t MAX_ROWS = 50'000'000;
constexpr size_t MAX_ROW_BYTES = 1 << 24;
// For a damaged row the reader may look ahead, but never further than this.
constexpr int64_t MAX_LINES = 100;
constexpr size_t MAX_BYTES = 1 << 16;
constexpr size_t QUOTED_BYTES = 200;

bool IsDigit(char byte) {
    return byte >= '0' && byte <= '9';
}

/** Returns whether it is a number directly followed by letters. Then damage left only the x and the end of this row. */
bool IsEndOfRow(std::string_view piece) {
    size_t at = 0;
    while (at < piece.size() && IsDigit(piece[at])) at++;
    if (at == 0 || at == piece.size() || piece[at] != '.') return false;
    at++;
    while (at < piece.size() && IsDigit(piece[at])) at++;
    if (at == piece.size()) return false;
    const auto byte = static_cast<unsigned char>(piece[at]);
    // Like core, which reads bytes beyond ASCII as signed ones.
    return IsLetterOrDigit(byte < 0x80 ? byte : 0xFF00u | byte);
}

}  // namespace

RowReader::RowReader(Cursor& cursor, std::vector<Column>& columns, ProblemList& problems, bool endsInNewline)
    : m_cursor{cursor}, m_columns{columns}, m_wanted{columns.size()}, m_problems{problems}, m_endsInNewline{endsInNewline} {}

size_t RowReader::Read() {
    if (rowCount >= MAX_ROWS) {
        return GiveUp("TOO_MANY_ROWS", "The log has more than " + std::to_string(MAX_ROWS) + " rows; the rest was not read.");
    }
    const auto longest = m_cursor.start + MAX_ROW_BYTES;
    if (longest < m_cursor.End() && LineEndIn(m_cursor.data, m_cursor.start, longest) == longest) {
        return GiveUp(
            "ROW_CUT", "A line of more than " + std::to_string(MAX_ROW_BYTES) + " bytes is not a row of samples; the rest was not read.");
    }
    m_row.reset();
    m_linesPassed = 1;
    const auto following = Repair();
    if (m_row) {
        for (size_t i = 0; i < m_wanted; i++) m_columns[i].Add(rowCount, (*m_row)[i], m_cursor.line);
        rowCount++;
    }
    m_cursor.line += m_linesPassed;
    return following;
}

size_t RowReader::Repair() {
    const auto data = m_cursor.data;
    const auto start = m_cursor.start;
    const auto end = LineEndIn(data, start, m_cursor.End());
    if (end == m_cursor.End()) return Tail(start, end, m_endsInNewline);
    if (data[end] == '\0') {
        if (end > start) Tail(start, end, true);
        m_linesPassed = 0;
        return end;
    }
    const auto following = AfterLineEnd(data, end);
    if (end == start) {
        m_linesPassed = 0;
        return m_cursor.PassBlankLine(end, following, m_problems);
    }
    const auto count = m_splitter.Split(data, start, end, Quotes::STRICT);
    if (m_splitter.IsProper() && count == m_wanted) return Take(true, following);
    if (m_splitter.isOpen && !m_splitter.isMalformed) {
        m_numbersBefore.clear();
        for (size_t i = 0; i < std::min(count - 1, m_wanted); i++) m_numbersBefore.push_back(KindOf(i) == CellKind::NUMBER);
        if (const auto after = QuotedLines(start, following)) return *after;
    }
    if (ReadWithOddQuotes(start, end, true)) return Take(false, following);
    if (m_cursor.IsAfterHole()) {
        // The bytes between a hole and the next newline would be a whole row only by chance.
        m_problems.Add(
            "ROW_CUT", "The end of a row whose beginning is lost was dropped; it held " + Quotation(start, end) + ".", m_cursor.line);
        return following;
    }
    if (const auto after = JoinedLines(start, end, following)) return *after;
    if (ContinuesText(start, end)) return following;
    return TakeUneven(start, end, following);
}

/** Reads a row with newlines inside a quoted cell, as RFC 4180 allows; returns nothing if it is not one. */
RowReader::Next RowReader::QuotedLines(size_t start, size_t secondLine) {
    const auto data = m_cursor.data;
    auto at = secondLine;
    bool holdsRows = false;
    for (int64_t lines = 2; lines <= MAX_LINES; lines++) {
        const auto end = LineEndIn(data, at, m_cursor.End());
        if (end - start > MAX_BYTES) return std::nullopt;
        // With one topic, every line is a row.
        if (at < end && (m_wanted == 1 || IsCompleteRow(at, end))) {
            if (m_wanted > 1 && HasSameNumbers()) return std::nullopt;
            holdsRows = true;
        }
        if (end == m_cursor.End()) return holdsRows ? std::nullopt : Next{Tail(start, end, m_endsInNewline)};
        if (data[end] == '\0') return std::nullopt;
        const auto following = AfterLineEnd(data, end);
        // A line without a quote closes none.
        const bool mayClose = m_cursor.Piece(at, end).find('"') != std::string_view::npos;
        const auto count = mayClose ? m_splitter.Split(data, start, end, Quotes::STRICT) : 0;
        if (mayClose && !m_splitter.isOpen) {
            if (m_splitter.isMalformed || count != m_wanted) return std::nullopt;
            m_linesPassed = lines;
            return Take(true, following);
        }
        at = following;
    }
    return std::nullopt;
}

bool RowReader::HasSameNumbers() const {
    // A line of a quoted text may have as many cells as a row. It seldom has a number wherever the row has one.
    for (size_t i = 0; i < m_numbersBefore.size(); i++) {
        if (m_numbersBefore[i] && KindOf(i) == CellKind::TEXT) return false;
    }
    return true;
}

/** Tries readings of quotes that were never escaped, until one gives the row its right number of cells. */
bool RowReader::ReadWithOddQuotes(size_t start, size_t end, bool mayBeOpen) {
    const auto data = m_cursor.data;
    const bool fits = (m_splitter.Split(data, start, end, Quotes::LENIENT) == m_wanted && !m_splitter.isOpen) ||
                      (m_splitter.MergeTornQuotes(data, m_wanted) == m_wanted && !m_splitter.isOpen) ||
                      (mayBeOpen && m_splitter.Split(data, start, end, Quotes::LITERAL) == m_wanted) ||
                      (mayBeOpen && m_splitter.Split(data, start, end, Quotes::LENIENT) == m_wanted);
    if (fits) {
        m_problems.Add(
            "QUOTES_REPAIRED",
            "A cell has unescaped quotes; the row was split to match the number of titles.",
            m_cursor.line);
    }
    return fits;
}

/** Joins a text cell that a raw newline has split. The pieces belong together if they then have the right number of cells. */
RowReader::Next RowReader::JoinedLines(size_t start, size_t newline, size_t secondLine) {
    const auto data = m_cursor.data;
    auto at = secondLine;
    // Without quotes, counting commas gives the number of cells, so nothing has to be split repeatedly.
    const auto countOf = [&](char byte, size_t from, size_t until) {
        const auto piece = m_cursor.Piece(from, until);
        return static_cast<size_t>(std::count(piece.begin(), piece.end(), byte));
    };
    auto commas = countOf(',', start, newline);
    auto quotes = countOf('"', start, newline);
    for (int64_t lines = 2; lines <= MAX_LINES; lines++) {
        const auto end = LineEndIn(data, at, m_cursor.End());
        if (end - start > MAX_BYTES || at == m_cursor.End() || (end < m_cursor.End() && data[end] == '\0')) return std::nullopt;
        if (IsCompleteRow(at, end)) return std::nullopt;
        commas += countOf(',', at, end);
        quotes += countOf('"', at, end);
        auto count = commas + 1;
        if (quotes > 0 || count >= m_wanted) {
            count = m_splitter.Split(data, start, end, Quotes::LENIENT);
            if (count > m_wanted || m_splitter.isOpen) return std::nullopt;
        }
        const auto after = AfterLineEnd(data, end);
        if (count == m_wanted) {
            if (!IsTextTornAt(newline, secondLine)) return std::nullopt;
            m_linesPassed = lines;
            m_problems.Add(
                "LINES_JOINED",
                "A newline in a text split the row into " + std::to_string(lines) + " lines; they were joined.", m_cursor.line);
            Take(false, after);
            if (end == m_cursor.End() && m_endsInNewline) DropLastCell();
            return after;
        }
        at = after;
    }
    return std::nullopt;
}

bool RowReader::IsTextTornAt(size_t newline, size_t following) const {
    // Two short rows of numbers could also be joined, but a newline is never inside a number.
    for (const auto& place : m_splitter.places) {
        if (place.start > newline || newline > place.end) continue;
        const auto rest = std::min(following, place.end);
        const auto isText = [&](size_t from, size_t until) { return ReadCell(m_cursor.Piece(from, until)).kind == CellKind::TEXT; };
        return isText(place.start, newline) || isText(rest, LineEndIn(m_cursor.data, rest, place.end));
    }
    return false;
}

/** Handles a piece of the last topic's text that a raw newline split off. It is a line of one text, where a number should be. */
bool RowReader::ContinuesText(size_t start, size_t end) {
    const auto piece = m_cursor.Piece(start, end);
    const bool isPiece = m_wanted > 1 && !m_columns.front().HasText() && piece.find(',') == std::string_view::npos &&
                         !IsEndOfRow(piece) && ReadCell(piece).kind == CellKind::TEXT &&
                         m_columns.back().ExtendText(rowCount - 1, piece, MAX_BYTES);
    if (isPiece) m_problems.Add("LINES_JOINED", "A line of text was joined to the text in the row above it.", m_cursor.line);
    return isPiece;
}

bool RowReader::IsCompleteRow(size_t start, size_t until) {
    return m_wanted > 1 && m_splitter.Split(m_cursor.data, start, until, Quotes::STRICT) == m_wanted && m_splitter.IsProper();
}

/** Takes a row with too few or too many cells in every reading. */
size_t RowReader::TakeUneven(size_t start, size_t end, size_t following) {
    auto count = m_splitter.Split(m_cursor.data, start, end, Quotes::STRICT);
    const bool isStrict = m_splitter.IsProper();
    if (!isStrict) count = m_splitter.Split(m_cursor.data, start, end, Quotes::LENIENT);
    const auto cells = std::to_string(count);
    const auto wanted = std::to_string(m_wanted);
    if (count < m_wanted) {
        m_problems.Add("ROW_SHORT", "A row has " + cells + " of " + wanted + " cells; the missing ones were left empty.", m_cursor.line);
    } else {
        const auto extra = Quotation(count > m_wanted ? m_splitter.places[m_wanted].start : end, end);
        m_problems.Add(
            "ROW_LONG", "A row has " + cells + " cells instead of " + wanted + "; the extra ones were dropped: " + extra + ".",
            m_cursor.line);
    }
    return Take(isStrict, following);
}

/**
 * Reads a row without a newline, at the end of the file or before a hole. `isCut` says whether a missing newline means that bytes are
 * missing.
 */
size_t RowReader::Tail(size_t start, size_t until, bool isCut) {
    m_linesPassed = 1;
    const auto count = m_splitter.Split(m_cursor.data, start, until, Quotes::STRICT);
    bool isOpen = m_splitter.isOpen;
    const bool isStrict = !m_splitter.isMalformed;
    if (!isStrict) {
        if (ReadWithOddQuotes(start, until, false)) {
            Take(false, until);
            if (isCut) DropLastCell();
            return until;
        }
        // As in core, the last reading decides.
        isOpen = m_splitter.isOpen;
    }
    if (isOpen || count < m_wanted) {
        m_problems.Add(
            "ROW_CUT",
            "A row is cut off after " + std::to_string(count) + " of " + std::to_string(m_wanted) + " cells and was dropped; it held " +
                Quotation(start, until) + ".",
            m_cursor.line);
        return until;
    }
    if (!isStrict || count > m_wanted) return TakeUneven(start, until, until);
    Take(true, until);
    if (isCut) DropLastCell();
    return until;
}

void RowReader::DropLastCell() {
    m_row->back() = Cell{};
    const auto& place = m_splitter.places[m_wanted - 1];
    m_problems.Add(
        "LAST_CELL_CUT",
        "The last row lacks its newline, so its last cell may be cut and was left empty; it held " + Quotation(place.start, place.end) + ".",
        m_cursor.line, m_columns.back().Name());
}

/** Makes a row of the cells that the splitter found. Missing cells are empty, and extra ones are dropped. */
size_t RowReader::Take(bool undouble, size_t following) {
    auto& row = m_row.emplace(m_wanted);
    for (size_t i = 0; i < std::min(m_wanted, m_splitter.places.size()); i++) row[i] = CellOf(i, undouble);
    return following;
}

Cell RowReader::CellOf(size_t index, bool undouble) const {
    const auto& place = m_splitter.places[index];
    const auto held = m_cursor.Piece(place.start, place.end);
    const bool mayHaveComma = place.isQuoted && m_columns[index].ReadsDecimalComma() && held.find(',') != std::string_view::npos;
    if (mayHaveComma) {
        if (const auto number = ReadDecimal(held, ',')) return {CellKind::DECIMAL_COMMA, *number};
    }
    auto cell = ReadCell(held);
    if (cell.kind == CellKind::TEXT) cell.text = undouble && place.isQuoted ? Replaced(held, "\"\"", "\"") : std::string{held};
    return cell;
}

CellKind RowReader::KindOf(size_t index) const {
    const auto& place = m_splitter.places[index];
    return ReadCell(m_cursor.Piece(place.start, place.end)).kind;
}

std::string RowReader::Quotation(size_t start, size_t until) const {
    return "“" + Excerpt(m_cursor.Piece(start, until), QUOTED_BYTES) + "”";
}

size_t RowReader::GiveUp(std::string_view kind, std::string message) {
    gaveUp = true;
    m_problems.Add(kind, std::move(message), m_cursor.line);
    return m_cursor.End();
}

}  // namespace badlog::reader
