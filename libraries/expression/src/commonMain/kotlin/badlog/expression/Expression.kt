package badlog.expression

import badlog.core.analysis.Series
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
 * A question about a recording, or a formula of its topics, parsed and checked. `docs/expressions.md` describes the
 * language.
 *
 * It can be evaluated for every recording with a vocabulary equal to [vocabulary], and by several threads at once.
 *
 * @property text its source text.
 * @property vocabulary the names that it can use.
 */
class Expression internal constructor(val text: String, val vocabulary: Vocabulary, internal val root: Node) : ParsedExpression {
    /** The type of its result. */
    val type: ExpressionType = ExpressionType(root.type.kind == Kind.CONDITION, root.type.isOverTime)

    /** The full names of the topics it uses, in order of first appearance. */
    val topics: List<String> = LinkedHashSet<String>().also { addTopics(root, it) }.toList()

    /** Returns whether it holds in the recording of [signals], when, and with which numbers. */
    fun answer(signals: Signals): Answer = Answering(text, root, signals).answer()

    /**
     * Returns the [answer] if the condition holds in the recording of [signals], otherwise null. Conditions joined by `and` are evaluated
     * up to the first that never holds, so rare and cheap ones should come first.
     */
    fun answerIfHolds(signals: Signals): Answer? = Answering(text, root, signals).answerIfHolds()

    /**
     * Returns whether the condition may hold if each topic's samples are within [bounds]. If not, there is no need to call [answer].
     * [bounds] returns null for a topic with unknown samples.
     */
    fun mayHold(bounds: (topic: String) -> SampleBounds?): Boolean = !type.isCondition || BoundsCheck(bounds).mayHold(root)

    /**
     * Returns its samples over time: numbers, or 1 and 0, with NaN for gaps. One number for the whole recording becomes a line from start
     * to end. Something that happens at moments has its value only there: in rows, if the recording has them, otherwise as a pulse without
     * width.
     */
    fun series(signals: Signals): Series = when (val value = Evaluation(signals, root.id + 1).valueOf(root)) {
        is Column -> {
            val column = if (value.isMomentary) value.pulses(signals.rows, if (type.isCondition) 0.0 else Double.NaN) else value
            Series(column.stretches?.logged(column.x) ?: column.x, column.y)
        }

        is Scalar -> signals.range.let { range ->
            val x = if (range == null) DoubleArray(0) else doubleArrayOf(range.from, range.to)
            Series(x, DoubleArray(x.size) { value.value })
        }
    }

    /** Returns the expression with full names in quotes and no needless parentheses; reading it gives the same expression. */
    override fun toString(): String = printed(root)

    /** Returns the unit of its result for [signals]; empty if it is not obvious. */
    internal fun unit(signals: Signals): String = unitOf(root, signals.timeUnit)

    private fun addTopics(node: Node, names: MutableSet<String>) {
        if (node is Node.Topic) names += node.signal.name
        for (child in node.children) addTopics(child, names)
    }

    companion object {
        /** Reads [text] with the names of [vocabulary]. Never throws, whatever the text. */
        fun parse(text: String, vocabulary: Vocabulary): ParsedExpression = parse(text, vocabulary, mayBeText = false)

        /** Reads [text], and also accepts an expression with texts as its result, such as a topic of states. */
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

/** The result of parsing: an [Expression], or the [ExpressionError] that says why it failed. */
sealed interface ParsedExpression

/**
 * The type of an expression's result.
 *
 * @property isCondition whether the result is true or false, rather than a number.
 * @property isOverTime whether there is a result for each moment, rather than one for the whole recording.
 */
data class ExpressionType(val isCondition: Boolean, val isOverTime: Boolean)
