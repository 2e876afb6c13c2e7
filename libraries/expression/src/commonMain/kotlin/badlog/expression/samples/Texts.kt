package badlog.expression.samples

import badlog.core.text.isLetterOrDigit

/** Returns 1 where [holds] is true for the text of [column], and 0 where it is false. A missing text is a gap. */
internal fun whereText(column: Column, holds: (String) -> Boolean): Column {
    val results = DoubleArray(column.texts!!.size) { if (holds(column.texts[it])) 1.0 else 0.0 }
    return column.with(DoubleArray(column.size) { column.y[it].let { id -> if (id.isNaN()) id else results[id.toInt()] } })
}

/** Returns 1 where the two have the same text; a gap where one has none. */
internal fun equalTexts(left: Column, right: Column): Value {
    val places = HashMap<String, Int>()
    for ((index, text) in left.texts!!.withIndex()) if (text !in places) places[text] = index
    val inLeft = DoubleArray(right.texts!!.size) { places[right.texts[it]]?.toDouble() ?: -1.0 }
    val translated = DoubleArray(right.size) { right.y[it].let { id -> if (id.isNaN()) id else inLeft[id.toInt()] } }
    return combined(left, right.with(translated), Operation.EQUAL)
}

/**
 * Returns whether all of [text] matches [pattern], in which `*` stands for any characters and `?` for one. Case is ignored. It is not a
 * regular expression: those differ between platforms, and some take forever.
 */
internal fun matches(text: String, pattern: String): Boolean {
    var at = 0
    var patternAt = 0
    var star = -1
    var starText = 0
    while (at < text.length) {
        if (patternAt < pattern.length && pattern[patternAt] == '*') {
            star = patternAt++
            starText = at
        } else if (patternAt < pattern.length && matchesCharacter(text[at], pattern[patternAt])) {
            at++
            patternAt++
        } else if (star >= 0) {
            // Let the last star match one more character.
            patternAt = star + 1
            at = ++starText
        } else {
            return false
        }
    }
    while (patternAt < pattern.length && pattern[patternAt] == '*') patternAt++
    return patternAt == pattern.length
}

private fun matchesCharacter(character: Char, wanted: Char) = wanted == '?' || character.equals(wanted, ignoreCase = true)

/** Returns the first number after [mark] in each text; a gap where there is none. */
internal fun numbers(column: Column, mark: String): Column {
    val results = DoubleArray(column.texts!!.size) { numberIn(column.texts[it], mark) }
    return column.with(DoubleArray(column.size) { column.y[it].let { id -> if (id.isNaN()) id else results[id.toInt()] } })
}

private fun numberIn(text: String, mark: String): Double {
    val found = text.indexOf(mark, ignoreCase = true)
    if (found < 0) return Double.NaN
    var at = found + mark.length
    while (at < text.length) {
        val begin = at
        if (!isDigit(text, begin) && !isFraction(text, begin)) {
            at++
            continue
        }
        at = endOfNumber(text, begin)
        // Digits within a word, as in CAN1, are part of its name; several points make a version or an address.
        val number = text.substring(begin, at).toDoubleOrNull()
        val isNegative = text.getOrNull(begin - 1) == '-' && (begin < 2 || !isLetterOrDigit(text[begin - 2]))
        if (number != null && !isWithinWord(text, begin - 1)) return if (isNegative) -number else number
    }
    return Double.NaN
}

private fun isFraction(text: String, at: Int) = text[at] == '.' && isDigit(text, at + 1)

private fun isDigit(text: String, at: Int) = at < text.length && text[at] in '0'..'9'

/** Returns the index after the digits at [from], with their points and the exponent that Java writes for small numbers. */
private fun endOfNumber(text: String, from: Int): Int {
    var until = from
    while (until < text.length && (isDigit(text, until) || isFraction(text, until))) until++
    if (text.getOrNull(until) != 'E' && text.getOrNull(until) != 'e') return until
    var end = if (text.getOrNull(until + 1) == '-' || text.getOrNull(until + 1) == '+') until + 2 else until + 1
    if (!isDigit(text, end)) return until
    while (isDigit(text, end)) end++
    return if (isWithinWord(text, end)) until else end
}

private fun isWithinWord(text: String, at: Int) = text.getOrNull(at)?.let { isLetterOrDigit(it) || it == '_' } == true
