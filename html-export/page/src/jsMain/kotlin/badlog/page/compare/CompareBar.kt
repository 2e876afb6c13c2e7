package badlog.page.compare

import badlog.core.recording.Recording
import badlog.page.dom.Icon
import badlog.page.dom.PageEvents
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.opened.OpenedLog
import badlog.page.reading.FileReading
import badlog.page.view.Notice
import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.choices.comparison.OFFSET_STEPS
import badlog.viewer.choices.comparison.OffsetStep
import badlog.viewer.choices.comparison.offsetOf
import badlog.viewer.choices.comparison.offsetText
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.shown.comparison.ComparedLog
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.HTMLSelectElement
import org.w3c.dom.asList
import org.w3c.files.File

/** The compared logs with their colors and offsets, and their alignment; hidden if there are none. */
internal class CompareBar(private val comparison: PageComparison, private val notice: Notice) {
    private lateinit var alignment: HTMLSelectElement
    private lateinit var logs: HTMLElement
    private val unread = ArrayList<OpenedLog>()
    private val failures = ArrayList<String>()

    private val input = element("input").unsafeCast<HTMLInputElement>().apply {
        type = "file"
        id = "compare-file"
        multiple = true
        isHidden = true
        setAttribute("aria-label", "Log to compare")
        addEventListener("change", {
            // The browser's own list becomes empty with the value.
            open(files?.asList().orEmpty().toList())
            value = ""
        })
    }

    val element: HTMLElement = element("section", "compare findings card") {
        id = "compare"
        setAttribute("aria-label", "Compared logs")
        add("header", "graph-head") {
            add("h2", "findings-title", "Compared")
            alignment = add("select").unsafeCast<HTMLSelectElement>()
            add("div", "graph-tools") {
                addIconButton("", Icon.PLUS, "Compare with another log") { input.click() }
                addIconButton("", Icon.CLOSE, "Stop comparing") { comparison.clear() }.id = "stop-comparing"
            }
        }
        logs = add("ul", "compared-logs")
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
        alignment.id = "alignment"
        alignment.setAttribute("aria-label", "Align at")
        for (way in Alignment.entries) {
            alignment.add("option", "", "Align: ${way.title}").apply {
                setAttribute("value", way.name)
                title = way.hint
            }
        }
        alignment.addEventListener("change", { comparison.alignBy(Alignment.valueOf(alignment.value)) })
        comparison.onChange(::list)
    }

    /** The files that are not read yet. */
    val waiting: List<File> get() = unread.flatMap { it.files }

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

    private fun list() {
        element.isHidden = comparison.drawn.isEmpty()
        alignment.value = comparison.alignment.name
        logs.textContent = ""
        logs.add("li", "compared-log") { addName(0, comparison.openName) }
        comparison.drawn.forEachIndexed { i, log -> logs.add("li", "compared-log") { fill(i, log) } }
    }

    private fun HTMLElement.fill(index: Int, log: ComparedLog) {
        val moveTo = { offset: Double -> comparison.move(index, offset) }
        val shown = offsetText(log.offset)
        val (back, on) = OFFSET_STEPS.partition { it.by < 0 }
        addName(index + 1, log.name)
        add("span", "compared-moves") {
            for (step in back) addStep(step, log) { moveTo(log.offset + step.by) }
            val typed = add("input", "compared-offset").unsafeCast<HTMLInputElement>()
            typed.value = shown
            typed.setAttribute("inputmode", "decimal")
            typed.setAttribute("aria-label", "Offset of ${log.name}")
            typed.addEventListener("change", { offsetOf(typed.value)?.let(moveTo) ?: run { typed.value = shown } })
            for (step in on) addStep(step, log) { moveTo(log.offset + step.by) }
            addIconButton("", Icon.CLOSE, "Stop comparing with ${log.name}") { comparison.remove(index) }
        }
    }

    private fun HTMLElement.addName(color: Int, name: String) {
        add("span", "swatch line-${color % LINE_COLORS}")
        add("bdi", "", name)
    }

    private fun HTMLElement.addStep(step: OffsetStep, log: ComparedLog, onClick: () -> Unit) {
        val hint = step.hintFor(log.name)
        addButton("compared-step", step.label, hint, onClick).setAttribute("aria-label", hint)
    }
}
