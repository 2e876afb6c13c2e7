package badlog.signals.vocabulary

/** Words for a target value. */
val TARGET_WORDS: Set<String> = setOf(
    "target", "targets", "setpoint", "setpoints", "goal", "goals", "desired", "reference", "ref", "commanded", "command", "cmd",
    "demand", "demanded", "requested", "wanted", "optimized", "set",
)

/** Returns the words of [name] in lower case, split at anything but letters and digits, before capitals, and before digits. */
fun wordsOf(name: String): List<String> {
    val words = ArrayList<String>()
    var start = 0
    for (at in 1..name.length) {
        if (at < name.length && !isParted(name, at)) continue
        val word = name.substring(start, at).lowercase()
        start = at
        if (sortOf(word[0]) == OTHER) continue
        // “Set point” counts as one word, however it is written.
        if (word.startsWith("point") && words.lastOrNull() == "set") words[words.lastIndex] = "set$word" else words += word
    }
    return words
}

/** Returns whether a word begins in [name] at [at]. */
private fun isParted(name: String, at: Int): Boolean {
    val before = sortOf(name[at - 1])
    val here = sortOf(name[at])
    return when {
        before == CAPITAL && here == SMALL -> false

        // In CANLoad, the capital before a lower-case letter begins a word.
        before == CAPITAL && here == CAPITAL -> at + 1 < name.length && sortOf(name[at + 1]) == SMALL

        else -> before != here
    }
}

private fun sortOf(char: Char) = when {
    char in 'a'..'z' || char.code > ASCII -> SMALL
    char in 'A'..'Z' -> CAPITAL
    char in '0'..'9' -> DIGIT
    else -> OTHER
}

private const val SMALL = 0
private const val CAPITAL = 1
private const val DIGIT = 2
private const val OTHER = 3
private const val ASCII = 0x7F
