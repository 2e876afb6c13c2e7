package badlog.page

import badlog.page.opened.SummaryWorker
import badlog.page.reading.ReadingWorker
import badlog.page.rules.RulesWorker

/** The script of an exported page. It is also the script of the worker that the page starts. */
internal fun main() {
    when {
        !ReadingWorker.isHere -> Startup().run()
        RulesWorker.isHere -> RulesWorker.run()
        SummaryWorker.isHere -> SummaryWorker.run()
        else -> ReadingWorker.run()
    }
}
