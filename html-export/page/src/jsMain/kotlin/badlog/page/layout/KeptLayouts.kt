package badlog.page.layout

import badlog.page.dom.LocalStorage
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.boardLayoutOf

/**
 * The layouts that the browser stores by name, for all logs and pages. Each is stored separately, so that two tabs do not overwrite each
 * other's layouts.
 */
internal class KeptLayouts {
    /** The name of the layout that was shown or stored last; null if there is none. */
    var shown: String? = null

    /** The names of the stored layouts, in alphabetical order. */
    val names: List<String> get() = LocalStorage.keys(KEY).map { it.removePrefix(KEY) }.sortedBy { it.lowercase() }

    /** Returns the layout named [name]; null if it was removed or cannot be read. */
    operator fun get(name: String): BoardLayout? = try {
        LocalStorage[KEY + name]?.let { boardLayoutOf(name, it) }
    } catch (_: BoardException) {
        null
    }

    /** Stores [layout] as [name] and replaces a layout of that name. Returns false if the browser forbids it or has no room. */
    fun keep(name: String, layout: BoardLayout): Boolean {
        val text = BoardLayout(layout.board, formulas = layout.formulas).toJson()
        LocalStorage[KEY + name] = text
        val isKept = LocalStorage[KEY + name] == text
        if (isKept) shown = name
        return isKept
    }

    /** Removes the layout named [name]. */
    fun remove(name: String) {
        LocalStorage.remove(KEY + name)
        if (shown == name) shown = null
    }

    private companion object {
        const val KEY = "layout:"
    }
}
