package badlog.page

import badlog.core.recording.Recording
import badlog.page.app.LogShowing
import badlog.page.app.ShownLog
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.embedded.About
import badlog.page.embedded.EmbeddedFile
import badlog.page.embedded.EmbeddedLog
import badlog.page.embedded.PageSource
import badlog.page.embedded.additions
import badlog.page.embedded.comparedFiles
import badlog.page.embedded.findAdditions
import badlog.page.linked.HandedFile
import badlog.page.linked.LinkedFile
import badlog.page.opened.LogOpening
import badlog.page.opened.OpenedLog
import badlog.page.opened.StartScreen
import badlog.page.opened.acceptFiles
import badlog.page.reading.PartsReading
import badlog.page.reading.ReadLog
import badlog.page.reading.Reading
import badlog.page.rules.AssignedSignals
import badlog.page.screen.LoadingScreen
import badlog.page.screen.PageRoot
import badlog.page.screen.setPageState
import badlog.protocol.PageAdditions
import badlog.rules.RuleSet
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Starts the page: reads its recording and shows it, or the reason why it cannot be shown. A page without a recording opens logs from
 * elsewhere.
 */
internal class Startup {
    private val main = checkNotNull(document.getElementById("page")).unsafeCast<HTMLElement>()
    private val root = PageRoot(main)
    private val source = PageSource(main)
    private var hasOpened = false
    private val logs: LogShowing = LogShowing(root, source) { opening }
    private val opening: LogOpening =
        LogOpening(root, ::rules, { logs.theme.element }, ::goToStart, ::showOpened, ::showGrown)

    private fun rules() = AssignedSignals.over(findAdditions()?.rules ?: RuleSet.NONE)

    /** Starts reading. The page then shows its recording, the logs of its server, or the start screen. */
    fun run() {
        setPageState("loading")
        root.guarded(::begin)
    }

    /** Reads a large recording while it arrives, all others once the page has been loaded. */
    private fun begin() {
        // Read first, so that an element that arrives later is looked for again.
        val isLoaded = document.asDynamic().readyState != "loading"
        val element = document.getElementById("recording")
        val loading = element?.let { LoadingScreen(it.getAttribute("data-name").orEmpty()) }
        val reading = element?.let { PartsReading.start(it, checkNotNull(loading)::show) }
        when {
            reading != null -> {
                root.showAlone(checkNotNull(loading).element)
                val additions = findAdditions()
                // Errors in the parts are reported when the whole stream is read.
                reading.then({ read ->
                    show(ReadLog(read, isDamaged = false), additions, checkNotNull(About.find()), element)
                }, { whenLoaded(::readWhole) }).catch(root::failUnexpectedly)
            }

            isLoaded -> readWhole()

            element != null -> whenLoaded(::readWhole)

            else -> window.setTimeout({ root.guarded(::begin) }, PAUSE)
        }
    }

    /** Does [work] once the page has been loaded. */
    private fun whenLoaded(work: () -> Unit) {
        if (document.asDynamic().readyState != "loading") return work()
        document.addEventListener("DOMContentLoaded", { root.guarded(work) })
    }

    private fun readWhole() {
        val about = About.find() ?: return root.fail("This page is not complete", "Its end is missing: copy it again, or export it again.")
        val recording = document.getElementById("recording") ?: return if (about.isServed) opening.openServer() else goToStart()
        val loading = LoadingScreen(about.name)
        root.showAlone(loading.element)
        val reading = Reading(about, recording, loading::show).start()
        // Meanwhile, a worker is reading.
        val additions = findAdditions()
        reading.then { show(it, additions, about, recording) }
            .catch(root::failUnexpectedly)
    }

    private fun show(read: ReadLog, additions: PageAdditions?, about: About, element: Element) {
        val log = ShownLog(read.recording, about, EmbeddedLog(about, element), read.isDamaged, ::comparedFiles)
        if (!read.isDamaged) return logs.show(log, additions)
        val look = element("div") {
            addButton("", "Show what it still has, without rules") {
                val withoutRules = (additions ?: PageAdditions()).withoutRules(DAMAGED)
                root.guarded { logs.show(log, withoutRules) }
            }.id = "show-damaged"
        }
        root.fail("This page is not complete", "Its log was damaged in copying; export it again.", look)
    }

    /** Shows the page's own log, or the start screen if it has none. */
    private fun goToStart() {
        if (document.getElementById("recording") != null) return window.location.reload()
        val sample = document.getElementById("sample")
        val server = if (About.find()?.isServed == true) opening::openServer else null
        val start = StartScreen(logs.theme.element, opening::open, opening::open, server, sample?.let { { openSample(it) } })
        root.showAlone(start.element)
        acceptFiles(opening::open, opening::open)
        if (About.find()?.isOnWeb == true) awaitFromWeb(start)
        document.title = "badlog"
        setPageState("empty")
    }

    private fun awaitFromWeb(start: StartScreen) {
        LinkedFile.inAddress()?.let { linked ->
            val question = "A link wants to open “${linked.name}” from ${linked.host}. " +
                "It is requested from that site, and from any site to which that one redirects, without cookies."
            start.offer(question, "Fetch it from ${linked.host}") { opening.open(linked) }
        }
        HandedFile.await { handed ->
            start.offer("${handed.origin} wants to open “${handed.name}” here.", "Open it") { opening.open(listOf(handed.file())) }
        }
    }

    private fun openSample(sample: Element) {
        val name = sample.getAttribute("data-name").orEmpty()
        EmbeddedFile(sample).inflated().then({ opening.open(listOf(File(arrayOf<dynamic>(it), name))) }, root::failUnexpectedly)
    }

    private fun showOpened(log: OpenedLog, read: Recording, compared: List<File>, showsWorst: Boolean) {
        // A link belongs to the log that is opened first, as its sender intended.
        if (hasOpened || document.getElementById("recording") != null) forgetAddress()
        hasOpened = true
        logs.show(shownOf(log, read, compared), additionsOf(log), showsWorst, onLaidOut = root::focus)
    }

    private fun showGrown(log: OpenedLog, read: Recording) = logs.showGrown(shownOf(log, read, emptyList()), additionsOf(log))

    private fun additionsOf(log: OpenedLog): PageAdditions? {
        val own = findAdditions()?.ofAnyLog() ?: return null
        return log.files[0].additions?.let(own::withNotesOf) ?: own
    }

    private fun shownOf(log: OpenedLog, read: Recording, compared: List<File>): ShownLog {
        val version = About.find()?.version.orEmpty()
        return ShownLog(read, About.of(log.files, version, log.key), log.bytes(version), compared = { Promise.resolve(compared) })
    }

    private fun forgetAddress() = try {
        window.history.replaceState(window.history.state, "", window.location.href.substringBefore('#'))
    } catch (_: Throwable) {
        // Pages in some frames have no address of their own.
    }
}

/** The milliseconds between two checks for newly arrived text. */
private const val PAUSE = 5

private const val DAMAGED = "Damaged in copying: anything shown may be wrong. No rules ran. Export it again."
