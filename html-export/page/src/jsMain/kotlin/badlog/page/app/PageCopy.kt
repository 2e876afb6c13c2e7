package badlog.page.app

import badlog.page.compare.CompareBar
import badlog.page.compare.PageComparison
import badlog.page.dom.saveFile
import badlog.page.embedded.About
import badlog.page.view.Notice
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Saves copies of the page, including the logs that it compares.
 *
 * @param copyWith makes a copy with the compared files, without the removed ones.
 */
internal class PageCopy(
    private val about: About,
    private val notice: Notice,
    private val comparison: PageComparison,
    private val compareBar: CompareBar,
    private val copyWith: (compared: List<File>, removed: List<File>) -> Promise<Blob>,
) {
    /** Saves a copy. */
    fun save() {
        val compared = comparison.files + compareBar.waiting
        Promise.resolve(Unit).then { copyWith(compared, comparison.removed) }
            .then { saveFile(it, about.name.substringBeforeLast('.') + ".html") }
            .catch { notice.say("This page could not be copied: ${it.message}. Export the log again.") }
    }
}
