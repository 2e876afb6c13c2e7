package badlog.page.view

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport

/** The part of the x axis that every graph of the page shows; calls its listeners after each change. */
internal class VisibleRange(viewport: Viewport) {
    /** The current and previous visible ranges. */
    var viewport: Viewport = viewport
        private set

    private val listeners = ArrayList<() -> Unit>()

    val full: Span get() = viewport.full
    val now: Span get() = viewport.visible
    val isZoomed: Boolean get() = viewport.isZoomed
    val canGoBack: Boolean get() = viewport.canGoBack

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Changes the visible range by [step]. */
    fun change(step: Viewport.() -> Viewport) {
        val before = now
        viewport = viewport.step()
        if (now != before) for (listener in listeners) listener()
    }
}
