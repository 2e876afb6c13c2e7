package badlog.page.app

import badlog.core.analysis.GraphSeries
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.viewer.shown.cursor.spokenAt
import org.w3c.dom.HTMLElement

/** Announces cursor moves by keys, and the values there, to screen readers only. */
internal class LiveRegion(private val scene: Scene, private val lines: () -> List<GraphSeries>) {
    val element: HTMLElement = element("div", "spoken") {
        id = "spoken"
        setAttribute("role", "status")
    }

    /** Announces the position of the cursor that keys move, and the values there. */
    fun announceCursor() {
        val x = scene.cursor.now.moving ?: return
        element.showText(spokenAt(lines(), x, scene.xText(x)))
    }

    /** Announces [text]; it replaces a text that screen readers have not read yet. */
    fun announce(text: String) = element.showText(text)

    /** Announces [found], the finding at the cursor. */
    fun announceFinding(found: String) {
        val x = scene.cursor.now.pinned ?: return
        if (found.isNotEmpty()) element.showText("${scene.xText(x)}: $found")
    }
}
