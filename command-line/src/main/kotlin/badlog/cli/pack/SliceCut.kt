package badlog.cli.pack

import badlog.cli.cut.rowPart
import badlog.cli.cut.samplePart
import badlog.cli.input.Failure
import badlog.cli.input.readLog
import badlog.cli.output.OutputFormat
import badlog.cli.search.signalsBeside
import badlog.cli.text.XTime
import badlog.cli.topic.part
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.core.recording.Recording
import badlog.files.terminal.Progress
import badlog.rules.ofPart
import badlog.signals.overItsTime
import badlog.signals.withSignals

/**
 * A slice of a log, cut as [order] says.
 *
 * @throws Failure if the requested moment is not in the log.
 */
internal class SliceCut(private val order: SliceOrder, progress: Progress) {
    private val view =
        LogView.of(readLog(order.log, progress).overItsTime()).withSignals(signalsBeside(order.log), order.log.fileName.toString())
    private val unit get() = view.xAxis.unit

    /** A second on the x axis. */
    private val second: Double = if (Units.isNone(unit) && !view.xAxis.isIndex) 1.0 else 1 / (Units.secondsIn(unit) ?: throw noTime())
    private val moment: Double = order.at.on(view.xAxis)

    /** The range of the slice on the log's x axis. */
    val span: Span

    init {
        val range = view.xAxis.range
        if (range == null || moment !in range) {
            val (from, to) = listOf(range?.start, range?.endInclusive).map { XTime.text(it ?: Double.NaN, unit) }
            val there = if (range == null) "" else "; ${view.xAxis.name} goes from $from to $to"
            throw Failure("There is no ${XTime.text(moment, unit)} in ${order.log}$there.")
        }
        span = Span(maxOf(moment - REACH * second, range.start), minOf(moment + REACH * second, range.endInclusive))
    }

    private val privacy = Privacy(view.recording)

    /** The slice, without private texts. */
    val recording: Recording = privacy.without(part()).let { it.copy(values = it.values.ofPart(place)) }

    /** The format in which it can be written. */
    val format: OutputFormat get() = if (recording.format.hasRows) OutputFormat.BAG else OutputFormat.WPILOG

    /** The number of private texts that were removed, by kind. */
    val removed: Map<Privacy.Kind, Int> get() = privacy.removed

    /** Its place in the log, for people. */
    val place: String get() = "${XTime.text(span.from, unit)} to ${XTime.text(span.to, unit)}"

    /** Returns the slice's name, made from the log's name [stem]. */
    fun nameFrom(stem: String): String = "${privacy.without(stem)} at ${XTime.text(moment, unit)}"

    /**
     * Returns the condition of a new rule that holds at its middle.
     *
     * @throws Failure if it was not given, and no topic has an unusual value at the moment.
     */
    fun condition(): String = order.condition ?: conditionAt(view, moment, span, NEAR * second) ?: throw Failure(
        "Nothing in ${order.log} is unusual at ${XTime.text(moment, unit)}; say with --when what the rule is about, as in " +
            "--when \"battery < 7\".",
    )

    private fun part(): Recording {
        if (!view.recording.format.hasRows) return samplePart(view, listOf(span)).recording
        val part = rowPart(view, listOf(span))
        return part.recording.part(part.rows)
    }

    private fun noTime() =
        Failure("${order.log} has no x axis in a unit of time; make one of its topics the x axis with badlog convert --x.")
}

/** The length of a slice before and after its moment, in s. */
private const val REACH = 10.0

/** The distance up to which a sample belongs to the moment, in s: people do not give moments more precisely. */
private const val NEAR = 0.5
