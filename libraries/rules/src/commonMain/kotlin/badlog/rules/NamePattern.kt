package badlog.rules

/**
 * A topic's name, or a pattern for names: `*` stands for anything, regardless of case, and where the pattern has a space, `_`, `-`
 * or nothing may stand too: `*battery voltage` fits `System/BatteryVoltage`.
 */
internal class NamePattern(val text: String) {
    private val parts = text.split('*').map(::folded)

    fun matches(name: String): Boolean {
        val subject = folded(name)
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

    private companion object {
        fun folded(text: String) = text.lowercase().filter { it !in " _-" }
    }
}
