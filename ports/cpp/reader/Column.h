#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "Cell.h"
#include "ProblemList.h"
#include "badlog/Recording.h"

namespace badlog::reader {

/** One column while its file is read: its numbers, its texts, and counts of oddities. */
class Column {
public:
    Column(std::string name, std::string unit, std::vector<std::string> attributes);

    const std::string& Name() const { return m_topic.name; }
    /** False for a topic of texts, in which `1,5` may be meant literally. */
    bool ReadsDecimalComma() const { return m_readsDecimalComma; }
    bool HasText() const { return m_firstText.has_value(); }

    /** Adds the cell in a row, which is on a line. */
    void Add(int64_t row, const Cell& cell, int64_t line);
    /**
     * Adds a line to the text in the last row. Returns false if that cell is not a text, or would become too
     * long.
     */
    bool ExtendText(int64_t row, std::string_view more, size_t longest);

    /** Returns the topic made of all rows, and reports the column's oddities. Call it once, last. */
    RecordedTopic Finish(ProblemList& problems);

private:
    void CountGap(int64_t row);

    RecordedTopic m_topic;
    bool m_readsDecimalComma;
    std::optional<std::string> m_firstText;
    int64_t m_firstTextLine = 0;
    /** The bytes of the last text, as they are in the file. */
    std::string m_lastText;
    int64_t m_notUtf8Line = 0;
    int64_t m_firstDecimalCommaLine = 0;
    int64_t m_decimalCommas = 0;
    int64_t m_lastGapRow = -2;
};

}  // namespace badlog::reader
