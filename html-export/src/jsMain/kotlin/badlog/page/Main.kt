package badlog.page

import badlog.page.reading.ReadingWorker

/** The script of an exported page. It is also the script of the worker that the page starts. */
internal fun main() {
    if (ReadingWorker.isHere) ReadingWorker.run() else Startup().run()
}
