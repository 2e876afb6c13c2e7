package badlog.plot.outline

import badlog.rules.signal.TARGET_WORDS
import badlog.rules.signal.wordsOf

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
