#include <optional>
#include <string>
#include <vector>

#include "Column.h"
#include "Cursor.h"
#include "HeaderReader.h"
#include "ProblemList.h"
#include "RowReader.h"
#include "badlog/Recording.h"

namespace badlog {
namespace reader {
namespace {

std::vector<Column> ColumnsOf(const HeaderColumns& layout) {
    std::vector<Column> columns;
    for (size_t i = 0; i < layout.names.size(); i++) {
        const auto topic = layout.topics[i] != nullptr ? *layout.topics[i] : BagTopic{};
        columns.emplace_back(layout.names[i], topic.unit, topic.attributes);
    }
    return columns;
}

bool IsProse(const RecordedTopic& topic) {
    return topic.counts.Kind() == TopicKind::EMPTY || topic.counts.texts + topic.counts.empty == topic.counts.Total();
}

void ReportEmptiness(const HeaderReader& header, const Recording& recording, ProblemList& problems) {
    if (!header.hasLine && recording.topics.empty()) {
        problems.Add("EMPTY_FILE", "The file is empty; the robot may have been switched off too early.");
    } else if (recording.rowCount == 0) {
        problems.Add("NO_ROWS", "There is a header but no row of samples; the robot may have been switched off too early.");
    }
}

}  // namespace
}  // namespace reader

Recording ReadBag(std::string_view bytes) {
    using namespace reader;
    Cursor cursor{bytes};
    ProblemList problems;
    HeaderReader header{cursor, problems};
    std::vector<Column> columns;
    std::optional<RowReader> rows;
    while (cursor.PassHole(problems)) {
        if (header.isDone && header.columns && !rows) {
            columns = ColumnsOf(*header.columns);
            rows.emplace(cursor, columns, problems, header.hasLine);
        }
        const bool isOver = header.isDone && (!rows || rows->gaveUp);
        cursor.AdvanceTo(isOver ? cursor.End() : header.isDone ? rows->Read() : header.Read());
    }

    if (!header.columns) {
        // Without a line of titles there are no rows, but the line of JSON may still list the topics.
        const auto names = header.header ? header.header->Names() : Names{};
        header.columns = HeaderColumns::Match(header.Header(), names, cursor.line, problems);
    }
    if (!rows) columns = ColumnsOf(*header.columns);
    Recording recording;
    recording.isBag = header.hasLine;
    recording.rowCount = rows ? rows->rowCount : 0;
    if (header.header) recording.values = header.header->values;
    for (const auto place : header.columns->order) recording.topics.push_back(columns[place].Finish(problems));
    const bool ignoresTheRest = header.isNotLog || (rows && rows->gaveUp);
    if (cursor.sawCarriageReturn && !ignoresTheRest) {
        problems.Add("CARRIAGE_RETURNS", "Lines end in a carriage return, as on Windows; that is fine.");
    }
    if (!header.header && recording.topics.size() == 1 && recording.rowCount > 0 && IsProse(recording.topics[0])) {
        problems.Add("NOT_A_RECORDING", std::string{NOT_A_LOG} + ": it is text without columns of numbers.", 1);
        recording = {};
    } else if (!ignoresTheRest) {
        ReportEmptiness(header, recording, problems);
    }
    recording.problems = problems.ToList();
    return recording;
}

}  // namespace badlog
