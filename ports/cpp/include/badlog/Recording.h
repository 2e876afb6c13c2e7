#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace badlog {

/** The kinds of topics, by the content of their cells; docs/bag-format.md has the rule. */
enum class TopicKind { EMPTY, NUMERIC, BOOLEAN, STATE, EVENT };

/** The number of a topic's cells for each kind of content. */
struct CellCounts {
    int64_t numbers = 0;
    int64_t notFinite = 0;
    int64_t truthValues = 0;
    int64_t texts = 0;
    int64_t empty = 0;
    /** The number of runs of neighboring rows that have no number. */
    int64_t gaps = 0;

    int64_t Total() const { return numbers + notFinite + truthValues + texts + empty; }
    TopicKind Kind() const;
    /** Whether fewer than half of the rows have a number, mostly isolated ones: the topic's empty cells are not gaps. */
    bool IsSparse() const;
};

/** A named, united, attributed stream of samples, one for each row. All texts are UTF-8. */
struct RecordedTopic {
    /** Unique in its recording; `/` makes folders. */
    std::string name;
    /** As in the file; `ul` and the empty text mean none. */
    std::string unit;
    std::vector<std::string> attributes;
    CellCounts counts;
    /** For each row its number, with true as 1 and false as 0; NaN if there is none. */
    std::vector<double> samples;
    /** The row, from 0, and the text of each cell that holds a text. */
    std::vector<std::pair<int64_t, std::string>> texts;
    /** The rows in which NaN was written, as opposed to nothing. */
    std::vector<int64_t> writtenNans;
};

/** A name and a text that were known when the log began. */
struct RecordedValue {
    std::string name;
    std::string text;
};

/** Something that was wrong in a file, where, and how it was handled. */
struct Problem {
    /** Such as `ROW_CUT`; docs/bag-format.md lists all kinds with their severities. */
    std::string_view kind;
    /** One sentence. */
    std::string message;
    /** The physical line of the file, from 1. */
    std::optional<int64_t> line;
    /** The name of the topic concerned. */
    std::optional<std::string> topic;
    /** How often it occurred; line and message describe the first occurrence. */
    int64_t count = 1;
};

/** The content of one log: everything that could be kept, and the problems found. */
struct Recording {
    /** False for a plain CSV file, which has no units, attributes and values. */
    bool isBag = false;
    std::vector<RecordedValue> values;
    /** In the order in which they are shown. */
    std::vector<RecordedTopic> topics;
    int64_t rowCount = 0;
    std::vector<Problem> problems;
};

/**
 * Reads a bag or a CSV file from its bytes, which must not be compressed. Damage never stops it, but becomes a problem.
 * It does not apply attributes.
 */
Recording ReadBag(std::string_view bytes);

}  // namespace badlog
