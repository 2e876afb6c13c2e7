package badlog.page.view

import badlog.core.analysis.Graph
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.session.gesture.PlotDrag
import badlog.viewer.session.gesture.PlotTarget
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import kotlinx.browser.window

/** Runs [work] once before the browser's next frame, however often it is requested. */
internal class Frame(private val work: () -> Unit) {
    private var isAsked = false

    /** Requests [work]. */
    fun ask() {
        if (isAsked) return
        isAsked = true
        window.requestAnimationFrame {
            isAsked = false
            work()
        }
    }
}

/** The target of gestures on the page: they change the reader’s place. */
internal open class SceneTarget(private val scene: Scene) : PlotTarget {
    override val place: Place get() = scene.store.place
    override var drag: PlotDrag? = null

    override fun send(action: Action) = scene.store.send(action)
}

/**
 * Returns the graphs that draw [spec]: numbers first, then states, which cannot share a frame with numbers. Each graph comes with the
 * board's names for its lines, as far as [lines] contains them.
 */
internal fun graphsOf(spec: BoardGraph, lines: BoardLines): List<Pair<Graph, List<String>>> {
    val found = spec.lines.mapNotNull { name -> lines[name]?.let { name to it } }
    return found.partition { (_, line) -> line.states == null }.toList().filter { it.isNotEmpty() }.map { part ->
        val series = part.map { it.second }
        Graph(spec.title, series[0].unit, isVirtual = false, spec.isFilled, spec.includesZero, series) to part.map { it.first }
    }
}
