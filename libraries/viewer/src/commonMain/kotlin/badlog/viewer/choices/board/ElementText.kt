package badlog.viewer.choices.board

import badlog.viewer.text.addressText
import badlog.viewer.text.nameOfAddress

/**
 * Returns the texts of [lines] in an address, in their order. Elements of an array that follow each other are one text with a range between
 * colons: `Modules[0]/speed` to `Modules[3]/speed` are `Modules:0-3:/speed`, and `Currents[2]` alone is `Currents:2:`.
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
 * Returns the lines whose names [text] is, one of [lineTexts].
 *
 * @throws BoardException if it is not a name, or a range that no array has.
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

/** Returns the name that [addressText] wrote as [text]. */
internal fun nameOf(text: String): String =
    nameOfAddress(text) ?: throw BoardException("“$text” has a “~” that is not a character; copy the whole address again.")

/** The elements [first] to [last] of an array, whose names have [before] and [after] around the index; without an index, just a name. */
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

/** Returns what [name] says about an element: `Modules[0]/speed` is the first one of an array; null if it is none. */
private fun elementOf(name: String): ElementRun? {
    val open = name.lastIndexOf('[')
    val close = name.indexOf(']', open + 1)
    if (open < 0 || close < 0) return null
    val digits = name.substring(open + 1, close)
    // An index as it is written: neither 07 nor +7.
    val index = digits.toIntOrNull()?.takeIf { it >= 0 && "$it" == digits } ?: return null
    return ElementRun(name.substring(0, open), index, after = name.substring(close + 1))
}

private const val NO_INDEX = -1
private const val NAMELESS = "~"

// Names in an address have none.
private const val RANGE = ':'
private const val PARTS = 3

/** More elements than arrays have; also the limit of what a few characters of a damaged address ask for. */
private const val MAX_ELEMENTS = 1_000
