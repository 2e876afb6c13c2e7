package badlog.viewer.text

/** The words of what a person searches for, which must all be found. */
internal fun wordsOf(text: String): List<String> = text.trim().split(' ', '\t').filter { it.isNotEmpty() }
