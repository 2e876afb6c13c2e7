package badlog.page.linked

/**
 * Returns the file name [name], given by a link or another site, without characters that could disguise it in a prompt. At most 100
 * characters; `log` if none are left.
 */
internal fun fileNameOf(name: String): String = name.filter { it >= ' ' && it !in "“”\u007F" && it !in INVISIBLE && it !in DIRECTIONS }
    .take(MAX_NAME).ifEmpty { "log" }

private const val MAX_NAME = 100

/** Characters without a width, and characters that change the direction of writing. */
private val INVISIBLE = '\u200B'..'\u202E'
private val DIRECTIONS = '\u2060'..'\u2069'
