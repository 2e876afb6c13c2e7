package badlog.core.bag

import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.text.UniqueNames
import badlog.core.text.isLetterOrDigit

/**
 * The columns of line 2, matched with the topics of line 1.
 *
 * @property columnNames the name of each column, unique, in the order of line 2.
 * @property topics for each column, its topic of line 1, or null.
 * @property order the columns in display order: first in the order of line 1, then those that line 1 does not name.
 */
internal class HeaderColumns private constructor(val columnNames: List<String>, val topics: List<BagTopic?>, val order: List<Int>) {
    /** Returns the same columns, each with the topic that [describe] returns for its index. */
    fun describedBy(describe: (index: Int) -> BagTopic) = HeaderColumns(columnNames, columnNames.indices.map(describe), order)

    companion object {
        /**
         * Matches the topics of [header] with the column titles of line [line] by name. Equal names are matched in their order. A plain CSV
         * file has no header.
         */
        fun match(header: BagHeader?, titles: List<String>, line: Int, problems: ProblemList): HeaderColumns {
            val described = header?.topics.orEmpty()
            val waiting = described.indices.groupByTo(HashMap()) { described[it].name }
            val topicOfColumn = titles.map { title -> waiting[title]?.removeFirstOrNull() }
            for (index in waiting.values.flatten().sorted()) {
                val name = described[index].name
                problems.add(
                    ProblemKind.TOPIC_WITHOUT_COLUMN,
                    "The header describes “$name”, but line $line has no such column.",
                    line,
                    name,
                )
            }
            val names = uniqueNames(titles, line, problems)
            if (header != null) reportColumns(titles, names, topicOfColumn, line, problems)
            val order = titles.indices.sortedBy { topicOfColumn[it] ?: (described.size + it) }
            return HeaderColumns(names, topicOfColumn.map { index -> index?.let { described[it] } }, order)
        }

        private fun uniqueNames(titles: List<String>, line: Int, problems: ProblemList): List<String> {
            val given = UniqueNames()
            return titles.mapIndexed { index, title ->
                val wanted = title.ifEmpty { "Column ${index + 1}" }
                val name = given.give(wanted)
                if (name != wanted) {
                    problems.add(
                        ProblemKind.DUPLICATE_TOPIC,
                        "There are several topics named “$wanted”; this one is shown as “$name”.",
                        line,
                        name,
                    )
                }
                name
            }
        }

        private fun reportColumns(titles: List<String>, names: List<String>, topicOfColumn: List<Int?>, line: Int, problems: ProblemList) {
            names.forEachIndexed { index, name ->
                if (topicOfColumn[index] == null) {
                    problems.add(
                        ProblemKind.COLUMN_WITHOUT_TOPIC,
                        "Column “$name” is not described in the header; it is shown without a unit.",
                        line,
                        name,
                    )
                }
                val odd = titles[index].find { !isLetterOrDigit(it) && it !in " _/" }
                if (odd != null) {
                    problems.add(
                        ProblemKind.UNUSUAL_NAME,
                        "The name “$name” has a “$odd”; names are safest with letters, digits, space, _ and / only.",
                        line,
                        name,
                    )
                }
            }
        }
    }
}
