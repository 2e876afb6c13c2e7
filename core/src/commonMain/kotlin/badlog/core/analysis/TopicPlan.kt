package badlog.core.analysis

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/**
 * The plan for showing one topic. Its attributes change the plan, one after the other.
 *
 * @property topic the topic.
 */
public class TopicPlan internal constructor(public val topic: Topic, private val report: (Problem) -> Unit) {
    internal class Derivation(val name: String, val unit: (unit: String, xUnit: String) -> String, val series: (Series) -> Series)

    internal var isHidden = false
        private set
    internal var isEventLog = topic.kind == TopicKind.EVENT
        private set
    internal var isFilled = false
        private set
    internal var includesZero = false
        private set
    internal var isX = false
        private set
    internal val derivations = ArrayList<Derivation>()
    internal val joins = LinkedHashSet<String>()

    /** Whether the topic's samples are numbers, so that calculations are possible. */
    public val isNumeric: Boolean
        get() = topic.counts.run { numbers + notFinite + truthValues } > 0 && topic.kind != TopicKind.EVENT

    /** Whether some of the topic's samples are missing or are not finite. */
    public val hasGaps: Boolean
        get() = isNumeric && !topic.isSparse && topic.counts.run { notFinite + texts + empty } > 0

    /** Hides the topic's own graph; graphs derived from it are still shown. */
    public fun hide() {
        isHidden = true
    }

    /** Shows the topic's texts as a list of events. */
    public fun showAsEventLog() {
        isEventLog = true
    }

    /** Fills the area below the topic's line. */
    public fun fill() {
        isFilled = true
    }

    /** Makes the y axis of the topic's graph include 0. */
    public fun includeZero() {
        includesZero = true
    }

    /** Makes the topic the x axis of every graph. */
    public fun useAsX() {
        isX = true
    }

    /**
     * Adds a graph for the result of [series] from the topic's samples. Its title is the topic's name and [name], in brackets.
     *
     * @param unit returns the graph's unit from the topic's unit and the unit of x.
     */
    public fun derive(name: String, unit: (unit: String, xUnit: String) -> String, series: (Series) -> Series) {
        derivations += Derivation("${topic.name} $name", unit, series)
    }

    /** Adds the topic as a line to the graph named [graph], which other topics may join, too. */
    public fun join(graph: String) {
        joins += graph
    }

    /** Reports a problem of the topic or its attributes. */
    public fun report(kind: ProblemKind, message: String) {
        report(Problem(kind, message, topic = topic.name))
    }
}
