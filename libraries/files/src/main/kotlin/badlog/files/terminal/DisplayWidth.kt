package badlog.files.terminal

/** Returns the number of terminal columns that [text] takes. Wide characters, such as Chinese ones, take two, and combining marks none. */
public fun displayWidth(text: String): Int {
    var width = 0
    var at = 0
    while (at < text.length) {
        val character = text.codePointAt(at)
        width += widthOf(character)
        at += Character.charCount(character)
    }
    return width
}

/** Returns the longest beginning of [text] that takes at most [width] columns; no character is separated from its marks. */
public fun startOf(text: String, width: Int): String {
    var room = width
    var end = 0
    while (end < text.length) {
        val character = text.codePointAt(end)
        room -= widthOf(character)
        if (room < 0) break
        end += Character.charCount(character)
    }
    return text.substring(0, end)
}

/** Returns the longest end of [text] that takes at most [width] columns. */
public fun endOf(text: String, width: Int): String {
    var room = width
    var start = text.length
    while (start > 0) {
        val character = text.codePointBefore(start)
        room -= widthOf(character)
        if (room < 0) break
        start -= Character.charCount(character)
    }
    return text.substring(start)
}

private fun widthOf(character: Int): Int = when {
    character in ' '.code..'~'.code -> 1
    Character.getType(character).toByte() in MARKS -> 0
    WIDE.any { character in it } -> 2
    else -> 1
}

private val MARKS = setOf(Character.NON_SPACING_MARK, Character.ENCLOSING_MARK)

/** East Asian characters, and emoji. */
private val WIDE = listOf(
    0x1100..0x115F, 0x2E80..0x303E, 0x3041..0xA4CF, 0xA960..0xA97F, 0xAC00..0xD7A3, 0xF900..0xFAFF, 0xFE30..0xFE6F, 0xFF00..0xFF60,
    0xFFE0..0xFFE6, 0x1F300..0x1F64F, 0x1F680..0x1F6FF, 0x1F900..0x1FAFF, 0x20000..0x3FFFD,
)
