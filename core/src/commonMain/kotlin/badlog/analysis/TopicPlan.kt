package badlog.analysis

import badlog.recording.Problem
import badlog.recording.ProblemKind
import badlog.recording.Topic
import badlog.recording.TopicKind

/**
 * How one topic is to be shown; its attributes, applied one after the other, decide.
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

    /** Whether the topic's samples are numbers, so that it can be calculated with. */
    public val isNumeric: Boolean
        get() = topic.counts.run { numbers + notFinite + truthValues } > 0 && topic.kind != TopicKind.EVENT

    /** Whether some of the topic's samples are missing or are not finite. */
    public val hasGaps: Boolean
        get() = isNumeric && !topic.isSparse && topic.counts.run { notFinite + texts + empty } > 0

    /** The topic's own graph is not shown; what derives from it is. */
    public fun hide() {
        isHidden = true
    }

    /** The topic's texts are shown as a list of events. */
    public fun showAsEventLog() {
        isEventLog = true
    }

    /** The area below the topic's line is filled. */
    public fun fill() {
        isFilled = true
    }

    /** The y axis of the topic's graph includes 0. */
    public fun includeZero() {
        includesZero = true
    }

    /** The topic is the x of every graph. */
    public fun useAsX() {
        isX = true
    }

    /**
     * A graph of its own is shown for what [series] makes of the topic's samples, titled `[ topic name ]` in brackets.
     *
     * @param unit gives its unit from the topic's unit and that of x.
     */
    public fun derive(name: String, unit: (unit: String, xUnit: String) -> String, series: (Series) -> Series) {
        derivations += Derivation("${topic.name} $name", unit, series)
    }

    /** The topic is also a line of the graph named [graph], in which others may join. */
    public fun join(graph: String) {
        joins += graph
    }

    /** Reports that something about the topic or its attributes is odd. */
    public fun report(kind: ProblemKind, message: String) {
        report(Problem(kind, message, topic = topic.name))
    }
}
