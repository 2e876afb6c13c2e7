package badlog.page.linked

/** Returns [name], which somebody else gave to a file, without what could make a question about it read differently: at most 100 characters. */
internal fun fileNameOf(name: String): String = name.filter { it >= ' ' && it !in "“”\u007F" && it !in INVISIBLE && it !in DIRECTIONS }
    .take(MAX_NAME).ifEmpty { "log" }

private const val MAX_NAME = 100

/** Characters without a width, and those that turn the direction of writing. */
private val INVISIBLE = '\u200B'..'\u202E'
private val DIRECTIONS = '\u2060'..'\u2069'
