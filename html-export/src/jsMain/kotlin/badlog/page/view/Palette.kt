package badlog.page.view

import badlog.recording.Severity
import kotlinx.browser.document
import kotlinx.browser.window

/** The colours that the canvases draw with, as the style sheet defines them for the theme of now. */
internal class Palette {
    private var lines = emptyList<String>()
    private var stateOpacity = ""
    private var severities = emptyList<String>()

    var text = ""
        private set
    var strong = ""
        private set
    var grid = ""
        private set
    var event = ""
        private set
    var surface = ""
        private set
    var off = ""
        private set
    var stateText = ""
        private set

    init {
        read()
    }

    /** The colour of line [index], from 0. */
    fun line(index: Int): String = lines[index % LINES]

    /** The colour of a block in state [index], from 0: a line's colour, quiet enough for text upon it. */
    fun state(index: Int): String = line(index) + stateOpacity

    /** The colour of what is of [severity]. */
    fun severity(severity: Severity): String = severities[severity.ordinal]

    /** Reads the colours again, after a change of theme. */
    fun read() {
        val style = window.getComputedStyle(checkNotNull(document.documentElement))
        fun colour(name: String) = style.getPropertyValue(name).trim()
        lines = List(LINES) { colour("--line-$it") }
        severities = listOf(colour("--muted"), colour("--warning"), colour("--error"))
        text = colour("--muted")
        strong = colour("--text")
        grid = colour("--grid")
        event = colour("--event")
        surface = colour("--surface")
        off = colour("--state-off")
        stateText = colour("--state-text")
        stateOpacity = colour("--state-opacity")
    }

    companion object {
        /** How many colours there are; further lines begin again. */
        const val LINES = 16
    }
}
