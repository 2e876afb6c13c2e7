package badlog.viewer.shown.outline

import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf

/**
 * The meaning of a topic's name, and whether the topic is a target or an actual value. Two topics are target and actual of one thing if
 * their [words] are the same and one of them [isTarget]:
 *
 * - A name is split into words, including the words of its folders: `Chassis/ActualFrontLeft/speed` is *chassis actual front left speed*.
 * - One of the [TARGET_WORDS] makes it a target; that word is dropped: *chassis front left speed*. A name with two is neither.
 * - One of the [ACTUALS] is dropped from any other name. *Current* counts only before the word it describes, as in *current angle*: at
 *   the end of a name, it means amperes.
 *
 * @property words the remaining words of the name, in lower case.
 * @property isTarget whether the name says that this is a target.
 * @property isBare whether the last part of the name has no other meaning, as in `Arm/Goal`.
 */
internal class TargetName private constructor(val words: List<String>, val isTarget: Boolean, val isBare: Boolean) {
    companion object {
        /** Returns the meaning of [name]; null if it is not clear. */
        fun of(name: String): TargetName? {
            val words = wordsOf(name)
            val targets = words.indices.filter { words[it] in TARGET_WORDS }
            if (targets.size > 1) return null
            val target = targets.firstOrNull()
            if (target != null) {
                return TargetName(words.without(target), isTarget = true, isBare = wordsOf(name.substringAfterLast('/')).size == 1)
            }
            val actual = words.indices.singleOrNull { words[it] in ACTUALS && (words[it] != CURRENT || it < words.lastIndex) }
            return TargetName(if (actual == null) words else words.without(actual), isTarget = false, isBare = false)
        }

        private fun List<String>.without(index: Int) = filterIndexed { i, _ -> i != index }

        private const val CURRENT = "current"

        /** Words for an actual value. */
        private val ACTUALS = setOf("actual", "actuals", "measured", "measurement", "current", "observed", "feedback", "estimated")
    }
}
