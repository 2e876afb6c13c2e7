package badlog.signals.vocabulary

/**
 * A topic's name, or a pattern for names. `*` matches anything, case is ignored, and a space in the pattern also matches `_`, `-` or
 * nothing: `*battery voltage` matches `System/BatteryVoltage`.
 *
 * @property text the pattern as it was written.
 */
class NamePattern(val text: String) {
    private val parts = text.split('*').map(::folded)

    /** Returns whether it matches all of [name]. */
    fun matches(name: String): Boolean = matchesFolded(folded(name))

    /** Returns whether it matches a name after [folded]. */
    fun matchesFolded(subject: String): Boolean {
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
     * Returns the part of [name], which it must match, up to the end of its last `*`. For example, `Left` in `Left Velocity` for
     * `*velocity`. Topics of the same device share it.
     */
    internal fun deviceIn(name: String): String {
        var end = name.length
        var left = if (parts.size == 1) 0 else parts.last().length
        while (end > 0 && left > 0) if (isFolded(name[--end])) left--
        return name.substring(0, end).trimEnd('/', ' ', '_', '-', '.')
    }

    override fun equals(other: Any?): Boolean = other is NamePattern && other.text == text

    override fun hashCode(): Int = text.hashCode()

    companion object {
        /** Returns [text] in the form that patterns compare. */
        fun folded(text: String): String = text.lowercase().filter(::isFolded)

        private fun isFolded(char: Char) = char !in " _-"
    }
}
