package badlog.plot.outline

/**
 * What the name of a topic is about, and whether it says what was wanted of that or what came of it. Two topics are target and actual of
 * one thing where [words] are the same and one of them [isTarget]:
 *
 * - A name is read as its words, those of its folders too: `Chassis/ActualFrontLeft/speed` is *chassis actual front left speed*.
 * - One word of [TARGET_WORDS] in it makes it a target; that word is left out: *chassis front left speed*. A name with two is neither.
 * - One word of [ACTUALS] is left out of any other name. *Current* is one only before what it describes, as in *current angle*: at the
 *   end of a name it is amperes.
 *
 * @property words what is left of the name, in lower case.
 * @property isTarget whether the name says that this was wanted.
 * @property isBare whether the last part of the name says nothing but that, as in `Arm/Goal`.
 */
internal class Thing private constructor(val words: List<String>, val isTarget: Boolean, val isBare: Boolean) {
    companion object {
        /** What [name] is about; null where that is not clear. */
        fun of(name: String): Thing? {
            val words = wordsOf(name)
            val targets = words.indices.filter { words[it] in TARGET_WORDS }
            if (targets.size > 1) return null
            val target = targets.firstOrNull()
            if (target != null) {
                return Thing(words.without(target), isTarget = true, isBare = wordsOf(name.substringAfterLast('/')).size == 1)
            }
            val actual = words.indices.singleOrNull { words[it] in ACTUALS && (words[it] != CURRENT || it < words.lastIndex) }
            return Thing(if (actual == null) words else words.without(actual), isTarget = false, isBare = false)
        }

        private fun List<String>.without(index: Int) = filterIndexed { i, _ -> i != index }

        private const val CURRENT = "current"

        /** What says that something came of it. */
        private val ACTUALS = setOf("actual", "actuals", "measured", "measurement", "current", "observed", "feedback", "estimated")
    }
}

/** What says that something was wanted. */
internal val TARGET_WORDS = setOf(
    "target", "targets", "setpoint", "setpoints", "goal", "goals", "desired", "reference", "ref", "commanded", "command", "cmd",
    "demand", "demanded", "requested", "wanted", "optimized",
)

/** The words of [name] in lower case: parted by what is no letter or digit, by capitals, and before digits. */
internal fun wordsOf(name: String): List<String> {
    val words = ArrayList<String>()
    var start = 0
    for (at in 1..name.length) {
        if (at < name.length && !isParted(name, at)) continue
        val word = name.substring(start, at).lowercase()
        start = at
        if (sortOf(word[0]) == OTHER) continue
        // A set point is one thing, however it is written.
        if (word.startsWith("point") && words.lastOrNull() == "set") words[words.lastIndex] = "set$word" else words += word
    }
    return words
}

/** Whether a word begins in [name] at [at]. */
private fun isParted(name: String, at: Int): Boolean {
    val before = sortOf(name[at - 1])
    val here = sortOf(name[at])
    return when {
        before == CAPITAL && here == SMALL -> false

        // Of CANLoad, the capital before a small letter begins a word.
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
