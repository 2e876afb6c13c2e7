package badlog.page.opened

import badlog.core.recording.Recording
import badlog.page.dom.Icon
import badlog.page.dom.PageEvents
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.json
import badlog.page.dom.screenKey
import badlog.page.embedded.logIn
import badlog.page.linked.LinkedFile
import badlog.page.reading.FileReading
import badlog.page.reading.MatchFiles
import badlog.page.reading.WantedTopics
import badlog.page.screen.LoadingScreen
import badlog.page.screen.PageRoot
import badlog.page.screen.setPageState
import badlog.page.served.Download
import badlog.page.served.ServedFolder
import badlog.page.served.served
import badlog.rules.RuleSet
import badlog.signals.overItsTime
import badlog.viewer.input.ScreenKey
import badlog.viewer.shown.folder.Changes
import badlog.viewer.state.Visit
import badlog.viewer.text.countText
import kotlinx.browser.document
import org.w3c.dom.HTMLElement
import org.w3c.dom.events.KeyboardEvent
import org.w3c.files.File
import org.w3c.files.FilePropertyBag
import kotlin.js.Promise

/**
 * Opens dropped or chosen files instead of the shown log.
 *
 * @param rules returns the rules of this page.
 * @param settings returns the settings that every page has.
 * @param goToStart goes back to the screen that was there before any log was opened.
 * @param show shows a log that was read, with others to compare.
 * @param showGrown shows a log that is already shown, at its newest moment.
 */
