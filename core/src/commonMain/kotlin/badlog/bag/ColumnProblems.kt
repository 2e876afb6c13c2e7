package badlog.bag

import badlog.recording.ProblemKind
import badlog.recording.ProblemList
import badlog.recording.Topic
import badlog.recording.TopicKind

/** Reports what was odd about a whole column, once, when all of it was read. */
internal fun reportColumn(column: ColumnBuilder, topic: Topic, problems: ProblemList) {
    val counts = topic.counts
    val name = topic.name
    if (column.notUtf8Line > 0) {
        problems.add(
            ProblemKind.NOT_UTF8,
            "Texts in “$name” are not UTF-8; they were read as Windows-1252.",
            column.notUtf8Line,
            name,
        )
    }
    if (column.decimalCommas > 0) {
        problems.add(
            ProblemKind.DECIMAL_COMMA,
            "Numbers in “$name” have a decimal comma; it was read as a point.",
            column.firstDecimalCommaLine,
            name,
            column.decimalCommas,
        )
    }
    if (counts.notFinite > 0) {
        problems.add(
            ProblemKind.NOT_FINITE,
            "${counts.notFinite} cells of “$name” are NaN or infinite; they are kept, and drawn as gaps.",
            topic = name,
            count = counts.notFinite,
        )
    }
    if (counts.truthValues > 0) {
        problems.add(
            ProblemKind.TRUTH_VALUES,
            "“$name” holds true and false; they were read as 1 and 0.",
            topic = name,
            count = counts.truthValues,
        )
    }
    if (topic.kind == TopicKind.NUMERIC || topic.kind == TopicKind.BOOLEAN) reportGaps(column, topic, problems)
}

private fun reportGaps(column: ColumnBuilder, topic: Topic, problems: ProblemList) {
    val counts = topic.counts
    if (counts.texts > 0 && column.readsDecimalComma) {
        problems.add(
            ProblemKind.TEXT_IN_NUMBERS,
            "${counts.texts} cells of “${topic.name}” are text, not numbers, such as “${column.firstText}”; " +
                "they are gaps.",
            column.firstTextLine,
            topic.name,
            counts.texts,
        )
    }
    if (counts.empty > 0 && !topic.isSparse) {
        problems.add(
            ProblemKind.EMPTY_CELLS,
            "${counts.empty} of ${counts.total} cells of “${topic.name}” are empty.",
            topic = topic.name,
            count = counts.empty,
        )
    }
}
