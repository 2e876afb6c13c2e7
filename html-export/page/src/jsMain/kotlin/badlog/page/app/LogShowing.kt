package badlog.page.app

import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.page.dom.PageEvents
import badlog.page.embedded.About
import badlog.page.embedded.GivenLayout
import badlog.page.embedded.LogBytes
import badlog.page.embedded.PageSource
import badlog.page.formula.Formulas
import badlog.page.header.AxisChoice
import badlog.page.header.Downloads
import badlog.page.header.ThemeSwitch
import badlog.page.opened.LogOpening
import badlog.page.rules.AssignedSignals
import badlog.page.screen.PageRoot
import badlog.page.screen.setPageState
import badlog.protocol.PageAdditions
import badlog.rules.RuleSet
import badlog.signals.withSignals
import badlog.viewer.choices.formula.joined
import badlog.viewer.choices.note.NoteHistory
import badlog.viewer.session.link.pageAddressOf
import kotlinx.browser.window
import org.w3c.files.File
import kotlin.js.Promise

/**
 * A log to show.
 *
 * @property bytes the bytes of its file.
 * @property isDamaged whether the page that holds it was changed since it was exported.
 * @property compared returns the files of the logs that are compared with it from the beginning.
 */
internal class ShownLog(
    val read: Recording,
    val about: About,
    val bytes: LogBytes,
    val isDamaged: Boolean = false,
    val compared: () -> Promise<List<File>>,
)

/** Shows logs on the page, one at a time. */
internal class LogShowing(private val root: PageRoot, private val source: PageSource, private val opening: () -> LogOpening) {
    private var page: LogPage? = null

    /** The formulas of the log that is shown, or will be shown once they are calculated. */
    private var calculating: Formulas? = null

    /** The theme, which all logs share. */
    val theme: ThemeSwitch = ThemeSwitch { page?.repaint() }

    /** Shows [log], which has grown, at its newest moment. The rest of the page stays as the reader left it. */
    fun showGrown(log: ShownLog, additions: PageAdditions?) {
        val left = page?.left
        val top = window.scrollY
        show(log, additions, left = left) { window.scrollTo(0.0, top) }
    }

    /**
     * Shows [log] with the additions [given] to the page for it.
     *
     * @param showsWorst whether to go to the worst finding once the rules have run.
     * @param left the state of the page that showed less of this log; null for a log that was not shown before.
     * @param onLaidOut called each time more of the page is laid out.
     */
    fun show(log: ShownLog, given: PageAdditions?, showsWorst: Boolean = false, left: PageSnapshot? = null, onLaidOut: () -> Unit = {}) {
        val about = log.about
        val downloads = Downloads(about, log.bytes, log.read, log.isDamaged)
        log.read.refusal?.let { return root.fail("There is nothing to show in ${about.name}", it, downloads.element) }
        val named = AssignedSignals.of(log.read)
        val additions = given?.let { it.with(AssignedSignals.over(it.rules, named)) }
        val signals = (additions?.rules ?: RuleSet.NONE).signals
        val layout = GivenLayout.of(additions?.layout)
        val definitions = joined(layout.formulas, additions?.virtualTopics.orEmpty())
        // The findings of a hook have the exporter's x axis.
        val hasFound = additions != null && (additions.hooks.isNotEmpty() || additions.findings.isNotEmpty())
        val again = { root.guarded { show(log, given, showsWorst) } }
        val axis = AxisChoice(log.read, about.fileKey, mayAsk = !hasFound, onChange = again)
        val formulas = Formulas(LogView.of(axis.recording).withSignals(signals, about.name), signals, definitions, about.fileKey)
        val copyWith = { notes: NoteHistory, board: String, compared: List<File>, removed: List<File> ->
            val rules = additions?.rules?.takeIf { named.isNotEmpty() }
            source.copyWith(notes, board, rules, log.bytes.toMarkup(), compared, removed)
        }
        val makePage = { LogPage(formulas, about, additions, layout, downloads, theme, axis.element, again, opening(), copyWith) }
        setPageState("loading")
        calculating?.cancel()
        calculating = formulas
        // The reader may leave meanwhile.
        PageEvents.onEnd(formulas::cancel)
        formulas.onFailure = root::failUnexpectedly
        val linked = if (left == null) pageAddressOf(window.location.hash).formulas else emptyList()
        formulas.start(linked) {
            root.guarded { show(makePage, left, onLaidOut) { it.complete(formulas.given, log.compared(), showsWorst) } }
        }
        // New samples are drawn at once, because the log may grow again before several slices are done.
        if (left != null) formulas.finish()
    }

    private fun show(makePage: () -> LogPage, left: PageSnapshot?, onLaidOut: () -> Unit, complete: (LogPage) -> Unit) {
        root.clear()
        val shown = makePage()
        page = shown
        // Nothing may keep a log in memory that is not shown.
        PageEvents.onEnd {
            page = null
            calculating = null
        }
        root.show(shown.element)
        shown.start(left)
        onLaidOut()
        window.performance.asDynamic().mark("badlog-first-graphs")
        // After the browser's next frame.
        window.requestAnimationFrame {
            window.setTimeout({
                // The reader may have left in the meantime.
                if (page === shown) {
                    root.guarded {
                        complete(shown)
                        onLaidOut()
                        setPageState("ready")
                    }
                }
            }, 0)
        }
    }
}
