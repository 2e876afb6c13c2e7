package badlog.page.opened

import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Palette
import badlog.viewer.panel.Table
import badlog.viewer.panel.folder.topicsOfLogs
import badlog.viewer.state.FolderAction
import badlog.viewer.state.TopicsState
import org.w3c.dom.HTMLElement

/** One statistic of each topic in several logs, see [topicsOfLogs]. */
internal class LogStatistics {
    private var logs = emptyList<OpenedLog>()
    private var state = TopicsState()
    private lateinit var tools: HTMLElement
    private lateinit var table: HTMLElement

    // No picture needs colors.
    private val nodes = PartNodes(Palette()) { action ->
        if (action is FolderAction.MeasureTopics) state = action.state
        fill()
    }

    val element: HTMLElement = element("section", "log-statistics card") {
        setAttribute("aria-label", "Statistics of the checked logs")
        tools = add("div", "log-tools")
        table = add("div", "statistics-scroll")
        isHidden = true
    }

    /** Shows the statistics of [logs]; hidden if there are none. */
    fun show(logs: List<OpenedLog>) {
        // The list is updated several times a second while logs are read.
        if (logs == this.logs) return
        this.logs = logs
        element.isHidden = logs.isEmpty()
        fill()
    }

    private fun fill() {
        val parts = if (logs.isEmpty()) emptyList() else topicsOfLogs(logs, state)
        tools.patch(nodes.of(parts.takeWhile { it !is Table }))
        table.patch(nodes.of(parts.dropWhile { it !is Table }))
    }
}
