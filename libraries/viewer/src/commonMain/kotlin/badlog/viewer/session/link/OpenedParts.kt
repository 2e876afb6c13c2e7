package badlog.viewer.session.link

/**
 * The parts of a page that a reader has opened.
 *
 * @property search the text in the search box; may be empty.
 * @property hasValues whether the values at the cursor are open.
 * @property hasModules whether the modules of a swerve drive are open.
 * @property statistics the places on the board, from 1, of the graphs with open statistics.
 */
data class OpenedParts(
    val search: String = "",
    val hasValues: Boolean = false,
    val hasModules: Boolean = false,
    val statistics: List<Int> = emptyList(),
) {
    /** Returns everything except [search] for an address: `values;1;3` or `modules;1`. */
    internal fun toText(): String {
        val panels = listOfNotNull(VALUES.takeIf { hasValues }, MODULES.takeIf { hasModules })
        return (panels + statistics).joinToString(";")
    }
}

/** Returns the opened parts of [text], as [OpenedParts.toText] writes it, with [search]. Parts of a newer badlog are ignored. */
internal fun openedPartsOf(text: String, search: String): OpenedParts {
    val parts = text.split(';')
    val statistics = parts.mapNotNull(String::toIntOrNull).filter { it > 0 }.distinct()
    return OpenedParts(search, VALUES in parts, MODULES in parts, statistics)
}

private const val VALUES = "values"
private const val MODULES = "modules"