internal class LogOpening(
    private val root: PageRoot,
    private val rules: () -> RuleSet,
    private val settings: () -> HTMLElement,
    private val goToStart: () -> Unit,
    private val show: (OpenedLog, Recording, compared: List<File>, showsWorst: Boolean) -> Unit,
    private val showGrown: (OpenedLog, Recording) -> Unit,
) {
    private var log: OpenedLog? = null
    private var folder: FolderScreen? = null

    /** Opens the last log again; null before the first one. */
    private var again: (() -> Unit)? = null
    private val history = PageHistory({ if (it == Visit.LIST) folder != null else again != null }, ::showAgain)

    /** The button that follows the shown log while it grows. */
    val live: LiveButton = LiveButton({ log }) { grown, read ->
        log = grown
        showGrown(grown, read)
    }

    /** The number of the latest request; results of earlier requests are no longer shown. */
    private var request = 0

    /** Cancels the work for the last request. */
    private var cancelLast = {}
    private var onRead = {}

    /** Opens the only log in [files], or lists all of them. */
    fun open(files: List<File>) {
        again = { open(files) }
        val only = files.singleOrNull()
        if (only != null && isZip(only)) return openMatch(only.name, matchInZip(only)) {}
        val manifest = files.find(::isManifest) ?: return matchTogether(files)?.let { read(it.first, it.second) } ?: openLogs(files)
        openMatch(OpenedLog.pathOf(manifest).substringBefore('/', "match"), matchAmong(files)) { openLogs(files) }
    }

    private fun openLogs(files: List<File>) {
        val only = files.singleOrNull()
        val advice = only?.let { adviceFor(it.name) }
        // A single file was selected by name, so it may have any name.
        val logs = OpenedLog.logsIn(if (only != null) files else files.filter(OpenedLog::isNamedLikeLog))
        val pages = files.count { isPage(it.name) }
        when {
            files.isEmpty() -> return
            only != null && pages > 0 -> openPage(only)
            only != null && advice != null -> fail("This page cannot read ${only.name}", advice)
            logs.isEmpty() && pages > 0 -> fail("There is no log here", "badlog pages are opened one at a time.")
            logs.isEmpty() -> fail("There is no log here", "None of these ${countText(files.size, "file")} is a log.")
            logs.size == 1 && pages == 0 -> open(logs[0])
            else -> list(logs, logs.first().path.substringBefore('/', "Logs"), again = null, pages)
        }
    }

    /** Opens the logs of the match that [found] promises as one log, which is named after [name]; if it is null, calls [otherwise]. */
    private fun openMatch(name: String, found: Promise<MatchFiles?>, otherwise: () -> Unit) {
        val asked = wait(name) {}
        found.then({ match ->
            when {
                !asked.isLatest -> Unit
                match == null -> otherwise()
                else -> read(name, match)
            }
        }, { if (asked.isLatest) refuse(name, it, emptyList()) }).catch { root.failUnexpectedly(it, back()) }
    }

    private fun read(name: String, match: MatchFiles) {
        lateinit var reading: FileReading
        val asked = wait(name) { reading.cancel() }
        reading = FileReading(match, rules(), asked.screen::show)
        val logs = match.logs.values.map { OpenedLog(it) }
        reading.start().then({ read ->
            val time = json("lastModified" to logs[0].modified.toDouble()).unsafeCast<FilePropertyBag>()
            val made = File(arrayOf(checkNotNull(read.made)), "$name.wpilog", time)
            if (asked.isLatest) accept(OpenedLog(listOf(made)), read.recording, emptyList(), showsWorst = false)
        }, { if (asked.isLatest) refuse(name, it, logs) }).catch { root.failUnexpectedly(it, back()) }
    }

    private fun refuse(name: String, problem: Throwable, logs: List<OpenedLog>) {
        val tools = back()
        if (logs.isNotEmpty()) tools.addButton("", "List its logs") { list(logs, name, again = null) }.id = "list-logs"
        fail("$name cannot be opened as one match", problem.message.orEmpty(), tools)
    }

    /** Opens [linked], the target of a link, after the reader has agreed. */
    fun open(linked: LinkedFile) {
        again = { open(linked) }
        val asked = wait(linked.name, linked::cancel)
        linked.fetch(asked.screen::show).then({ if (asked.isLatest) open(listOf(it)) }, {
            if (asked.isLatest) fail("${linked.name} cannot be opened", it.message.orEmpty())
        }).catch { root.failUnexpectedly(it, back()) }
    }

    /** Lists the logs of the page's server. */
    fun openServer() {
        val asked = wait("the robot’s list of logs") {}
        val server = ServedFolder()
        server.files().then({ files ->
            val logs = OpenedLog.logsIn(files.filter(OpenedLog::isNamedLikeLog))
            when {
                !asked.isLatest -> Unit

                logs.isEmpty() -> fail(
                    "There are no logs on this robot",
                    "It writes one when a driver station is connected: look again then.",
                )

                else -> list(logs, ServedFolder.NAME, FolderPolling(SERVER_PAUSE) { filesNow(server) })
            }
        }, {
            if (asked.isLatest) fail("The robot’s logs cannot be listed", it.message.orEmpty())
        }).catch { root.failUnexpectedly(it, back()) }
    }

    /** Sets the [work] to do when the folder's list has run the rules over the shown log. It is dropped once something else is shown. */
    fun onRead(work: () -> Unit) {
        onRead = work
        PageEvents.onEnd { onRead = {} }
    }

    /** Returns the differences between the shown log and the matches before it in its folder. */
    fun changes(): Changes<OpenedLog> = log?.let { folder?.changesOf(it) } ?: Changes()

    /** Promises the log [listed] with its bytes, downloaded if necessary; rejected with a sentence for the user. */
    fun withBytes(listed: OpenedLog): Promise<OpenedLog> {
        val log = folder?.latest(listed) ?: listed
        if (log.isHere) return Promise.resolve(log)
        val download = Download(log.files.filter { it.served != null }) {}
        PageEvents.onEnd(download::cancel)
        return download.start().then { fetched -> log.with(fetched).also { folder?.keep(it) } }
    }

    /** Promises the current files of [server]; rejected if the page is hidden, so that it requests nothing. */
    private fun filesNow(server: ServedFolder): Promise<List<File>> = if (document.asDynamic().hidden == true) {
        Promise.reject(Throwable())
    } else {
        server.files().then { it.filter(OpenedLog::isNamedLikeLog) }
    }

    /** Returns the buttons that lead from the shown log to other logs; null for the page's own log. */
    fun tools(): HTMLElement? {
        val open = log ?: return null
        return element("div", "downloads") {
            addBack()
            open.origin?.let { if (open.files.size == 1 && !open.fileName.endsWith(".gz")) live.addTo(this, it.address) }
            val logs = folder?.visible?.filter { it.isReadable }.orEmpty()
            val at = logs.indexOfFirst { it.path == open.path }
            if (at < 0) return@element
            val previous = { logs.getOrNull(at - 1)?.let(::open) }
            val next = { logs.getOrNull(at + 1)?.let(::open) }
            addIconButton("turned", Icon.CHEVRON, "Previous log of the list (Alt+Page up)") { previous() }.id = "previous-log"
            addIconButton("", Icon.CHEVRON, "Next log of the list (Alt+Page down)") { next() }.id = "next-log"
            PageEvents.on(document, "keydown") {
                when (it.unsafeCast<KeyboardEvent>().screenKey) {
                    ScreenKey.PREVIOUS_LOG -> previous()
                    ScreenKey.NEXT_LOG -> next()
                    else -> Unit
                }
            }
        }
    }

    private fun open(opened: OpenedLog) = open(opened, emptyList(), false)

    private fun open(opened: OpenedLog, compared: List<OpenedLog>, showsWorst: Boolean) {
        again = { open(opened, compared, showsWorst) }
        val all = (listOf(opened) + compared).map { if (it.isHere) it else folder?.latest(it) ?: it }
        if (all.all { it.isHere }) read(all[0], all.drop(1), showsWorst) else fetch(all, showsWorst)
    }

    private fun fetch(logs: List<OpenedLog>, showsWorst: Boolean) {
        lateinit var download: Download
        val asked = wait(logs[0].fileName) { download.cancel() }
        download = Download(logs.flatMap { it.files }.filter { it.served != null }, asked.screen::show)
        download.start().then({ fetched ->
            if (!asked.isLatest) return@then
            val here = logs.map { it.with(fetched) }
            here.forEach { log -> folder?.keep(log) }
            read(here[0], here.drop(1), showsWorst)
        }, {
            if (asked.isLatest) fail("${logs[0].fileName} cannot be opened", it.message.orEmpty())
        }).catch { root.failUnexpectedly(it, back()) }
    }

    /** Reads [opened]; asks first if it may take more memory than there is. */
    private fun read(opened: OpenedLog, compared: List<OpenedLog>, showsWorst: Boolean) {
        val asked = wait(opened.fileName) {}
        fun readAll() = read(opened, compared, showsWorst, wanted = null)
        MemoryEstimate.of(opened.files, rules()).then({ need ->
            if (!asked.isLatest) return@then
            if (need?.isTooMuch != true) return@then readAll()
            folder?.pause()
            val tools = element("div", "page-tools") {
                if (need.few.names.isNotEmpty()) {
                    addButton("", "Open the ${countText(need.few.names.size, "topic")} that rules look at: ${memoryText(need.fewBytes)}") {
                        read(opened, compared, showsWorst, need.few)
                    }.id = "open-few"
                }
                addButton("", "Open all of it") { readAll() }.id = "open-all"
                addBack()
            }
            val why = "If this browser does not have that much, it closes the page. badlog's window can open the log, too."
            root.fail("${opened.fileName} needs about ${memoryText(need.bytes)} of memory", why, tools)
        }, { if (asked.isLatest) readAll() }).catch { root.failUnexpectedly(it, back()) }
    }

    private fun read(opened: OpenedLog, compared: List<OpenedLog>, showsWorst: Boolean, wanted: WantedTopics?) {
        lateinit var reading: FileReading
        val asked = wait(opened.fileName) { reading.cancel() }
        reading = FileReading(opened.files, wanted, asked.screen::show)
        reading.start().then({ read -> if (asked.isLatest) accept(opened, read.recording, compared, showsWorst) }, { failure ->
            if (asked.isLatest) fail("${opened.fileName} cannot be read", "${failure.message}. Open it again.")
        }).catch { root.failUnexpectedly(it, back()) }
    }

    private fun accept(opened: OpenedLog, read: Recording, compared: List<OpenedLog>, showsWorst: Boolean) {
        read.refusal?.let { return fail("There is nothing to show in ${opened.fileName}", it) }
        log = opened
        if (folder?.has(opened) == false) endFolder()
        folder?.see(opened)
        document.title = opened.title
        // The list's findings were found over the log's time.
        show(opened, if (showsWorst) read.overItsTime() else read, compared.flatMap { it.files }, showsWorst)
    }

    private fun openPage(page: File) {
        val title = "There is nothing to show in ${page.name}"
        val asked = wait(page.name) {}
        logIn(page).then({ inPage ->
            when {
                !asked.isLatest -> Unit
                inPage == null -> fail(title, "It is not a badlog page with a log in it.")
                else -> open(OpenedLog(inPage))
            }
        }, {
            if (asked.isLatest) fail(title, "${it.message?.replaceFirstChar(Char::uppercase)}.")
        }).catch { root.failUnexpectedly(it, back()) }
    }

    private inner class OpenRequest(val screen: LoadingScreen, private val number: Int) {
        /** Whether there was no later request. */
        val isLatest: Boolean get() = number == request
    }

    /** Shows that the file [name] is being read; [cancel] stops reading. */
    private fun wait(name: String, cancel: () -> Unit): OpenRequest {
        live.stop()
        cancelLast()
        cancelLast = cancel
        leaveList()
        val asked = OpenRequest(LoadingScreen(name, ::goBack), ++request)
        setPageState("loading")
        root.showAlone(asked.screen.element)
        acceptFiles(::open) {
            cancel()
            open(it)
        }
        return asked
    }

    private fun leaveList() {
        // Forward no longer leads from the start to its list.
        if (history.now == Visit.START) endFolder() else folder?.pause()
        history.show(Visit.LOG)
    }

    private fun fail(title: String, explanation: String, tools: HTMLElement = back()) {
        leaveList()
        request++
        root.fail(title, explanation, tools)
        acceptFiles(::open, ::open)
    }

    /** Lists the logs in [watched], and logs that appear there later. */
    fun open(watched: WatchedFolder) {
        watched.files().then { files ->
            fun listAll() = list(OpenedLog.logsIn(files), watched.name, watched.again, watched.pages)
            val manifest = watched.manifest ?: return@then listAll()
            again = { open(watched) }
            openMatch(watched.name, matchAmong(files + manifest), ::listAll)
        }.catch { root.failUnexpectedly(it, back()) }
    }

    private fun list(logs: List<OpenedLog>, name: String, again: FolderPolling?, pages: Int = 0) {
        endFolder()
        val leave = { goBackTo(Visit.START) }
        val listed = FolderScreen(logs, name, rules(), again, settings, leave, { if (it.path == log?.path) onRead() }, ::open)
        listed.pages = pages
        folder = listed
        goBack()
    }

    private fun endFolder() {
        folder?.leave()
        folder = null
    }

    /** Shows the list from which the log was opened, or the start if there is none. */
    private fun goBack() = goBackTo(if (folder == null) Visit.START else Visit.LIST)

    private fun goBackTo(visit: Visit) {
        history.show(visit)
        showAgain(visit)
    }

    private fun showAgain(visit: Visit) {
        if (visit == Visit.LOG) return again?.invoke() ?: Unit
        live.stop()
        cancelLast()
        request++
        val left = log
        log = null
        val listed = folder
        if (visit == Visit.START || listed == null) {
            listed?.leave()
            return goToStart()
        }
        root.showAlone(listed.element)
        acceptFiles(::open, ::open)
        document.title = "badlog"
        setPageState("empty")
        listed.resume()
        left?.let(listed::focus)
    }

    private fun back() = element("div", "page-tools") { addBack() }

    private fun HTMLElement.addBack() {
        val (label, hint) = if (folder == null) "Open…" to "Open something else" else "Logs" to "Back to the list of logs"
        addButton("", "", hint) { goBack() }.apply {
            id = "go-back"
            appendChild(Icon.BACK.draw())
            add("span", "", label)
        }
    }

    /** Returns advice for a file named [name] that only other programs can read; null for all other files. */
    private fun adviceFor(name: String): String? = when (name.substringAfterLast('.').lowercase()) {
        "wpilogxz" -> "It is compressed with xz: unpack it, with 7-Zip for example, or open it in badlog's window."
        "hoot" -> "Open it in badlog's window, or make a WPILOG of it with “badlog convert”."
        else -> null
    }
}

/** The milliseconds between two looks at a robot's list; a robot has other work. */
private const val SERVER_PAUSE = 15_000
