package badlog.viewer.shown.search

/** Words for the same thing: a search for one of them also finds the others. The glossary lists them. */
val SAME_WORDS: List<List<String>> = listOf(
    listOf("brownout", "browned out", "brown out"),
    listOf("autonomous", "auto"),
    listOf("power distribution", "powerdistribution", "pdp", "pdh"),
    listOf("setpoint", "target", "goal", "desired", "reference"),
    listOf("gyro", "imu", "navx", "pigeon"),
    listOf("temperature", "temp"),
    listOf("radio", "wireless", "wifi"),
)

/** Returns the further texts that a search for [word], in lower case, finds. They are other words for the same thing, and its stem. */
internal fun variantsOf(word: String): List<String> {
    val stem = stemOf(word)
    return (SAME_WORDS.filter { word in it || stem in it }.flatten() + stem).distinct() - word
}

/**
 * Returns whether [variant] of a word occurs in [text]. Short variants count only where a word begins: a search for `heading` finds
 * `Head Angle`, but not `overhead`.
 */
internal fun occursIn(text: String, variant: String): Boolean {
    var at = text.indexOf(variant)
    while (at > 0 && variant.length < LONG && text[at - 1] in 'a'..'z') at = text.indexOf(variant, at + 1)
    return at >= 0
}

/** Returns [word] without the ending of a plural or of a verb, if enough of it remains. */
private fun stemOf(word: String): String {
    if (word.any { it !in 'a'..'z' } || OTHER_ENDINGS.any { word.endsWith(it) }) return word
    val ending = ENDINGS.firstOrNull { word.endsWith(it) && word.length >= it.length + SHORTEST } ?: return word
    val stem = word.dropLast(ending.length)
    // As in slipping, but not in stalling and missed.
    val isDoubled = stem.length > SHORTEST && ending != "s" && stem.last() == stem[stem.length - 2] && stem.last() !in "aeioulsz"
    return if (isDoubled) stem.dropLast(1) else stem
}

private val ENDINGS = listOf("ing", "ed", "es", "s")

/** Endings that are neither of plurals nor of verbs: a bus, a loss, a speed. */
private val OTHER_ENDINGS = listOf("us", "ss", "is", "eed")
private const val SHORTEST = 4
private const val LONG = 5
