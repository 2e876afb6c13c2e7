#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace badlog::reader {

/** The readings of quotes. */
enum class Quotes {
    /** RFC 4180: a quote opens at a cell's start, closes at the next single quote; doubled ones stand for one. */
    STRICT,
    /** A quote opens at a cell's start and closes only before a comma or the end. The original never doubled quotes. */
    LENIENT,
    /** A quote is a character like any other. */
    LITERAL,
};

/** The cells that Split found last. */
class RowSplitter {
public:
    /** A cell without its quotes, and whether it had some. */
    struct Place {
        size_t start;
        size_t end;
        bool isQuoted;
    };

    std::vector<Place> places;
    /** Whether the bytes ended inside quotes. */
    bool isOpen = false;
    /** Whether there was a quote where RFC 4180 allows none. */
    bool isMalformed = false;

    bool IsProper() const { return !isOpen && !isMalformed; }

    /** Splits the bytes, which have no line end outside quotes. Returns the number of cells. */
    size_t Split(std::string_view data, size_t start, size_t until, Quotes quotes);

    /**
     * Joins cells that were split at a quote and a comma inside one text. In `"he said "a", ok"`, a cell that ends in a
     * quote without having begun with one belongs to the quoted cell before it. Stops at `wanted` cells; returns the number
     * of cells.
     */
    size_t MergeTornQuotes(std::string_view data, size_t wanted);

private:
    size_t PlainCell(std::string_view data, size_t start, size_t until);
    size_t QuotedCell(std::string_view data, size_t start, size_t until, Quotes quotes);
};

}  // namespace badlog::reader
