package badlog.page.compare

import badlog.core.recording.Recording
import badlog.page.dom.Icon
import badlog.page.dom.PageEvents
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.fileInput
import badlog.page.dom.isHidden
import badlog.page.opened.OpenedLog
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.reading.FileReading
import badlog.page.view.Scene
import badlog.viewer.panel.comparePanel
import badlog.viewer.state.CompareRequest
import org.w3c.dom.HTMLElement
import org.w3c.files.File

/** The compared logs, see [comparePanel], and the button that opens one; hidden if there are none. */
internal class CompareBar(private val comparison: PageComparison, private val scene: Scene) {
    private val nodes = PartNodes(scene.palette, scene.store::send)
    private val notice = scene.notice
    private val unread = ArrayList<OpenedLog>()
    private val failures = ArrayList<String>()

    private val input = fileInput("compare-file", "Log to compare", onFiles = ::open).apply { multiple = true }

    val element: HTMLElement = element("section", "compare findings card") {
        id = "compare"
        setAttribute("aria-label", "Compared logs")
        isHidden = true
    }

    /** The button that opens a log to compare. */
    val button: HTMLElement = element("div", "downloads") {
        addButton("", "", "Draw another log over this one, or drop one on the page") { input.click() }.apply {
            id = "compare-button"
            appendChild(Icon.COMPARE.draw())
            add("span", "", "Compare")
        }
        appendChild(input)
    }

    init {
        comparison.onChange {
            val parts = comparePanel(comparison.alignment, comparison.openName, comparison.drawn)
            element.patch(nodes.of(parts))
            element.isHidden = parts.isEmpty()
        }
    }

    /** The files that are not read yet. */
    val waiting: List<File> get() = unread.flatMap { it.files }

    /** Performs [request]. */
    fun perform(request: CompareRequest) = when (request) {
        CompareRequest.Choose -> input.click()
        CompareRequest.Clear -> comparison.clear()
        is CompareRequest.Align -> comparison.alignBy(request.alignment)
        is CompareRequest.Move -> comparison.move(request.log, request.offset)
        is CompareRequest.Remove -> comparison.remove(request.log)
    }

    /** Reads the logs in [files], one after the other, and compares them. */
    fun open(files: List<File>) {
        val isReading = unread.isNotEmpty()
        unread += OpenedLog.logsIn(files)
        if (!isReading) readNext()
    }

    private fun readNext() {
        val log = unread.firstOrNull()
        if (log == null) {
            notice.endProgress()
            // Shown at the end, because the progress of the other logs would replace it.
            notice.say(*failures.toTypedArray())
            failures.clear()
            return
        }
        val name = log.fileName
        lateinit var reading: FileReading
        val cancel = {
            reading.cancel()
            unread.clear()
        }
        reading = FileReading(log.files) { share -> notice.show("Reading $name: ${(share * 100).toInt()} %", cancel) }
        PageEvents.onEnd(cancel)
        notice.show("Reading $name…", cancel)
        reading.start().then({ accept(log, it.recording) }, { failures += "$name cannot be read: ${it.message}. Open it again." }).then {
            unread -= log
            readNext()
        }
    }

    private fun accept(log: OpenedLog, read: Recording) {
        val name = log.fileName
        val refusal = read.refusal
        when {
            refusal != null -> failures += "$name: $refusal"
            read.topics.all { it.samples.isEmpty() } -> failures += "$name has no samples, so there is nothing to compare."
            else -> comparison.add(log, read)
        }
    }
}
