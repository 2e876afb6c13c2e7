package badlog.expression.syntax

import badlog.core.analysis.Units
import badlog.expression.signals.isWordCharacter
import badlog.expression.signals.isWordEnd

/** Reads the text of an expression from left to right. It recognizes numbers, quotes and operators, but not names. */
internal class Scanner(private val text: String) {
    /** The index of the next character. */
    var at = 0

    fun skipSpace() {
        while (at < text.length && text[at].isWhitespace()) at++
    }

    /** Skips spaces, and returns whether nothing else is left. */
    fun isAtEnd(): Boolean {
        skipSpace()
        return at == text.length
    }

    /** Returns whether [character] comes next; if so, skips it. */
    fun take(character: Char): Boolean {
        skipSpace()
        val isNext = at < text.length && text[at] == character
        if (isNext) at++
        return isNext
    }

    fun takeWord(word: String): Boolean {
        val isNext = text.startsWith(word, at, ignoreCase = true) && isWordEnd(text, at + word.length)
        if (isNext) at += word.length
        return isNext
    }

    /** Returns the spelling of the next operator, and the operator. */
    fun peekOperator(): Pair<String, Operator>? = Operator.spellings.find { (spelling, _) ->
        text.startsWith(spelling, at, ignoreCase = true) && isWordEnd(text, at + spelling.length)
    }

    /** Returns the letters, digits and underscores from [from] on. */
    fun wordAt(from: Int): String {
        var until = from
        while (until < text.length && isWordCharacter(text[until])) until++
        return text.substring(from, until)
    }

    /** Returns the next word, or the next single character. */
    fun restWord(): String = wordAt(at).ifEmpty { text.substring(at, at + 1) }

    fun isNumberHere(): Boolean = isDigit(at) || (at < text.length && text[at] == '.' && isDigit(at + 1))

    private fun isDigit(place: Int) = place < text.length && text[place] in '0'..'9'

    /** Reads a number, or a time if a unit follows. */
    fun number(): Node {
        val from = at
        skipDigits()
        if (at < text.length && text[at] == '.' && isDigit(at + 1)) {
            at++
            skipDigits()
        }
        if (at < text.length && text[at] in "eE") {
            val sign = if (at + 1 < text.length && text[at + 1] in "+-") 1 else 0
            if (isDigit(at + 1 + sign)) {
                at += 1 + sign
                skipDigits()
            }
        }
        val digits = text.substring(from, at)
        val value = digits.toDouble()
        if (!value.isFinite()) fail(from, at, "This number is too large.")
        if (at < text.length && text[at] == ':' && isDigit(at + 1)) return clockTime(from)
        val end = at
        skipSpace()
        val word = wordAt(at)
        val isTaken = peekOperator() != null || word.lowercase() in NOT_UNITS
        val unit = if (isTaken) "" else PhysicalUnit.longestAt(text, at)
        val seconds = Units.secondsIn(unit)
        if (unit.isEmpty()) {
            if (!isTaken && word.isNotEmpty()) fail(at, at + word.length, noUnit(word))
            at = end
            return Node.Number(from, end, value, digits)
        }
        at += unit.length
        if (seconds == null) return Node.Measured(from, at, value, digits, unit)
        if (!(value * seconds).isFinite()) fail(from, at, "This time is too long.")
        return Node.Time(from, at, value * seconds, "$digits $unit")
    }

    /** Reads a time in clock notation: `1:30` is a minute and a half, `1:02:03.5` an hour more. */
    private fun clockTime(from: Int): Node {
        while (at < text.length && (isDigit(at) || (text[at] in ":." && isDigit(at + 1)))) at++
        val written = text.substring(from, at)
        val parts = written.split(':')
        val isClock = parts.size in 2..3 && parts.drop(1).all { it.substringBefore('.').length == 2 && it.toDouble() < SIXTY } &&
            parts.dropLast(1).none { '.' in it }
        if (!isClock) fail(from, at, "“$written” is not a time; write minutes and seconds as 1:30, or hours too as 1:02:03.")
        return Node.Time(from, at, parts.fold(0.0) { sum, part -> sum * SIXTY + part.toDouble() }, written)
    }

    private fun skipDigits() {
        while (isDigit(at)) at++
    }

    /** Reads the text between two [quote]s; the first one comes next. A doubled quote stands for one. */
    fun quoted(quote: Char, what: String): String {
        val from = at++
        val content = StringBuilder()
        while (at < text.length) {
            val character = text[at++]
            if (character == quote) {
                if (at == text.length || text[at] != quote) return content.toString()
                at++
            }
            content.append(character)
        }
        fail(from, text.length, "This $what is never closed; $quote is missing.")
    }

    private fun noUnit(unit: String) =
        "“$unit” is not a unit that badlog knows; times are written in h, min, s, ms or us, other numbers without a unit or as in 7 V."

    private fun fail(from: Int, until: Int, message: String): Nothing = throw Mistake(from, until, ExpressionErrorKind.SYNTAX, message)

    private companion object {
        const val SIXTY = 60.0

        /** Words that may follow a number but are not units. */
        val NOT_UNITS = setOf("for", "within")
    }
}
