package badlog.viewer.session.link

/**
 * What a reader has opened on a page.
 *
 * @property search the text in the search box; empty for none.
 * @property hasValues whether the values at the cursor are open.
 * @property hasModules whether the modules of a swerve drive are open.
 * @property statistics the places on the board, from 1, of the graphs whose statistics are open.
 */
data class OpenedParts(
    val search: String = "",
    val hasValues: Boolean = false,
    val hasModules: Boolean = false,
    val statistics: List<Int> = emptyList(),
) {
    /** Returns all but [search] for an address: `values;1;3` or `modules;1`. */
    internal fun toText(): String {
        val panels = listOfNotNull(VALUES.takeIf { hasValues }, MODULES.takeIf { hasModules })
        return (panels + statistics).joinToString(";")
    }
}

/** Returns what [text] from [OpenedParts.toText] says, with [search]; what a newer badlog can open is ignored. */
internal fun openedPartsOf(text: String, search: String): OpenedParts {
    val parts = text.split(';')
    val statistics = parts.mapNotNull(String::toIntOrNull).filter { it > 0 }.distinct()
    return OpenedParts(search, VALUES in parts, MODULES in parts, statistics)
}

private const val VALUES = "values"
private const val MODULES = "modules"
