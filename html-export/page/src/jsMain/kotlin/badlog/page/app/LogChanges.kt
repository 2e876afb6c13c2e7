package badlog.page.app

import badlog.page.compare.CompareBar
import badlog.page.compare.PageComparison
import badlog.page.opened.LogOpening
import badlog.page.opened.OpenedLog
import badlog.page.view.Notice
import badlog.rules.Finding
import badlog.viewer.shown.folder.Changes
import org.w3c.dom.HTMLElement

/**
 * The differences between the shown log and the matches before it.
 *
 * @param page returns the element of the log's page, which is removed when another log is opened.
 * @param onShow shows the graph of a difference.
 */
internal class LogChanges(
    private val opening: LogOpening,
    private val comparison: PageComparison,
    private val compareBar: CompareBar,
    private val notice: Notice,
    private val page: () -> HTMLElement,
    private val onShow: (Finding) -> Unit,
) {
    private var now = Changes<OpenedLog>()

    /** The differences known so far. */
    val differences: List<Finding> get() = now.differences

    /**
     * Finds the differences now, and again when the rules have run over the log in its folder's list. Calls [onChange] when they change.
     */
    fun start(onChange: () -> Unit) {
        fun find() {
            val before = now
            now = opening.changes()
            if (now != before) onChange()
        }
        find()
        opening.onRead(::find)
    }

    /** Shows the graph of [difference] over the last earlier match that has the same number. */
    fun draw(difference: Finding) {
        onShow(difference)
        now.previous[difference]?.let(::compareWith)
    }

    private fun compareWith(listed: OpenedLog) {
        if (!listed.isHere) notice.say("Fetching ${listed.fileName}…")
        opening.withBytes(listed).then({ log ->
            val isCompared = log.files.any { it in comparison.files + compareBar.waiting }
            if (page().isConnected && !isCompared) compareBar.open(log.files)
        }, { if (page().isConnected) notice.say("${listed.fileName} cannot be fetched. ${it.message}") })
    }
}
