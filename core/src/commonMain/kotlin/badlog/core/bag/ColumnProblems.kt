package badlog.core.bag

import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.core.recording.addNotFinite
import badlog.core.recording.addNotUtf8
import badlog.core.recording.addRounded

/** Reports the oddities of a column once, after all of it was read. */
internal fun reportColumn(column: ColumnBuilder, topic: Topic, problems: ProblemList) {
    val counts = topic.counts
    val name = topic.name
    if (column.notUtf8Line > 0) problems.addNotUtf8(name, column.notUtf8Line)
    if (column.decimalCommas > 0) {
        problems.add(
            ProblemKind.DECIMAL_COMMA,
            "Numbers in “$name” have a decimal comma; it was read as a point.",
            column.firstDecimalCommaLine,
            name,
            column.decimalCommas,
        )
    }
    if (column.roundedCount > 0) problems.addRounded(name, column.roundedCount)
    problems.addNotFinite(topic, "cells")
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
            "“${topic.name}” has text, such as “${column.firstText}”, in ${counts.texts} of ${counts.total} cells; these are gaps.",
            column.firstTextLine,
            topic.name,
            counts.texts,
        )
    }
    if (counts.empty > 0 && !topic.isSparse) {
        problems.add(
            ProblemKind.EMPTY_CELLS,
            "“${topic.name}” is empty in ${counts.empty} of ${counts.total} cells.",
            topic = topic.name,
            count = counts.empty,
        )
    }
}
