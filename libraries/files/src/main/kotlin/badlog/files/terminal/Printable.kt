package badlog.files.terminal

/**
 * Returns [text] on one line, without anything that would affect a terminal: names and texts come from files. Control characters, which could move
 * the cursor or change colors, become spaces. Invisible characters, such as those that change the text direction or have no width, become `�`.
 */
public fun printable(text: String): String {
    if (isPrintable(text)) return text
    return buildString {
        text.codePoints().forEach { character ->
            when {
                isControl(character) -> append(' ')
                isUnseen(character) -> append('\uFFFD')
                else -> appendCodePoint(character)
            }
        }
    }
}

private fun isPrintable(text: String): Boolean {
    var at = 0
    while (at < text.length) {
        val character = text.codePointAt(at)
        // Nearly all are ASCII, so their type need not be checked.
        if (character !in ' '.code..'~'.code && (isControl(character) || isUnseen(character))) return false
        at += Character.charCount(character)
    }
    return true
}

private fun isControl(character: Int) = Character.isISOControl(character)

private fun isUnseen(character: Int) = Character.getType(character).toByte() in UNSEEN

private val UNSEEN = setOf(Character.FORMAT, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR, Character.SURROGATE)
