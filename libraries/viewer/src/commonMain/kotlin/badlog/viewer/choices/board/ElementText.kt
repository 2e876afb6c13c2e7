package badlog.viewer.choices.board

import badlog.viewer.text.addressText
import badlog.viewer.text.nameOfAddress

/**
 * Returns the texts of [lines] in an address, in their order. Consecutive elements of an array are one text with a range between colons:
 * `Modules[0]/speed` to `Modules[3]/speed` are `Modules:0-3:/speed`, and `Currents[2]` alone is `Currents:2:`.
 */
internal fun lineTexts(lines: List<String>): List<String> {
    val runs = ArrayList<ElementRun>()
    for (line in lines) {
        val element = elementOf(line)
        val before = runs.lastOrNull()
        if (element != null && before?.isFollowedBy(element) == true) {
            runs[runs.size - 1] = before.copy(last = element.first)
        } else {
            runs += element ?: ElementRun(line)
        }
    }
    return runs.map { it.toText() }
}

/**
 * Returns the names of the lines for which [lineTexts] wrote [text].
 *
 * @throws BoardException if the text is neither a name nor a possible range of an array.
 */
internal fun linesOfText(text: String): List<String> {
    if (text == NAMELESS) return listOf("")
    val parts = text.split(RANGE)
    if (parts.size != PARTS) return listOf(nameOf(text))
    val first = parts[1].substringBefore('-').toIntOrNull()
    val last = parts[1].substringAfter('-').toIntOrNull()
    if (first == null || last == null || first < 0 || last < first || last - first >= MAX_ELEMENTS) {
        throw BoardException("“${parts[1]}” is not a range of elements; copy the whole address again.")
    }
    val (before, after) = nameOf(parts[0]) to nameOf(parts[2])
    return (first..last).map { "$before[$it]$after" }
}

/**
 * Returns the name that [addressText] wrote as [text].
 *
 * @throws BoardException if it is damaged.
 */
internal fun nameOf(text: String): String =
    nameOfAddress(text) ?: throw BoardException("“$text” has a “~” that is not a character; copy the whole address again.")

/** The elements [first] to [last] of an array. Their names have [before], the index and [after]; without an index, just a name. */
private data class ElementRun(val before: String, val first: Int = NO_INDEX, val last: Int = first, val after: String = "") {
    fun isFollowedBy(next: ElementRun) = first != NO_INDEX && next.before == before && next.after == after && next.first == last + 1 &&
        next.first - first < MAX_ELEMENTS

    fun toText(): String {
        val name = addressText(before)
        if (first == NO_INDEX) return name.ifEmpty { NAMELESS }
        val range = if (first == last) "$first" else "$first-$last"
        return name + RANGE + range + RANGE + addressText(after)
    }
}

/** Returns the element that [name] describes. For `Modules[0]/speed`, the first of an array; null if it is not an element. */
private fun elementOf(name: String): ElementRun? {
    val open = name.lastIndexOf('[')
    val close = name.indexOf(']', open + 1)
    if (open < 0 || close < 0) return null
    val digits = name.substring(open + 1, close)
    // Only an index as it is written: neither 07 nor +7.
    val index = digits.toIntOrNull()?.takeIf { it >= 0 && "$it" == digits } ?: return null
    return ElementRun(name.substring(0, open), index, after = name.substring(close + 1))
}

private const val NO_INDEX = -1
private const val NAMELESS = "~"

// A character that names in an address never have.
private const val RANGE = ':'
private const val PARTS = 3

/** The maximum number of elements, more than arrays have; it limits the effect of a damaged address. */
private const val MAX_ELEMENTS = 1_000
