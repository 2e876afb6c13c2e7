package badlog.page

import badlog.analysis.LogView
import badlog.page.embedded.About
import badlog.page.embedded.findAdditions
import badlog.page.formula.Formulas
import badlog.page.reading.Reading
import badlog.page.section.Downloads
import badlog.page.section.LoadingScreen
import badlog.page.section.LogPage
import badlog.page.section.ThemeSwitch
import badlog.page.section.failureScreen
import badlog.page.section.setPageState
import badlog.recording.ProblemKind
import badlog.recording.Recording
import badlog.rules.RuleSet
import badlog.rules.withSignals
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement
import kotlin.js.Promise

/** Brings the page up: reads the recording, shows it, or says why it cannot be shown. Never leaves an empty page. */
internal class Startup {
    private val root = checkNotNull(document.getElementById("page")).unsafeCast<HTMLElement>()
    private val theme = ThemeSwitch { page?.repaint() }
    private var page: LogPage? = null

    /** Does it. */
    fun run() {
        setPageState("loading")
        try {
            load()
        } catch (problem: Throwable) {
            failUnexpectedly(problem)
        }
    }

    private fun load() {
        val about = About.find()
        val recording = document.getElementById("recording")
        if (about == null || recording == null) {
            fail("This page is not complete", "Its end is missing; it may have been cut in copying. Export it again.")
            return
        }
        val loading = LoadingScreen(about.name)
        show(loading.element)
        Reading(about, recording, loading::show).start()
            .then { show(it, about, recording) }
            .catch(::failUnexpectedly)
    }

    private fun show(read: Recording, about: About, element: Element) {
        val downloads = Downloads(about, element, read)
        val unreadable = read.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }
        if (unreadable != null) {
            fail("There is nothing to show of ${about.name}", unreadable.message, downloads.element)
            return
        }
        val additions = findAdditions()
        val signals = (additions?.rules ?: RuleSet.NONE).signals
        val formulas = Formulas(LogView.of(read).withSignals(signals), signals, additions?.virtualTopics.orEmpty(), about.fileKey)
        val shown = LogPage(formulas, about, additions, downloads, theme)
        page = shown
        show(shown.element)
        shown.start()
        setPageState("ready")
        // uPlot draws in a microtask; this one comes after it.
        Promise.resolve(Unit).then {
            window.performance.asDynamic().mark("badlog-first-graphs")
            shown.search(formulas.given)
        }
    }

    private fun show(element: HTMLElement) {
        root.textContent = ""
        root.appendChild(element)
    }

    private fun fail(title: String, explanation: String, tools: HTMLElement? = null) {
        setPageState("failed")
        show(failureScreen(title, explanation, tools))
    }

    private fun failUnexpectedly(problem: Throwable) {
        console.error(problem)
        val reason = problem.message ?: problem.toString()
        fail("Something went wrong", "$reason. Report it with the file, if you may share it.")
    }
}
