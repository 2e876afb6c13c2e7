package badlog.architecture.english

/**
 * The accepted number of places in each module, which may only fall.
 *
 * @property accepted the numbers by module; a module without one accepts none.
 */
internal class Ratchet(val accepted: Map<String, Int>) {
    /** Returns the modules in [counts] with more places than accepted. */
    fun exceededBy(counts: Map<String, Int>): Map<String, Int> = counts.filter { (module, count) -> count > (accepted[module] ?: 0) }

    /** Returns this ratchet with the numbers in [counts], where they are lower or new. Modules that no longer exist are removed. */
    fun loweredTo(counts: Map<String, Int>): Ratchet =
        Ratchet(counts.mapValues { (module, count) -> minOf(count, accepted[module] ?: count) })

    /** Returns the content of its file: a line for each module. */
    fun text(): String = HEAD + accepted.toSortedMap().map { (module, count) -> "$module $count\n" }.joinToString("")

    companion object {
        private const val HEAD = "# The number of phrases that `lint` accepts in each module's comments and guides; see CONTRIBUTING.md.\n"

        /**
         * Returns the ratchet in [text].
         *
         * @throws IllegalStateException if a line is not a module and a number.
         */
        fun of(text: String): Ratchet = Ratchet(
            text.lines().filterNot { it.isBlank() || it.startsWith('#') }.associate { line ->
                val count = line.substringAfter(' ').toIntOrNull()
                checkNotNull(count) { "“$line” is not a module and a number; correct it, or remove it and run ./gradlew format." }
                line.substringBefore(' ') to count
            },
        )
    }
}
