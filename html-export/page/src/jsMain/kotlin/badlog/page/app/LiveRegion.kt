package badlog.page.app

import badlog.core.analysis.GraphSeries
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.viewer.shown.cursor.spokenAt
import org.w3c.dom.HTMLElement

/** Announces screen readers where a key has moved the cursor, and what is there; nobody else sees it. */
internal class LiveRegion(private val scene: Scene, private val lines: () -> List<GraphSeries>) {
    val element: HTMLElement = element("div", "spoken") {
        id = "spoken"
        setAttribute("role", "status")
    }

    /** Announces the place of the cursor that keys move, and the values there. */
    fun announceCursor() {
        val x = scene.cursor.now.moving ?: return
        element.showText(spokenAt(lines(), x, scene.xText(x)))
    }

    /** Announces [text]. */
    fun announce(text: String) = element.showText(text)

    /** Announces [found], what was found at the cursor. */
    fun announceFinding(found: String) {
        val x = scene.cursor.now.pinned ?: return
        if (found.isNotEmpty()) element.showText("${scene.xText(x)}: $found")
    }
}
