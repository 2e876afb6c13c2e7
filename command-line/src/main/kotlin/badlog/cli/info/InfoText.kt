package badlog.cli.info

import badlog.cli.beside.FileBeside
import badlog.cli.text.LINE_WIDTH
import badlog.cli.text.XTime
import badlog.cli.text.counted
import badlog.cli.text.grouped
import badlog.cli.text.problemLines
import badlog.cli.text.shortNumber
import badlog.cli.text.sizeText
import badlog.cli.text.wrapped
import badlog.core.analysis.Units
import badlog.core.recording.Severity
import badlog.core.recording.TopicKind
import badlog.files.terminal.TextTable
import badlog.files.terminal.TextTable.Column
import badlog.files.terminal.displayWidth
import badlog.files.terminal.printable
import badlog.signals.vocabulary.SignalTopic
import kotlin.math.roundToLong

/**
 * Everything about one log, for people, in lines that fit a terminal.
 *
 * @param parts the parts to show below its summary.
 * @param signals the topics recognized as signals.
 * @param width the number of columns.
 * @param beside the other files of its match.
 */
internal class InfoText(
    private val summary: LogSummary,
    private val parts: Set<InfoPart>,
    private val signals: List<SignalTopic>,
    private val width: Int,
    private val beside: List<FileBeside> = emptyList(),
) {
    private val view = summary.view
    private val recording = view.recording

    /** The width of sentences: longer lines are hard to read. */
    private val lineWidth = minOf(width, LINE_WIDTH)

    /** Returns the lines, without a newline at their end. */
    fun text(): String = listOf(
        summaryLines(),
        if (InfoPart.VALUES in parts) valueLines() else emptyList(),
        if (InfoPart.TOPICS in parts) topicLines() else emptyList(),
        if (InfoPart.SIGNALS in parts) signalLines(signals, width) else emptyList(),
        when {
            InfoPart.PROBLEMS in parts -> problemLines(view.problems)
            InfoPart.WORST in parts -> worstLines()
            else -> emptyList()
        },
    ).filter { it.isNotEmpty() }.joinToString("\n\n") { it.joinToString("\n") }

    /** Returns the problems to show with any other answer, and the number of hints. */
    private fun worstLines(): List<String> {
        val (hints, others) = view.problems.partition { it.severity == Severity.NOTE }
        val more = if (hints.isEmpty()) emptyList() else listOf("${counted(hints.size.toLong(), "hint")}: see --problems")
        return problemLines(others) + more
    }

    private fun summaryLines(): List<String> = buildList {
        add(printable(summary.file.toString()))
        view.title?.let { add(wrapped("  match   ", it, width = lineWidth)) }
        add("  format  ${recording.format.title}, ${sizeText(summary.bytes)}")
        val sizes = listOf(
            if (recording.format.hasRows) counted(recording.rowCount.toLong(), "row") else counted(recording.sampleCount, "sample"),
            counted(recording.topics.size.toLong(), "topic"),
            counted(recording.values.size.toLong(), "value"),
        )
        add("  holds   ${sizes.joinToString()}")
        add(wrapped("  x       ", xText(), width = lineWidth))
        if (beside.isNotEmpty()) add(wrapped("  beside  ", besideText(), width = lineWidth))
    }

    private fun xText(): String {
        val range = summary.range ?: return view.xAxis.title
        val text = "${view.xAxis.title} from ${shortNumber(range.start)} to ${shortNumber(range.endInclusive)}"
        return summary.seconds?.let { "$text, ${XTime.clock(it)} long" } ?: text
    }

    private fun besideText(): String {
        val more = if (beside.size > MAX_BESIDE) ", and ${beside.size - MAX_BESIDE} more" else ""
        return beside.take(MAX_BESIDE).joinToString { "${printable(it.path)} (${it.role})" } + more
    }

    private fun valueLines(): List<String> {
        val names = recording.values.map { printable(it.name) }
        val nameWidth = minOf(VALUE_NAME, names.maxOfOrNull(::displayWidth) ?: 0)
        return recording.values.zip(names) { value, name ->
            wrapped(name + " ".repeat(maxOf(0, nameWidth - displayWidth(name)) + 2), value.text, nameWidth + 2, lineWidth)
        }
    }

    private fun topicLines(): List<String> {
        if (summary.topics.isEmpty()) return emptyList()
        val blocks = TextTable(COLUMNS, width, repeated = 1).blocks(summary.topics.map(::cellsOf))
        if (InfoPart.ATTRIBUTES !in parts) return blocks.flatMapIndexed { index, block -> listOf("").take(index) + block.flatten() }
        val first = blocks.first()
        val others = blocks.drop(1).flatMap { listOf("") + it.flatten() }
        return first.first() + summary.topics.flatMapIndexed { index, topic ->
            val attributes = topic.topic.attributes.joinToString()
            first[index + 1] + listOfNotNull(wrapped("    ", attributes, width = lineWidth).takeIf { attributes.isNotBlank() })
        } + others
    }

    private fun cellsOf(summary: TopicSummary): List<String> {
        val topic = summary.topic
        return listOf(
            topic.name,
            if (Units.isNone(topic.unit)) "" else topic.unit,
            topic.kind.name.lowercase(),
            grouped(summary.count.toLong()),
            summary.rate?.let(::rateText).orEmpty(),
            rangeText(summary),
            summary.gaps?.takeIf { it > 0 }?.let { grouped(it.toLong()) }.orEmpty(),
        )
    }

    private fun rateText(rate: Double) = if (rate >= 10) rate.roundToLong().toString() else shortNumber((rate * 100).roundToLong() / 100.0)

    private fun rangeText(summary: TopicSummary): String = when {
        summary.hasTexts -> counted(summary.topic.texts.dictionary.size.toLong(), "text")
        summary.topic.kind == TopicKind.BOOLEAN -> setOf(summary.min, summary.max).joinToString(" … ") { "${it != 0.0}" }
        summary.count == 0 -> ""
        summary.min == summary.max -> shortNumber(summary.min, DIGITS)
        else -> "${shortNumber(summary.min, DIGITS)} … ${shortNumber(summary.max, DIGITS)}"
    }

    private companion object {
        val COLUMNS = listOf(
            Column("TOPIC"),
            Column("UNIT"),
            Column("KIND", isWhole = true),
            Column("COUNT", isNumber = true),
            Column("HZ", isNumber = true),
            Column("RANGE", isWhole = true),
            Column("GAPS", isNumber = true),
        )
        const val VALUE_NAME = 32
        const val DIGITS = 4
        const val MAX_BESIDE = 10
    }
}
