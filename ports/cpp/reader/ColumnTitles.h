#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "BagHeader.h"
#include "ProblemList.h"

namespace badlog::reader {

using Names = std::vector<std::string>;

/** Returns whether two lists have the same names, each equally often, in any order. */
bool HaveSameNames(Names one, Names other);

/** A title for each column, and whether it may belong to another column. */
struct ColumnTitles {
    Names titles;
    std::vector<bool> isDoubtful;

    static ColumnTitles Certain(const Names& titles) { return {titles, std::vector<bool>(titles.size(), false)}; }
    static ColumnTitles Doubtful(const Names& titles) { return {titles, std::vector<bool>(titles.size(), true)}; }

    /**
     * Returns the titles for these names on line 1, these titles on line 2, and rows of `width` cells. A `width` of 0 is
     * not known. Line 1 wins if it has that many names.
     */
    static ColumnTitles Of(const Names& names, const Names& titles, size_t width);
};

/** The columns of line 2, matched with the topics of line 1. */
struct HeaderColumns {
    /** The name of each column, unique, in the order of line 2. */
    Names names;
    /** For each column, its topic of line 1, or null. */
    std::vector<const BagTopic*> topics;
    /** The columns in display order: first in the order of line 1, then those that line 1 does not name. */
    std::vector<size_t> order;

    /** Matches by name, the first of equal names to the first; `header` may be null. */
    static HeaderColumns Match(const BagHeader* header, const Names& titles, int64_t line, ProblemList& problems);
};

}  // namespace badlog::reader
