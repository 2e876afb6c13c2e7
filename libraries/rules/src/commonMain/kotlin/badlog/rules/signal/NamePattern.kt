package badlog.rules.signal

/**
 * A topic's name, or a pattern for names: `*` stands for anything, regardless of case, and where the pattern has a space, `_`, `-`
 * or nothing may stand too: `*battery voltage` fits `System/BatteryVoltage`.
 *
 * @property text the pattern as it was written.
 */
public class NamePattern(public val text: String) {
    private val parts = text.split('*').map(::folded)

    /** Whether it fits [name], from its first letter to its last. */
    public fun matches(name: String): Boolean = matchesFolded(folded(name))

    /** Whether it fits the name of which [folded] made [subject]. */
    internal fun matchesFolded(subject: String): Boolean {
        if (parts.size == 1) return subject == parts[0]
        if (!subject.startsWith(parts.first())) return false
        var at = parts.first().length
        for (part in parts.subList(1, parts.size - 1)) {
            val found = subject.indexOf(part, at)
            if (found < 0) return false
            at = found + part.length
        }
        return subject.length - parts.last().length >= at && subject.endsWith(parts.last())
    }

    /**
     * The part of [name], which it fits, up to where its last `*` ends: `Left` of `Left Velocity` for `*velocity`. Topics of one
     * device have it in common.
     */
    internal fun deviceIn(name: String): String {
        var end = name.length
        var left = if (parts.size == 1) 0 else parts.last().length
        while (end > 0 && left > 0) if (isFolded(name[--end])) left--
        return name.substring(0, end).trimEnd('/', ' ', '_', '-', '.')
    }

    override fun equals(other: Any?): Boolean = other is NamePattern && other.text == text

    override fun hashCode(): Int = text.hashCode()

    internal companion object {
        /** [text] as patterns compare it. */
        fun folded(text: String): String = text.lowercase().filter(::isFolded)

        private fun isFolded(char: Char) = char !in " _-"
    }
}
