#include "FirstLines.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "Cell.h"
#include "RowSplitter.h"

namespace badlog::reader {
namespace {

constexpr size_t ROWS = 20;  // the number of rows that are examined
constexpr size_t MAX_BYTES = 1 << 20;
constexpr size_t CLEARLY = 3;
constexpr size_t MIN_ROWS = 3;  // this many rows of one width count more than the titles

// Among random bytes, every ninth is a control character. In a text with a few damaged places, fewer than one in this many.
constexpr size_t MIN_TEXT = 20;
constexpr size_t MIN_CONTROLS = 16;

FirstLines::Line LineOf(std::string_view data, size_t start, size_t end, size_t following) {
    RowSplitter splitter;
    const auto count = splitter.Split(data, start, end, Quotes::STRICT);
    size_t texts = 0;
    size_t empty = 0;
    for (const auto& place : splitter.places) {
        const auto kind = ReadCell(data.substr(place.start, place.end - place.start)).kind;
        texts += kind == CellKind::TEXT;
        empty += kind == CellKind::EMPTY;
    }
    const bool isRow = splitter.IsProper() && !HasControls(data.substr(start, end - start));
    return {start, end, following, isRow ? count : 0, count - empty - texts, texts};
}

}  // namespace

bool HasControls(std::string_view line) {
    return std::any_of(line.begin(), line.end(), [](char byte) { return byte > 0 && byte < ' ' && byte != '\t'; });
}

FirstLines::FirstLines(const Cursor& cursor) {
    const auto data = cursor.data;
    const auto limit = std::min(cursor.End(), cursor.start + MAX_BYTES);
    auto at = cursor.start;
    for (size_t rows = 0; rows <= ROWS;) {
        const auto end = LineEndIn(data, at, limit);
        if (end == limit) break;
        const auto following = AfterLineEnd(data, end);
        if (end > at) {
            lines.push_back(LineOf(data, at, end, following));
            if (lines.back().cells > 0) rows++;
        }
        // After a line that ends at a NUL, go on from that NUL.
        at = following == end ? end + 1 : following;
    }
    const auto lookedAt = cursor.Piece(cursor.start, at);
    const auto controls = static_cast<size_t>(std::count_if(lookedAt.begin(), lookedAt.end(), [](char byte) {
        return byte > 0 && byte < ' ' && byte != '\t' && byte != '\n' && byte != '\r';
    }));
    isBinary = controls >= MIN_CONTROLS && controls * MIN_TEXT > lookedAt.size();
    FindWidth();
}

void FirstLines::FindWidth() {
    std::vector<Line> rows;
    std::copy_if(lines.begin() + (lines.empty() ? 0 : 1), lines.end(), std::back_inserter(rows), [](const Line& line) { return line.cells > 0; });
    // A piece of the titles, split off by damage, has no numbers.
    const auto hasNumbers = [](const Line& line) { return line.numbers > 0; };
    if (std::any_of(rows.begin(), rows.end(), hasNumbers)) {
        rows.erase(std::remove_if(rows.begin(), rows.end(), [&](const Line& line) { return !hasNumbers(line); }), rows.end());
    }
    std::map<size_t, size_t> counts;
    for (const auto& row : rows) counts[row.cells]++;
    if (!counts.empty()) {
        // Of equally frequent widths, the greater one counts.
        auto best = counts.begin();
        for (auto count = counts.begin(); count != counts.end(); count++) {
            if (count->second >= best->second) best = count;
        }
        const auto own = counts.find(lines[0].cells);
        width = own != counts.end() && own->second * CLEARLY >= best->second ? lines[0].cells : best->first;
    }
    const auto numeric = static_cast<size_t>(
        std::count_if(rows.begin(), rows.end(), [&](const Line& row) { return row.cells == width && row.numbers > 0; }));
    const auto enough = std::min<size_t>(2, lines.empty() ? 0 : lines.size() - 1);
    hasRows = width > 0 && numeric >= enough && (width > 1 || numeric * 2 >= lines.size());
}

size_t FirstLines::ClearWidth(size_t names) const {
    const auto ofWidth = std::count_if(lines.begin() + (lines.empty() ? 0 : 1), lines.end(), [&](const Line& line) { return line.cells == width; });
    return width == names || static_cast<size_t>(ofWidth) >= MIN_ROWS ? width : 0;
}

size_t FirstLines::RestOfTitles(size_t following, size_t cells) const {
    auto end = following;
    for (size_t i = 1; i < lines.size(); i++) {
        const auto& line = lines[i];
        if (line.cells == cells || line.numbers > 0 || line.following <= line.end) break;
        end = line.following;
    }
    return end;
}

}  // namespace badlog::reader
