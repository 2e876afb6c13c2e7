package badlog.page

import badlog.core.analysis.LogView
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.page.app.LoadingScreen
import badlog.page.app.LogPage
import badlog.page.app.failureScreen
import badlog.page.app.setPageState
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.embedded.About
import badlog.page.embedded.GivenLayout
import badlog.page.embedded.PageSource
import badlog.page.embedded.findAdditions
import badlog.page.formula.Formulas
import badlog.page.header.AxisChoice
import badlog.page.header.Downloads
import badlog.page.header.ThemeSwitch
import badlog.page.reading.PartsReading
import badlog.page.reading.ReadLog
import badlog.page.reading.Reading
import badlog.protocol.PageAdditions
import badlog.rules.RuleSet
import badlog.signals.withSignals
import badlog.viewer.choices.formula.joined
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement

/** Starts the page: reads the recording and shows it, or says why it cannot be shown. Never leaves an empty page. */
internal class Startup {
    private val root = checkNotNull(document.getElementById("page")).unsafeCast<HTMLElement>()
    private val theme = ThemeSwitch { page?.repaint() }
    private val source = PageSource(root)
    private var page: LogPage? = null

    /** Starts the page. */
    fun run() {
        setPageState("loading")
        guarded(::begin)
    }

    private fun guarded(work: () -> Unit) = try {
        work()
    } catch (problem: Throwable) {
        failUnexpectedly(problem)
    }

    /** Reads a large recording while it arrives, any other once the page has been loaded. */
    private fun begin() {
        // Read before looking: what arrives later is looked for again.
        val isLoaded = document.asDynamic().readyState != "loading"
        val element = document.getElementById("recording")
        val loading = element?.let { LoadingScreen(it.getAttribute("data-name").orEmpty()) }
        val reading = element?.let { PartsReading.start(it, checkNotNull(loading)::show) }
        when {
            reading != null -> {
                show(checkNotNull(loading).element)
                val additions = findAdditions()
                // Anything wrong with the parts will show when the whole stream is read.
                reading.then({ read ->
                    show(ReadLog(read, isDamaged = false), additions, checkNotNull(About.find()), element)
                }, { whenLoaded(::readWhole) }).catch(::failUnexpectedly)
            }

            isLoaded -> readWhole()

            element != null -> whenLoaded(::readWhole)

            else -> window.setTimeout({ guarded(::begin) }, PAUSE)
        }
    }

    /** Does [work] once the page has been loaded. */
    private fun whenLoaded(work: () -> Unit) {
        if (document.asDynamic().readyState != "loading") return work()
        document.addEventListener("DOMContentLoaded", { guarded(work) })
    }

    private fun readWhole() {
        val about = About.find()
        val recording = document.getElementById("recording")
        if (about == null || recording == null) {
            fail("This page is not complete", "Its end is missing: copy it again, or export it again.")
            return
        }
        val loading = LoadingScreen(about.name)
        show(loading.element)
        val reading = Reading(about, recording, loading::show).start()
        // Meanwhile, a worker is reading.
        val additions = findAdditions()
        reading.then { show(it, additions, about, recording) }
            .catch(::failUnexpectedly)
    }

    private fun show(read: ReadLog, additions: PageAdditions?, about: About, element: Element) {
        if (!read.isDamaged) return show(read.recording, additions, about, Downloads(about, element, read.recording))
        val look = element("div") {
            addButton("", "Show what it still has, without rules") {
                val withoutRules = (additions ?: PageAdditions()).withoutRules(DAMAGED)
                guarded { show(read.recording, withoutRules, about, Downloads(about, element, read.recording, isDamaged = true)) }
            }.id = "show-damaged"
        }
        fail("This page is not complete", "Its log was damaged in copying; export it again.", look)
    }

    private fun show(read: Recording, additions: PageAdditions?, about: About, downloads: Downloads) {
        val unreadable = read.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }
        if (unreadable != null) {
            fail("There is nothing to show of ${about.name}", unreadable.message, downloads.element)
            return
        }
        val signals = (additions?.rules ?: RuleSet.NONE).signals
        val layout = GivenLayout.of(additions?.layout)
        val given = joined(layout.formulas, additions?.virtualTopics.orEmpty())
        // The findings of a hook have the x axis of the exporter.
        val hasFound = additions != null && (additions.hooks.isNotEmpty() || additions.findings.isNotEmpty())
        val axis = AxisChoice(read, about.fileKey, mayAsk = !hasFound)
        val formulas = Formulas(LogView.of(axis.recording).withSignals(signals), signals, given, about.fileKey)
        val shown = LogPage(formulas, about, additions, layout, downloads, theme, axis.element, source)
        page = shown
        show(shown.element)
        shown.start()
        window.performance.asDynamic().mark("badlog-first-graphs")
        // After the browser's next frame.
        window.requestAnimationFrame {
            window.setTimeout({
                guarded {
                    shown.complete(formulas.given)
                    setPageState("ready")
                }
            }, 0)
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

    private companion object {
        /** Milliseconds until the page is checked again for what has arrived. */
        const val PAUSE = 5

        const val DAMAGED = "Damaged in copying: anything shown may be wrong. No rules ran. Export it again."
    }
}
