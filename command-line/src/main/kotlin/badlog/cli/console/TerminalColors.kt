package badlog.cli.console

/**
 * Colors on a terminal: for severities, titles of tables and errors. Colored parts are recognized by their place in the line.
 *
 * @param isOn false for no colors.
 */
internal class TerminalColors private constructor(private val isOn: Boolean) {
    /** Returns [line] of a result with its colors. */
    fun result(line: String): String {
        if (!isOn || line.isEmpty()) return line
        if (TITLES.containsMatchIn(line)) return painted(line, BOLD)
        val found = SEVERITY.find(line)?.groups?.get(1) ?: return line
        return line.replaceRange(found.range, painted(found.value, COLORS.getValue(found.value)))
    }

    /** Returns [line] of an error with its color. */
    fun failure(line: String): String = if (isOn && line.isNotEmpty()) painted(line, RED) else line

    private fun painted(text: String, color: String) = "$color$text$RESET"

    companion object {
        val NONE = TerminalColors(isOn = false)

        /**
         * Returns the colors of a stream if [isTerminal]. Returns no colors if the environment [variable] NO_COLOR turns them off, or the
         * terminal has none.
         */
        fun of(
            isTerminal: Boolean,
            system: String = System.getProperty("os.name"),
            variable: (String) -> String? = System::getenv,
        ): TerminalColors {
            val isRefused = !variable("NO_COLOR").isNullOrEmpty() || variable("TERM") == "dumb"
            // The console of older Windows prints colors as characters.
            val isAble = !system.startsWith("Windows") || listOf("WT_SESSION", "ANSICON", "TERM").any { variable(it) != null }
            return TerminalColors(isTerminal && isAble && !isRefused)
        }

        private const val RESET = "\u001b[0m"
        private const val BOLD = "\u001b[1m"
        private const val FAINT = "\u001b[2m"
        private const val RED = "\u001b[31m"
        private const val GREEN = "\u001b[32m"
        private const val YELLOW = "\u001b[33m"
        private const val CYAN = "\u001b[36m"

        private val COLORS = mapOf(
            "error" to RED,
            "warning" to YELLOW,
            "note" to CYAN,
            "hint" to CYAN,
            "then" to FAINT,
            "next" to FAINT,
            "ok" to GREEN,
            "missing" to YELLOW,
        )

        /** After an optional time, and before two spaces. */
        private val SEVERITY = Regex("^ *(?:-?[0-9.]+(?: [^ ]+)? +)?(${COLORS.keys.joinToString("|")})(?= {2})")
        private val TITLES = Regex("^(?:LOG|TOPIC|SIGNAL|Match) {2,}[A-Z]")
    }
}
