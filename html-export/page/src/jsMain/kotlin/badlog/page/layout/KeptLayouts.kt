package badlog.page.layout

import badlog.page.dom.LocalStorage
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.boardLayoutOf

/**
 * The layouts that the browser keeps, by name, for all logs and pages. Each has a place of its own there, so that two tabs do not overwrite
 * each other's.
 */
internal class KeptLayouts {
    /** The name of the one whose graphs the reader asked for last; null for none. */
    var shown: String? = null

    /** Their names, in order. */
    val names: List<String> get() = LocalStorage.keys(KEY).map { it.removePrefix(KEY) }.sortedBy { it.lowercase() }

    /** Returns the one called [name]; null where it is gone, or cannot be read. */
    operator fun get(name: String): BoardLayout? = try {
        LocalStorage[KEY + name]?.let { boardLayoutOf(name, it) }
    } catch (_: BoardException) {
        null
    }

    /** Keeps [layout] as [name], instead of one of that name. Returns false if the browser does not let the page, or has no room. */
    fun keep(name: String, layout: BoardLayout): Boolean {
        val text = BoardLayout(layout.board, formulas = layout.formulas).toJson()
        LocalStorage[KEY + name] = text
        val isKept = LocalStorage[KEY + name] == text
        if (isKept) shown = name
        return isKept
    }

    /** Forgets the one called [name]. */
    fun remove(name: String) {
        LocalStorage.remove(KEY + name)
        if (shown == name) shown = null
    }

    private companion object {
        const val KEY = "layout:"
    }
}
