package badlog.core.conformance

import badlog.core.recording.CellCounts
import badlog.core.recording.ProblemKind
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TopicKind
import badlog.core.recording.Value

/**
 * A file, the expected reading, and the reason for it. The expectation is written by hand from `docs/bag-format.md`, never copied from a
 * parser's output.
 */
internal class ConformanceCase(val name: String, val why: String, val bytes: ByteArray, val expected: Expectation)

internal fun case(name: String, why: String, file: String, expected: Expectation) = ConformanceCase(name, why, file.encodeToByteArray(), expected)

/** A case with a file that is not UTF-8: each character below U+0100 is that byte. */
internal fun bytesCase(name: String, why: String, file: String, expected: Expectation) = ConformanceCase(name, why, file.toByteArray(Charsets.ISO_8859_1), expected)

/** A bag in which these [topics] are read. */
internal fun bag(
    vararg topics: ExpectedTopic,
    values: List<Value> = emptyList(),
    problems: List<ExpectedProblem> = emptyList(),
    attributeProblems: List<ExpectedProblem> = emptyList(),
) = expectation(RecordingFormat.BAG, values, topics.asList(), problems, attributeProblems)

/** A plain CSV file in which these [topics] are read. */
internal fun csv(vararg topics: ExpectedTopic, problems: List<ExpectedProblem> = emptyList()) = expectation(RecordingFormat.CSV, emptyList(), topics.asList(), problems, emptyList())

private fun expectation(
    format: RecordingFormat,
    values: List<Value>,
    topics: List<ExpectedTopic>,
    problems: List<ExpectedProblem>,
    attributeProblems: List<ExpectedProblem>,
): Expectation {
    val rowCounts = topics.map { it.samples.size }.distinct()
    require(rowCounts.size <= 1) { "The topics of one case have different numbers of rows: $rowCounts." }
    return Expectation(format, values, topics, rowCounts.firstOrNull() ?: 0, problems, attributeProblems)
}

/**
 * A topic. Each cell is a number, a truth value, a text, or null for a gap.
 */
internal fun topic(
    name: String,
    unit: String = "ul",
    attributes: List<String> = emptyList(),
    kind: TopicKind = TopicKind.NUMERIC,
    cells: List<Any?> = emptyList(),
) = ExpectedTopic(
    name = name,
    unit = unit,
    attributes = attributes,
    kind = if (cells.isEmpty()) TopicKind.EMPTY else kind,
    counts = CellCounts(
        numbers = cells.count { it is Number && it.toDouble().isFinite() },
        notFinite = cells.count { it is Number && !it.toDouble().isFinite() },
        truthValues = cells.count { it is Boolean },
        texts = cells.count { it is String },
        empty = cells.count { it == null },
        gaps = cells.indices.count { isGap(cells[it]) && (it == 0 || !isGap(cells[it - 1])) },
    ),
    samples = cells.map { cell ->
        when (cell) {
            is Number -> cell.toDouble()
            is Boolean -> if (cell) 1.0 else 0.0
            else -> null
        }
    },
    texts = cells.mapIndexedNotNull { row, cell -> (cell as? String)?.let { row to it } },
)

/** The cells of a topic, from the first row to the last. */
internal fun cells(vararg cells: Any?): List<Any?> = cells.asList()

/** A problem on a line. */
internal infix fun ProblemKind.at(line: Int) = ExpectedProblem(this, line)

/** A problem of a topic, without a line. */
internal infix fun ProblemKind.of(topic: String) = ExpectedProblem(this, topic = topic)

/** A problem of a topic, on a line. */
internal infix fun ExpectedProblem.of(topic: String) = copy(topic = topic)

/** A problem of the whole file. */
internal val ProblemKind.anywhere: ExpectedProblem get() = ExpectedProblem(this)

private fun isGap(cell: Any?) = cell == null || cell is String
