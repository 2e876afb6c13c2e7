#include "RowSplitter.h"

#include <algorithm>

namespace badlog::reader {
namespace {

/** Returns the first index of a byte in a range, or the end of the range. */
size_t Find(std::string_view data, char byte, size_t start, size_t until) {
    return std::min(data.substr(0, until).find(byte, start), until);
}

}  // namespace

size_t RowSplitter::Split(std::string_view data, size_t start, size_t until, Quotes quotes) {
    places.clear();
    isOpen = false;
    isMalformed = false;
    auto at = start;
    while (true) {
        const bool opens = quotes != Quotes::LITERAL && at < until && data[at] == '"';
        at = opens ? QuotedCell(data, at, until, quotes) : PlainCell(data, at, until);
        if (at >= until) break;
        at++;
        if (at == until) {
            places.push_back({at, at, false});
            break;
        }
    }
    return places.size();
}

size_t RowSplitter::PlainCell(std::string_view data, size_t start, size_t until) {
    const auto end = Find(data, ',', start, until);
    if (Find(data, '"', start, end) < end) isMalformed = true;
    places.push_back({start, end, false});
    return end;
}

size_t RowSplitter::QuotedCell(std::string_view data, size_t start, size_t until, Quotes quotes) {
    for (auto at = Find(data, '"', start + 1, until); at < until; at = Find(data, '"', at + 1, until)) {
        const char following = at + 1 < until ? data[at + 1] : ',';
        if (following == ',') {
            places.push_back({start + 1, at, true});
            return at + 1;
        }
        if (following == '"' && quotes == Quotes::STRICT) {
            at++;
        } else {
            isMalformed = true;
        }
    }
    isOpen = true;
    places.push_back({start + 1, until, true});
    return until;
}

size_t RowSplitter::MergeTornQuotes(std::string_view data, size_t wanted) {
    for (size_t i = 1; i < places.size() && places.size() > wanted;) {
        const auto& place = places[i];
        const bool isTornOff = !place.isQuoted && place.end > place.start && data[place.end - 1] == '"';
        auto opening = i;
        while (isTornOff && opening > 0 && !places[opening].isQuoted) opening--;
        if (opening < i && places[opening].isQuoted && places.size() - (i - opening) >= wanted) {
            places[opening].end = place.end - 1;
            const auto begin = places.begin();
            places.erase(begin + static_cast<std::ptrdiff_t>(opening) + 1, begin + static_cast<std::ptrdiff_t>(i) + 1);
            i = opening + 1;
        } else {
            i++;
        }
    }
    return places.size();
}

}  // namespace badlog::reader
