#include "HeaderReader.h"

#include <algorithm>

#include "RowSplitter.h"
#include "Text.h"
#include "Utf8.h"

namespace badlog::reader {
namespace {

constexpr size_t MAX_LINE_BYTES = 1 << 24;  // a file without a newline before that is not a bag
constexpr size_t MAX_COLUMNS = 1 << 16;     // each column costs memory before it has a row
constexpr std::string_view BYTE_ORDER_MARK = "\xEF\xBB\xBF";
constexpr const char* UTF_16 = "The file is UTF-16, like Excel's “Unicode text”; save it again as CSV UTF-8.";

std::string Binary() {
    return std::string{NOT_A_LOG} + ": it has bytes that never occur in text.";
}

bool StartsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

bool IsControl(char byte) {
    return static_cast<unsigned char>(byte) < ' ' && byte != '\t';
}

/** Returns whether a line is a piece of the line of JSON. It then has the characters between a key and its value, which no title has. */
bool IsRestOfJson(std::string_view line) {
    return line.find("\":\"") != std::string_view::npos || line.find("\":[") != std::string_view::npos;
}

}  // namespace

size_t HeaderReader::Read() {
    if (m_isAtSignature) {
        m_isAtSignature = false;
        return ReadSignature();
    }
    const auto lineEnd = LineEndIn(m_cursor.data, m_cursor.start, m_cursor.End());
    if (lineEnd - m_cursor.start > MAX_LINE_BYTES) return Refuse(Binary());
    const auto following = AfterLineEnd(m_cursor.data, lineEnd);
    if (lineEnd == m_cursor.start) return m_cursor.PassBlankLine(lineEnd, following, m_problems);
    if (m_isAtFirstLine) {
        m_isAtFirstLine = false;
        return TakeFirstLine(lineEnd, following);
    }
    return TakeTitles(lineEnd, following);
}

size_t HeaderReader::ReadSignature() {
    const auto seen = m_cursor.data.substr(m_cursor.start, 6);
    if (StartsWith(seen, "\x1f\x8b")) return Refuse("The file is compressed with gzip and has to be inflated first.");
    if (seen == "WPILOG") return Refuse("This is a WPILOG file, not a bag.");
    m_mayBeUtf16 = StartsWith(seen, "\xff\xfe") || StartsWith(seen, "\xfe\xff");
    if (m_mayBeUtf16 && seen.find('\0') != std::string_view::npos) return Refuse(UTF_16);
    if (!StartsWith(seen, BYTE_ORDER_MARK)) return m_cursor.start;
    m_problems.Add("BYTE_ORDER_MARK", "The file begins with a byte order mark, which was skipped.", 1);
    return m_cursor.start + BYTE_ORDER_MARK.size();
}

size_t HeaderReader::TakeFirstLine(size_t lineEnd, size_t following) {
    if (m_cursor.data[m_cursor.start] != '{') return m_cursor.start;
    hasLine = true;
    const auto text = Decode(m_cursor.Piece(m_cursor.start, lineEnd), m_sawOtherText);
    ReportEncoding();
    header = ReadHeader(text);
    if (!header) {
        ReportUnreadable(
            "Line " + std::to_string(m_cursor.line) +
            " is cut or is not JSON, so units, attributes and values are lost; the rest was read as CSV.");
    }
    if (following > lineEnd) m_cursor.line++;
    return following;
}

size_t HeaderReader::TakeTitles(size_t lineEnd, size_t following) {
    const bool isCut = following == lineEnd;
    const auto line = m_cursor.Piece(m_cursor.start, lineEnd);
    if (hasLine && !header) {
        // The rest of a line of JSON after a hole is not the line of titles.
        const bool isRest = !m_cursor.IsAfterHole() && IsRestOfJson(line);
        if (isRest) {
            ReportUnreadable("Line " + std::to_string(m_cursor.line) + " is part of the JSON line before it; it was skipped.");
        }
        if (isRest || m_cursor.IsAfterHole()) {
            if (!isCut) m_cursor.line++;
            return following;
        }
    }
    const auto count = static_cast<size_t>(std::count(line.begin(), line.end(), ',')) + 1;
    if (count > MAX_COLUMNS) {
        return Refuse(
            "Line " + std::to_string(m_cursor.line) + " has " + std::to_string(count) + " titles; a log has at most " +
            std::to_string(MAX_COLUMNS) + " topics.");
    }
    const auto titles = Titles(lineEnd, header ? header->Names() : Names{});
    isDone = true;
    return header ? TakeWithHeader(titles, following, isCut) : TakeWithoutHeader(titles, lineEnd, following);
}

size_t HeaderReader::TakeWithHeader(const Names& titles, size_t following, bool isCut) {
    ReportEncoding();
    const auto names = header->Names();
    std::optional<FirstLines> firstLines;
    if (!HaveSameNames(titles, names)) firstLines.emplace(m_cursor);
    const auto width = firstLines ? firstLines->ClearWidth(names.size()) : 0;
    const bool isNone = !names.empty() && std::none_of(titles.begin(), titles.end(), [&](const std::string& title) {
        return std::find(names.begin(), names.end(), title) != names.end();
    });
    // Line 2 may be lost, to a hole or to damage: then this is a row.
    const bool fits = firstLines && names.size() == width && titles.size() == width && firstLines->lines[0].numbers > 0;
    const bool isRow = isNone && (m_cursor.holeLine > 0 || fits);
    // The line of JSON is more reliable than a line of titles that is cut.
    const bool isOnlyNames = isRow || (isCut && !names.empty() && width == 0);
    columns = ColumnsOf(isOnlyNames ? ColumnTitles::Certain(names) : ColumnTitles::Of(names, titles, width), titles);
    const bool isUneven = width > 0 && titles.size() != width;
    const auto end = isUneven && !isCut && !isRow ? firstLines->RestOfTitles(following, width) : following;
    if (m_cursor.holeLine == 0 && !isCut && (isRow || (isUneven && names.size() == width))) {
        m_problems.Add(
            "TITLES_DAMAGED",
            "Line " + std::to_string(m_cursor.line) + " does not have a title for each of the " + std::to_string(width) +
                " cells of a row; the names of line 1 were used.",
            m_cursor.line);
    }
    if (isRow) return m_cursor.start;
    if (!isCut) m_cursor.line++;
    m_cursor.line += LinesIn(following, end);
    return end;
}

size_t HeaderReader::TakeWithoutHeader(const Names& titles, size_t lineEnd, size_t following) {
    const FirstLines firstLines{m_cursor};
    const auto width = firstLines.ClearWidth(0);
    const bool isDamaged = width > 1 && titles.size() != width;
    const bool mayBeBinary = m_mayBeUtf16 || HasControls(m_cursor.Piece(m_cursor.start, lineEnd));
    if (firstLines.isBinary || (mayBeBinary && !firstLines.hasRows)) return Refuse(m_mayBeUtf16 ? UTF_16 : Binary());
    ReportEncoding();
    if (titles.size() == 1) {
        if (const auto message = OtherSeparator(titles[0], firstLines, width)) return Refuse(*message);
    }
    const auto& lines = firstLines.lines;
    if (isDamaged && firstLines.hasRows) {
        // Damage, or remarks of the file's author, may come before the titles.
        const auto begin = std::find_if(lines.begin(), lines.end(), [&](const auto& line) { return line.cells == width; });
        if (begin != lines.end() && begin->IsTitles()) return SkipTo(*begin, lines[0].end);
    }
    if (!lines.empty() && titles.size() == width && (lines[0].texts == 0 || (hasLine && lines[0].numbers > 0))) return TakeUntitled(width);
    auto known = isDamaged ? ColumnTitles::Of({}, titles, width) : ColumnTitles::Certain(titles);
    // A hole destroyed the rest of the line, which may have had more titles.
    if (following == lineEnd && firstLines.hasRows) known.isDoubtful.assign(known.titles.size(), true);
    for (size_t i = 0; i < known.titles.size(); i++) {
        auto& title = known.titles[i];
        if (std::any_of(title.begin(), title.end(), IsControl)) known.isDoubtful[i] = true;
        std::replace_if(title.begin(), title.end(), IsControl, ' ');
    }
    columns = ColumnsOf(known, titles);
    if (following > lineEnd) m_cursor.line++;
    const auto end = isDamaged && following > lineEnd ? firstLines.RestOfTitles(following, width) : following;
    m_cursor.line += LinesIn(following, end);
    return end;
}

size_t HeaderReader::TakeUntitled(size_t width) {
    m_problems.Add(
        "TITLES_DAMAGED",
        "Line " + std::to_string(m_cursor.line) + " has values in place of titles; the columns are named by number.",
        m_cursor.line);
    columns = HeaderColumns::Match(Header(), Names(width), m_cursor.line, m_problems);
    return m_cursor.start;
}

size_t HeaderReader::SkipTo(const FirstLines::Line& titles, size_t firstEnd) {
    if (m_cursor.Piece(m_cursor.start, firstEnd).find("\"name\":") != std::string_view::npos) hasLine = true;
    ReportUnreadable(
        "Line " + std::to_string(m_cursor.line) + " is not the start of a bag or CSV file; it was skipped.");
    m_cursor.line += LinesIn(m_cursor.start, titles.start);
    isDone = false;
    return titles.start;
}

HeaderColumns HeaderReader::ColumnsOf(const ColumnTitles& known, const Names& titles) {
    const auto line = m_cursor.line;
    auto matched = HeaderColumns::Match(Header(), known.titles, line, m_problems);
    for (size_t i = 0; i < known.titles.size(); i++) {
        if (!known.isDoubtful[i]) continue;
        const auto& name = matched.names[i];
        const bool isOther = i < titles.size() && titles[i] != name;
        const auto reason =
            isOther ? "line " + std::to_string(line) + " has “" + titles[i] + "” there" : std::string{"the title line is damaged"};
        m_problems.Add(
            "NAME_IN_DOUBT",
            "Column " + std::to_string(i + 1) + " is shown as “" + name + "”, which may be wrong: " + reason + ".", line, name);
    }
    return matched;
}

std::optional<std::string> HeaderReader::OtherSeparator(
    const std::string& title, const FirstLines& firstLines, size_t width) const {
    const auto& lines = firstLines.lines;
    const auto rows = lines.begin() + (lines.empty() ? 0 : 1);
    for (const auto& [separator, name] : {std::pair{';', "semicolons"}, std::pair{'\t', "tabs"}}) {
        const char byte = separator;
        const auto wanted = std::count(title.begin(), title.end(), byte);
        if (wanted == 0) continue;
        const auto countIn = [&](const FirstLines::Line& line) {
            const auto piece = m_cursor.Piece(line.start, line.end);
            return std::count(piece.begin(), piece.end(), byte);
        };
        // Decimal commas split the cells of such rows.
        const bool isOther = width > 1
            ? std::all_of(rows, lines.end(), [&](const auto& line) { return countIn(line) == wanted; })
            : rows == lines.end() || countIn(*rows) > 0;
        if (isOther) {
            return std::string{"The columns are separated by "} + name + "; save the file again as CSV with commas.";
        }
    }
    return std::nullopt;
}

Names HeaderReader::Titles(size_t lineEnd, const Names& names) {
    m_sawOtherText = false;
    // The original does not quote names, so only the line of JSON shows that a name has a comma.
    if (names.size() > 1) {
        std::string joined;
        for (const auto& name : names) joined += (&name == names.data() ? "" : ",") + name;
        if (Decode(m_cursor.Piece(m_cursor.start, lineEnd), m_sawOtherText) == joined) return names;
    }
    RowSplitter splitter;
    splitter.Split(m_cursor.data, m_cursor.start, lineEnd, Quotes::STRICT);
    Names titles;
    for (const auto& place : splitter.places) {
        const auto title = Decode(m_cursor.Piece(place.start, place.end), m_sawOtherText);
        titles.push_back(place.isQuoted ? Replaced(title, "\"\"", "\"") : std::string{Trimmed(title)});
    }
    return titles;
}

int64_t HeaderReader::LinesIn(size_t start, size_t until) const {
    int64_t lines = 0;
    for (auto i = start; i < until; i++) {
        const bool isLoneReturn = m_cursor.data[i] == '\r' && (i + 1 == m_cursor.End() || m_cursor.data[i + 1] != '\n');
        if (m_cursor.data[i] == '\n' || isLoneReturn) lines++;
    }
    return lines;
}

void HeaderReader::ReportUnreadable(std::string message) {
    m_problems.Add("HEADER_UNREADABLE", std::move(message), m_cursor.line);
}

void HeaderReader::ReportEncoding() {
    if (m_sawOtherText) m_problems.Add("NOT_UTF8", "The header is not UTF-8; it was read as Windows-1252.", m_cursor.line);
}

size_t HeaderReader::Refuse(std::string message) {
    m_problems.Add("NOT_A_RECORDING", std::move(message), m_cursor.line);
    isDone = true;
    isNotLog = true;
    return m_cursor.End();
}

}  // namespace badlog::reader
