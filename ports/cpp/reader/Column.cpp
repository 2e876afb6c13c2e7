#include "Column.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "Text.h"

namespace badlog {

TopicKind CellCounts::Kind() const {
    const auto numeric = numbers + notFinite + truthValues;
    if (numeric == 0 && texts == 0) return TopicKind::EMPTY;
    if (texts > numeric) return texts * 2 >= Total() ? TopicKind::STATE : TopicKind::EVENT;
    return truthValues == numeric ? TopicKind::BOOLEAN : TopicKind::NUMERIC;
}

bool CellCounts::IsSparse() const {
    const auto without = empty + texts;
    const auto with = Total() - without;
    return without > with && with < 2 * gaps;
}

namespace reader {
namespace {

constexpr size_t QUOTED_BYTES = 60;

std::string Quoted(const std::string& name) {
    return "“" + name + "”";
}

}  // namespace

Column::Column(std::string name, std::string unit, std::vector<std::string> attributes)
    : m_readsDecimalComma{std::find(attributes.begin(), attributes.end(), "log") == attributes.end()} {
    m_topic.name = std::move(name);
    m_topic.unit = std::move(unit);
    m_topic.attributes = std::move(attributes);
}

void Column::Add(int64_t row, const Cell& cell, int64_t line) {
    auto& counts = m_topic.counts;
    m_topic.samples.push_back(cell.number);
    switch (cell.kind) {
        case CellKind::NUMBER:
            counts.numbers++;
            break;
        case CellKind::DECIMAL_COMMA:
            counts.numbers++;
            if (m_decimalCommas++ == 0) m_firstDecimalCommaLine = line;
            break;
        case CellKind::NOT_FINITE:
            counts.notFinite++;
            if (std::isnan(cell.number)) m_topic.writtenNans.push_back(row);
            break;
        case CellKind::TRUTH_VALUE:
            counts.truthValues++;
            break;
        case CellKind::EMPTY:
            counts.empty++;
            CountGap(row);
            break;
        case CellKind::TEXT: {
            counts.texts++;
            CountGap(row);
            bool wasNotUtf8 = false;
            m_topic.texts.emplace_back(row, Decode(cell.text, wasNotUtf8));
            if (wasNotUtf8 && m_notUtf8Line == 0) m_notUtf8Line = line;
            m_lastText = cell.text;
            if (!m_firstText) {
                m_firstText = Excerpt(cell.text, QUOTED_BYTES);
                m_firstTextLine = line;
            }
            break;
        }
    }
}

void Column::CountGap(int64_t row) {
    if (row != m_lastGapRow + 1) m_topic.counts.gaps++;
    m_lastGapRow = row;
}

bool Column::ExtendText(int64_t row, std::string_view more, size_t longest) {
    auto& texts = m_topic.texts;
    if (texts.empty() || texts.back().first != row || m_lastText.size() + 1 + more.size() > longest) return false;
    m_lastText += '\n';
    m_lastText += more;
    texts.back().second = Decode(m_lastText);
    return true;
}

RecordedTopic Column::Finish(ProblemList& problems) {
    const auto& counts = m_topic.counts;
    const auto& name = m_topic.name;
    if (m_notUtf8Line > 0) {
        problems.Add("NOT_UTF8", "Texts in " + Quoted(name) + " are not UTF-8; they were read as Windows-1252.", m_notUtf8Line, name);
    }
    if (m_decimalCommas > 0) {
        problems.Add(
            "DECIMAL_COMMA", "Numbers in " + Quoted(name) + " have a decimal comma; it was read as a point.", m_firstDecimalCommaLine, name,
            m_decimalCommas);
    }
    if (counts.notFinite > 0) {
        problems.Add(
            "NOT_FINITE",
            Quoted(name) + " is NaN or infinite in " + std::to_string(counts.notFinite) + " of " + std::to_string(counts.Total()) +
                " cells; these are kept, and drawn as gaps.",
            {}, name, counts.notFinite);
    }
    if (counts.truthValues > 0) {
        problems.Add(
            "TRUTH_VALUES", Quoted(name) + " holds true and false; they were read as 1 and 0.", {}, name, counts.truthValues);
    }
    const auto kind = counts.Kind();
    if (kind == TopicKind::NUMERIC || kind == TopicKind::BOOLEAN) {
        if (counts.texts > 0 && m_readsDecimalComma) {
            problems.Add(
                "TEXT_IN_NUMBERS",
                Quoted(name) + " has text, such as " + Quoted(m_firstText.value_or("")) + ", in " + std::to_string(counts.texts) + " of " +
                    std::to_string(counts.Total()) + " cells; these are gaps.",
                m_firstTextLine, name, counts.texts);
        }
        if (counts.empty > 0 && !counts.IsSparse()) {
            problems.Add(
                "EMPTY_CELLS", Quoted(name) + " is empty in " + std::to_string(counts.empty) + " of " + std::to_string(counts.Total()) + " cells.",
                {}, name, counts.empty);
        }
    }
    return std::move(m_topic);
}

}  // namespace reader
}  // namespace badlog
