package badlog.expression

import badlog.analysis.Series
import badlog.expression.checking.BoundsCheck
import badlog.expression.checking.Checker
import badlog.expression.checking.UnitChecker
import badlog.expression.checking.unitOf
import badlog.expression.samples.Column
import badlog.expression.samples.Scalar
import badlog.expression.samples.pulses
import badlog.expression.signals.SampleBounds
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Mistake
import badlog.expression.syntax.Node
import badlog.expression.syntax.Parser
import badlog.expression.syntax.mistake
import badlog.expression.syntax.printed

/**
 * A question to a recording, or a formula between its topics, read and checked. `docs/expressions.md` has the language.
 *
 * It may be asked of every recording whose vocabulary is equal to [vocabulary], by several threads at once.
 *
 * @property text what it was read from.
 * @property vocabulary the names it was read with.
 */
public class Expression internal constructor(public val text: String, public val vocabulary: Vocabulary, internal val root: Node) :
    ParsedExpression {
    /** What it gives. */
    public val type: ExpressionType = ExpressionType(root.type.kind == Kind.CONDITION, root.type.isOverTime)

    /** The full names of the topics it uses, in the order in which they come first. */
    public val topics: List<String> = LinkedHashSet<String>().also { addTopics(root, it) }.toList()

    /** Whether it holds in the recording of [signals], when, and with which numbers. */
    public fun answer(signals: Signals): Answer = Answering(text, root, signals).answer()

    /**
     * The same as [answer] where the condition holds in the recording of [signals], else null. Of what is joined by `and` the first
     * that never holds decides, so that what is rare and cheap belongs in front.
     */
    public fun answerIfHolds(signals: Signals): Answer? = Answering(text, root, signals).answerIfHolds()

    /**
     * Whether the condition may hold where the samples of each topic are between [bounds], which are null for a topic of which nothing is known.
     * Where it says no, [answer] has no need to look.
     */
    public fun mayHold(bounds: (topic: String) -> SampleBounds?): Boolean = !type.isCondition || BoundsCheck(bounds).mayHold(root)

    /**
     * Its samples over time: numbers, or 1 and 0, with NaN for gaps. One number for the whole recording is a line from its begin
     * to its end. What happens at moments has its value there alone: in the rows that the recording has, else in a pulse without width.
     */
    public fun series(signals: Signals): Series = when (val value = Evaluation(signals, root.id + 1).valueOf(root)) {
        is Column -> {
            val column = if (value.isMomentary) value.pulses(signals.rows, if (type.isCondition) 0.0 else Double.NaN) else value
            Series(column.stretches?.logged(column.x) ?: column.x, column.y)
        }

        is Scalar -> signals.range.let { range ->
            val x = if (range == null) DoubleArray(0) else doubleArrayOf(range.from, range.to)
            Series(x, DoubleArray(x.size) { value.value })
        }
    }

    /** The expression with full names in quotes and no needless parentheses; reading it gives the same expression. */
    override fun toString(): String = printed(root)

    /** The unit of what it gives over [signals], where it is plain to see. */
    internal fun unit(signals: Signals): String = unitOf(root, signals.timeUnit)

    private fun addTopics(node: Node, names: MutableSet<String>) {
        if (node is Node.Topic) names += node.signal.name
        for (child in node.children) addTopics(child, names)
    }

    public companion object {
        /** Reads [text], in which the names are those of [vocabulary]. Never throws, whatever the text. */
        public fun parse(text: String, vocabulary: Vocabulary): ParsedExpression = parse(text, vocabulary, mayBeText = false)

        /** Reads [text], which may also be a text, as a topic of states. */
        internal fun parseAny(text: String, vocabulary: Vocabulary): ParsedExpression = parse(text, vocabulary, mayBeText = true)

        private fun parse(text: String, vocabulary: Vocabulary, mayBeText: Boolean): ParsedExpression = try {
            val root = Parser(text, vocabulary).parse()
            Checker.check(root)
            UnitChecker.check(root)
            val isAnswer = mayBeText || root.type.kind != Kind.TEXT
            if (!isAnswer) mistake(root, "This is a text, not an answer; compare it, as in State == 'IDLE'.")
            Expression(text, vocabulary, root)
        } catch (mistake: Mistake) {
            ExpressionError(text, mistake.from, mistake.until, mistake.kind, mistake.message)
        }
    }
}

/** What became of a text: an [Expression], or the [ExpressionError] that says why not. */
public sealed interface ParsedExpression

/**
 * What an expression gives.
 *
 * @property isCondition whether true and false, rather than numbers.
 * @property isOverTime whether one for each moment, rather than one for the whole recording.
 */
public data class ExpressionType(public val isCondition: Boolean, public val isOverTime: Boolean)
