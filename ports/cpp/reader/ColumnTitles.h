#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "BagHeader.h"
#include "ProblemList.h"

namespace badlog::reader {

using Names = std::vector<std::string>;

/** Whether two lists have the same names, each as often, in any order. */
bool HaveSameNames(Names one, Names other);

/** A title for each column, and whether it may be another's. */
struct ColumnTitles {
    Names titles;
    std::vector<bool> isDoubtful;

    static ColumnTitles Certain(const Names& titles) { return {titles, std::vector<bool>(titles.size(), false)}; }
    static ColumnTitles Doubtful(const Names& titles) { return {titles, std::vector<bool>(titles.size(), true)}; }

    /**
     * The titles where line 1 has these names, line 2 has these titles, and the rows have `width` cells, or 0 if that is not
     * known. Line 1 wins if it has that many.
     */
    static ColumnTitles Of(const Names& names, const Names& titles, size_t width);
};

/** How the topics of line 1 and the columns of line 2 belong together. */
struct HeaderColumns {
    /** The name of each column, unique, in the order of line 2. */
    Names names;
    /** For each column, its topic of line 1, or null. */
    std::vector<const BagTopic*> topics;
    /** The columns in the order in which they are shown: that of line 1, then those it does not name. */
    std::vector<size_t> order;

    /** Matches by name, the first of equal names to the first; `header` may be null. */
    static HeaderColumns Match(const BagHeader* header, const Names& titles, int64_t line, ProblemList& problems);
};

}  // namespace badlog::reader
