package badlog.expression

import badlog.analysis.Series

/**
 * A topic that is calculated from others: `Power [W] = Voltage * Current`.
 *
 * @property name the full name; `/` makes folders.
 * @property unit the unit, empty for none.
 * @property expression what it is.
 */
public class VirtualTopic private constructor(public val name: String, public val unit: String, public val expression: Expression) :
    ParsedVirtualTopic {
    /** What expressions see of it. */
    public val signal: Signal
        get() = Signal(name, if (expression.type.isCondition) SignalKind.CONDITION else SignalKind.NUMBER, unit)

    /** Its samples over [signals], see [Expression.series]. */
    public fun series(signals: Signals): Series = expression.series(signals)

    override fun toString(): String {
        val isPlain = name.none { it in "\"=[]" } && name == name.trim()
        val shownName = if (isPlain) name else "\"${name.replace("\"", "\"\"")}\""
        return "$shownName ${if (unit.isEmpty()) "" else "[$unit] "}= $expression"
    }

    public companion object {
        /**
         * Reads a definition: the name, in double quotes where it has one of `" = [ ]`, the unit in brackets or none, `=`, an
         * expression with the names of [vocabulary]. Never throws, whatever the text.
         */
        public fun parse(text: String, vocabulary: Vocabulary): ParsedVirtualTopic = try {
            val heading = VirtualTopicHeading(text)
            val taken = vocabulary.signals.find { it.name == heading.name }
            if (taken != null) heading.fail("There already is a topic “${heading.name}”.")
            if (heading.name in KEYWORDS) heading.fail("“${heading.name}” is a word of the language; choose another name.")
            val hidden = vocabulary.find(heading.name).singleOrNull()
            if (hidden != null) heading.fail("“${heading.name}” already means “${hidden.name}”; choose another name.")
            // The heading's place is kept by spaces, so that every position is that in the whole text.
            when (val body = Expression.parse(" ".repeat(heading.length) + text.substring(heading.length), vocabulary)) {
                is Expression -> VirtualTopic(heading.name, heading.unit, body)
                is ExpressionError -> ExpressionError(text, body.from, body.until, body.kind, body.message)
            }
        } catch (mistake: Mistake) {
            ExpressionError(text, mistake.from, mistake.until, mistake.kind, mistake.message)
        }
    }
}
