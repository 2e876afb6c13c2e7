package badlog.page.app

import badlog.page.compare.CompareBar
import badlog.page.compare.PageComparison
import badlog.page.dom.element
import badlog.page.findings.changesList
import badlog.page.opened.LogOpening
import badlog.page.opened.OpenedLog
import badlog.page.view.Notice
import badlog.rules.Finding
import org.w3c.dom.HTMLElement

/**
 * What is unlike the matches before the shown log, and the graph of one of these differences over the last match that shows the same.
 *
 * @param onShow called with the difference that a person wants to see; shows its graph.
 */
internal class LogChanges(
    private val opening: LogOpening,
    private val comparison: PageComparison,
    private val compareBar: CompareBar,
    private val notice: Notice,
    private val onShow: (Finding) -> Unit,
) {
    val element: HTMLElement = element("div")

    /** Shows them, again whenever more of the list is known. */
    fun start() {
        show()
        opening.onRead(::show)
    }

    private fun show() {
        val found = opening.changes()
        element.textContent = ""
        val list = changesList(found) { difference ->
            onShow(difference)
            found.previous[difference]?.let(::compareWith)
        }
        list?.let(element::appendChild)
    }

    private fun compareWith(listed: OpenedLog) {
        if (!listed.isHere) notice.say("Fetching ${listed.fileName}…")
        opening.withBytes(listed).then({ log ->
            val isCompared = log.files.any { it in comparison.files + compareBar.waiting }
            if (element.isConnected && !isCompared) compareBar.open(log.files)
        }, { if (element.isConnected) notice.say("${listed.fileName} cannot be fetched. ${it.message}") })
    }
}
