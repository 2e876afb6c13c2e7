package badlog.viewer.input

/**
 * A key of page and window for anything but the graphs.
 *
 * @property group the heading in the help.
 * @property meaning the effect, for the help.
 * @property key the key in the window.
 * @property onPage the key on the page: browsers scroll with Page up and Page down.
 */
enum class ScreenKey(val group: String, val meaning: String, val key: KeyStroke, val onPage: KeyStroke = key) {
    /** Shows the log that arrived last, at its worst finding. */
    NEW_LOG("Logs", "Show the newest log, at its worst finding", KeyStroke("A")),

    /** Opens or closes the pit view. */
    PIT("Logs", "Pit view: the last logs in large letters, or back", KeyStroke("I")),

    /** Opens the previous log of the list. */
    PREVIOUS_LOG("Logs", "Open the previous log of the list", KeyStroke("Page up"), KeyStroke("Page up", alt = true)),

    /** Opens the next log of the list. */
    NEXT_LOG("Logs", "Open the next log of the list", KeyStroke("Page down"), KeyStroke("Page down", alt = true)),

    /** Opens or closes the help. */
    HELP("Help", "Open or close this help", KeyStroke("?")),
    ;

    /** The key's line in the help of a page. */
    val helpOnPage: HelpLine get() = HelpLine(group, onPage.text, meaning)

    companion object {
        /** Returns the page's key for [key], written as in [KeyStroke.key], with these modifiers; null if there is none. */
        fun onPage(key: String, shift: Boolean, alt: Boolean): ScreenKey? =
            entries.firstOrNull { it.onPage.run { this.key == key && this.alt == alt && (this.shift == shift || isSign) } }
    }
}
