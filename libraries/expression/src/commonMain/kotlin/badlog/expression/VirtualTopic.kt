package badlog.expression

import badlog.core.analysis.Series
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary
import badlog.expression.syntax.ExpressionErrorKind
import badlog.expression.syntax.KEYWORDS
import badlog.expression.syntax.Mistake
import badlog.expression.syntax.Scanner

/**
 * A topic that is calculated from others: `Power [W] = Voltage * Current`.
 *
 * @property name the full name; `/` makes folders.
 * @property unit the unit; empty for none.
 * @property expression the expression that calculates it.
 */
class VirtualTopic private constructor(val name: String, val unit: String, val expression: Expression) : ParsedVirtualTopic {
    /** Its signal, as expressions see it. */
    val signal: Signal
        get() = Signal(name, if (expression.type.isCondition) SignalKind.CONDITION else SignalKind.NUMBER, unit)

    /** Returns its samples over [signals], see [Expression.series]. */
    fun series(signals: Signals): Series = expression.series(signals)

    override fun toString(): String {
        val isPlain = name.none { it in "\"=[]" } && name == name.trim()
        val shownName = if (isPlain) name else "\"${name.replace("\"", "\"\"")}\""
        return "$shownName ${if (unit.isEmpty()) "" else "[$unit] "}= $expression"
    }

    companion object {
        /**
         * Reads a definition. It has a name, in double quotes if it contains one of `" = [ ]`; an optional unit in brackets; `=`; and an
         * expression with the names of [vocabulary]. Never throws, whatever the text.
         */
        fun parse(text: String, vocabulary: Vocabulary): ParsedVirtualTopic = try {
            val heading = VirtualTopicHeading(text)
            val taken = vocabulary.signals.find { it.name == heading.name }
            if (taken != null && taken.name !in vocabulary.meanings) heading.fail("“${heading.name}” already exists; use another name.")
            if (heading.name in KEYWORDS) heading.fail("“${heading.name}” is a word of the language; use another name.")
            val hidden = vocabulary.find(heading.name).singleOrNull()
            if (hidden != null && hidden.name !in vocabulary.meanings) {
                heading.fail("“${heading.name}” already means “${hidden.name}”; use another name.")
            }
            // Spaces replace the heading, so that every position is the same as in the whole text.
            when (val body = Expression.parse(" ".repeat(heading.length) + text.substring(heading.length), vocabulary)) {
                is Expression -> VirtualTopic(heading.name, heading.unit, body)
                is ExpressionError -> ExpressionError(text, body.from, body.until, body.kind, body.message)
            }
        } catch (mistake: Mistake) {
            ExpressionError(text, mistake.from, mistake.until, mistake.kind, mistake.message)
        }
    }
}

/** The result of parsing a definition: a [VirtualTopic], or the [ExpressionError] that says why it failed. */
sealed interface ParsedVirtualTopic

/** The part before the expression in the definition [text] of a virtual topic, including the `=`. */
internal class VirtualTopicHeading(private val text: String) {
    private var nameEnd = 0

    val name: String
    val unit: String

    /** The number of its characters. */
    val length: Int

    init {
        val scanner = Scanner(text)
        scanner.skipSpace()
        val isQuoted = scanner.at < text.length && text[scanner.at] == '"'
        val quoted = if (isQuoted) scanner.quoted('"', "name") else ""
        val equals = text.indexOf('=', scanner.at)
        if (equals < 0) fail("A formula needs a name and =, as in Power [W] = Voltage * Current.", text.length)
        nameEnd = equals
        val rest = text.substring(scanner.at, equals).trim()
        val bracket = if (rest.endsWith(']')) rest.lastIndexOf('[') else -1
        unit = if (bracket < 0) "" else rest.substring(bracket + 1, rest.length - 1).trim()
        val plainName = if (bracket < 0) rest else rest.substring(0, bracket).trim()
        if (isQuoted && plainName.isNotEmpty()) fail("Only a unit in brackets may be between a quoted name and =.")
        name = if (isQuoted) quoted else plainName
        if (name.isBlank()) fail("The formula has no name before =.")
        length = equals + 1
    }

    fun fail(message: String, until: Int = nameEnd): Nothing = throw Mistake(0, until, ExpressionErrorKind.SYNTAX, message)
}
