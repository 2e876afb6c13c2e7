package badlog.page.opened

import badlog.page.dom.Icon
import badlog.page.dom.PageEvents
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isDisabled
import badlog.page.dom.isHidden
import badlog.page.dom.screenKey
import badlog.page.dom.showText
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Palette
import badlog.rules.RuleSet
import badlog.rules.toJson
import badlog.viewer.input.ScreenKey
import badlog.viewer.panel.folder.batteriesPanel
import badlog.viewer.panel.folder.logTable
import badlog.viewer.panel.folder.withPreviews
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatterySeason
import badlog.viewer.shown.folder.Arrivals
import badlog.viewer.shown.folder.Changes
import badlog.viewer.shown.folder.Listing
import badlog.viewer.shown.folder.LogColumn
import badlog.viewer.shown.folder.changesOf
import badlog.viewer.shown.folder.earlierThan
import badlog.viewer.shown.folder.logsOfRobots
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction
import badlog.viewer.text.countOf
import badlog.viewer.text.countText
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.HTMLSelectElement
import org.w3c.dom.asList
import org.w3c.dom.events.KeyboardEvent
import kotlin.math.min

/**
 * The list of a folder's logs. It shows the facts in their names at once, and other facts as the logs are read.
 *
 * @param logs the logs; files that turn out not to be logs are not listed.
 * @param rules the rules that run over each log.
 * @param settings returns the settings that every page has.
 * @param again the folder, to be polled for changes; null if the page can read it only once.
 * @param onLeave called to open something else.
 * @param onRead called with each log when the rules have run over it.
 * @param onOpen called with the log to open, the logs to compare with it, and whether to show the worst finding.
 */
internal class FolderScreen(
    logs: List<OpenedLog>,
    name: String,
    private val rules: RuleSet,
    again: FolderPolling?,
    private val settings: () -> HTMLElement,
    onLeave: () -> Unit,
    private val onRead: (OpenedLog) -> Unit,
    private val onOpen: (OpenedLog, compared: List<OpenedLog>, showsWorst: Boolean) -> Unit,
) {
    private val known = logs.associateByTo(LinkedHashMap()) { it.path }
    private val unread = logs.filter { it.isHere }.mapTo(HashSet()) { it.path }
    private val checked = LinkedHashSet<String>()
    private val cache = SummaryCache(rules.toJson())
    private val reading = FolderReading(rules, cache, ::nextToRead, ::take) { unread += it.path }
    private val statistics = LogStatistics()
    private val batteries = element("section", "entries battery-table card") { setAttribute("aria-label", "Batteries") }
    private var unfolded = emptyMap<String, Boolean>()
    private var seasons = emptyList<BatterySeason>()

    /** The logs in [seasons]. */
    private var inSeasons = emptyList<OpenedLog>()
    private var timer = 0
    private var isShown = false
    private var isCacheRead = false
    private val watch = again?.let { FolderWatch(it, known, ::renew) }
    private var listing = Listing(logs, folder = "$name/", recording = watch?.growing.orEmpty())

    /** The logs that have changed since the folder was opened. */
    private val fresh = HashSet<String>()

    /** The logs that a person has opened since the list was last shown, before they arrived. */
    private val seen = HashSet<String>()
    private val arrived = ArrivedLogs {
        keep(it)
        reading.start()
    }
    private var arrivals = Arrivals<OpenedLog>()
    private val bar = ArrivalBar(::showArrival) { change(arrivals.dealtWith()) }
    private lateinit var tools: HTMLElement
    private lateinit var pitButton: HTMLElement
    private lateinit var progress: HTMLElement
    private lateinit var compare: HTMLElement
    private lateinit var more: HTMLElement
    private lateinit var nothing: HTMLElement
    private lateinit var orders: HTMLSelectElement

    // No picture of the list needs colors.
    private val nodes = PartNodes(Palette(), ::act)
    private val pit = PitView(nodes)
    private val table = element("div", "entries log-table card")
    private var limit = page

    val element: HTMLElement = element("div", "start folder-logs") {
        addButton("skip", "Skip to the logs") { listing.visible.firstOrNull()?.let(::focus) }
        add("header", "page-head") {
            add("h1", "", name)
            tools = add("div", "page-tools") {
                addButton("", "", "Open something else", onLeave).apply {
                    id = "go-back"
                    appendChild(Icon.BACK.draw())
                    add("span", "", "Open…")
                }
                pitButton = addButton("", "Pit view", PIT_HINT, ::togglePit)
                pitButton.id = "pit-view"
            }
        }
        add("div", "log-tools") {
            add("div", "search") {
                appendChild(Icon.SEARCH.draw())
                addSearch()
            }
            compare = addButton("", "Compare", "Draw the checked logs over each other") { compareChecked() }
            compare.id = "compare-logs"
            addBox("hide-empty", "Hide idle") { choose(listing.copy(hidesEmpty = it)) }
            addBox("only-errors", "Only errors") { choose(listing.copy(onlyErrors = it)) }
            addOrders()
            progress = add("p", "unit") { setAttribute("role", "status") }
        }
        appendChild(table)
        more = addButton("more", "", onClick = ::showMore)
        nothing = add("p", "nothing-found")
        appendChild(statistics.element)
        appendChild(batteries)
        appendChild(pit.element)
    }

    init {
        show()
        if (watch != null) arrivals = arrivals.begun(logs.associate { it.path to it.size })
        cache.find(logs, { log, message ->
            val known = SummaryMessage.read(message, log)
            unread -= log.path
            take(known)
        }) {
            isCacheRead = true
            if (isShown) reading.start()
        }
    }

    /** The number of pages among the files, which are not listed. */
    var pages: Int
        get() = listing.pages
        set(value) = list(listing.copy(pages = value))

    /** The listed logs, in order. */
    val visible: List<OpenedLog> get() = listing.visible

    /** Shows the list again and continues reading. */
    fun resume() {
        tools.appendChild(settings())
        isShown = true
        seen.clear()
        change(arrivals)
        watch?.let {
            it.start()
            bar.start()
        }
        arrived.fetch()
        if (isCacheRead) reading.start()
        PageEvents.on(document, "keydown") {
            if (it.unsafeCast<KeyboardEvent>().screenKey == ScreenKey.PIT) togglePit()
        }
        PageEvents.on(window, "scroll") {
            if (!isPit && !more.isHidden && more.getBoundingClientRect().top < 2 * window.innerHeight) showMore()
        }
    }

    /** Focuses the entry of [log]. */
    fun focus(log: OpenedLog) {
        if (isPit) return pit.focus(log)
        val place = listing.rows.indexOfFirst { row -> row.logs.any { it.path == log.path } }
        while (limit <= place) showMore()
        val path = listing.rows.getOrNull(place)?.worst?.path
        val row = table.querySelectorAll("[data-path]").asList().find { it.asDynamic().dataset.path == path }
        row?.asDynamic()?.querySelector("button")?.focus()
    }

    /** Returns whether [log] is in the folder, by its path. */
    fun has(log: OpenedLog): Boolean = log.path in known

    /** Returns the current state of [log], which may have grown or been fetched since it was listed. */
    fun latest(log: OpenedLog): OpenedLog = known[log.path] ?: log

    /** Stores [log] with its bytes, which have arrived, so that it can be read. */
    fun keep(log: OpenedLog) {
        known[log.path] = log
        arrived.remove(log.path)
        if (log.isUnread) unread += log.path
        listing = listing.copy(entries = known.values.toList())
    }

    /** Returns the differences between [log] and the matches before it that have been read. */
    fun changesOf(log: OpenedLog): Changes<OpenedLog> {
        val own = latest(log)
        val others = logsOfRobots(known.values.toList(), OpenedLog::isOnlyOfLogs).filter { !it.isGray && it.found?.rules != null }
        return changesOf(own, earlierThan(own, others.filter { it.path != own.path }), rules) { it.numbers }
    }

    /** Records that a person sees [log]. It then does not count as new, even if rules have not run over it. */
    fun see(log: OpenedLog) {
        if (arrivals.isNew(latest(log))) seen += log.path
        change(arrivals.without(log.path))
    }

    /** Stops reading, because a person opens a log. Logs that arrive meanwhile are read once the list is shown again. */
    fun pause() {
        isShown = false
        reading.stop()
        arrived.pause()
        for (log in known.values) if (log.isUnread && log.path !in listing.recording) unread += log.path
    }

    /** Stops all work, because neither the list nor one of its logs is shown. */
    fun leave() {
        pause()
        watch?.stop()
        bar.stop()
    }

    private fun HTMLElement.addSearch() {
        val input = add("input", "search-input").unsafeCast<HTMLInputElement>()
        input.id = "search"
        input.type = "search"
        input.placeholder = "Search matches, findings, files"
        input.setAttribute("aria-label", "Search logs")
        input.addEventListener("input", { choose(listing.copy(filter = input.value)) })
    }

    /** Adds the choice of an order, for screens without the table's titles. */
    private fun HTMLElement.addOrders() {
        orders = add("select", "sort") {
            setAttribute("aria-label", "Sort by")
            for (column in LogColumn.entries) for (arrow in "↓↑") add("option", "", "${column.title} $arrow")
        }.unsafeCast<HTMLSelectElement>()
        orders.onchange = {
            val chosen = orders.selectedIndex
            choose(listing.copy(column = LogColumn.entries[chosen / 2], isDescending = chosen % 2 == 0))
        }
    }

    private fun HTMLElement.addBox(id: String, label: String, onChange: (Boolean) -> Unit) = add("label") {
        val box = add("input").unsafeCast<HTMLInputElement>()
        box.type = "checkbox"
        box.id = id
        box.addEventListener("change", { onChange(box.checked) })
        add("span", "", label)
    }

    private fun renew(look: FolderChanges) {
        known -= look.gone
        checked -= look.gone
        for (log in look.changed) known[log.path] = log
        for (path in look.changed.map { it.path } + look.gone) {
            unread -= path
            arrived.remove(path)
        }
        val (here, elsewhere) = look.complete.mapNotNull(known::get).partition { it.isHere }
        here.mapTo(unread) { it.path }
        // WPILib's server, which lists no times, sends at full speed even while the robot is enabled. Its logs are fetched only on request.
        elsewhere.filter { it.modified > 0 && arrivals.isNew(it) }.forEach(arrived::add)
        fresh += look.complete
        arrived.fetch()
        reading.start()
        if (look.isSame) return
        follow()
        showLater()
    }

    /** Updates the arrivals. */
    private fun follow() = change(arrivals.withEntries(known.values.toList()))

    private fun change(changed: Arrivals<OpenedLog>) {
        // The pit view shows new logs by itself.
        if (isPit && isShown) changed.latest?.worst?.let(pit::announce)
        arrivals = if (isPit && isShown) changed.dealtWith() else seen.fold(changed, Arrivals<OpenedLog>::without)
        bar.show(arrivals)
    }

    private fun togglePit() {
        element.classList.toggle("is-pit")
        pitButton.textContent = if (isPit) "Logs" else "Pit view"
        pitButton.title = if (isPit) "Back to the list of logs (I)" else PIT_HINT
        change(arrivals)
        show()
    }

    private val isPit: Boolean get() = element.classList.contains("is-pit")

    private fun showArrival() {
        val log = arrivals.latest?.worst ?: return
        change(arrivals.dealtWith())
        openWorst(log)
    }

    private fun openWorst(log: OpenedLog) = onOpen(latest(log), emptyList(), true)

    /** Returns the next log to read; the first visible ones come first. */
    private fun nextToRead(): OpenedLog? {
        val path = when {
            // While a log is shown, only the logs to announce are read.
            !isShown -> unread.firstOrNull { it in fresh }

            else -> listing.visible.firstOrNull { it.path in unread }?.path ?: unread.firstOrNull()
        } ?: return null
        unread -= path
        return known[path]
    }

    private fun take(log: OpenedLog) {
        known[log.path] = log
        if (!log.isReadable) checked -= log.path
        if (arrivals.hasBegun) follow()
        if (log.found != null) onRead(log)
        showLater()
    }

    /** Shows the list after [PAUSE], because results arrive faster than anyone reads. */
    private fun showLater() {
        if (timer != 0) return
        timer = window.setTimeout({
            timer = 0
            // A button must not be replaced while it is pressed.
            if (element.matches(":active")) showLater() else list(listing.copy(entries = known.values.toList()))
        }, PAUSE)
    }

    private fun list(changed: Listing<OpenedLog>) {
        listing = changed
        show()
    }

    /** Lists the logs as a person wants them, from the first one. */
    private fun choose(changed: Listing<OpenedLog>) {
        limit = page
        list(changed)
        window.scrollBy(0.0, min(0.0, table.getBoundingClientRect().top))
    }

    private fun showMore() {
        limit += page
        show()
    }

    private fun act(action: Action) {
        when (action) {
            is FolderAction.Sort -> return choose(listing.sorted(action.column))

            is FolderAction.Check -> if (!checked.add(action.path)) checked -= action.path

            // It may have been removed since it was listed.
            is FolderAction.Open -> return known[action.path]?.let { onOpen(it, emptyList(), action.showsFinding) } ?: Unit

            is Action.Unfold -> unfolded += action.fold to action.isOpen

            else -> Unit
        }
        show()
    }

    private fun compareChecked() {
        val logs = checked.mapNotNull(known::get)
        onOpen(logs.first(), logs.drop(1), false)
    }

    private fun show() {
        if (inSeasons !== listing.entries) {
            seasons = BatterySeason.of(listing.entries)
            inSeasons = listing.entries
        }
        if (isPit) pit.show(listing.entries, BatteryAdvice.of(seasons), willRead = { it.isUnread && it.path !in listing.recording })
        orders.selectedIndex = 2 * listing.column.ordinal + if (listing.isDescending) 0 else 1
        table.patch(nodes.of(listOf(logTable(listing, checked, limit).withPreviews(listing.visible, name = null))))
        val left = listing.rows.size - limit
        more.isHidden = left <= 0
        more.textContent = "Show more (${countText(left)} left)"
        val unread = listing.entries.count { it.isUnread }
        progress.showText(if (unread == 0) listing.count else "${countOf(listing.size - unread, listing.size, "log")} read")
        batteries.isHidden = seasons.none { it.battery != null }
        batteries.patch(nodes.of(batteriesPanel(seasons, unfolded)))
        statistics.show(checked.mapNotNull(known::get))
        compare.isDisabled = checked.size < 2
        nothing.isHidden = listing.visible.isNotEmpty()
        nothing.showText(if (listing.size == 0) "There are no logs in this folder." else listing.emptiness)
    }

    private val OpenedLog.isUnread: Boolean get() = isHere && found == null && isReadable && !isGray

    private companion object {
        const val PIT_HINT = "The last logs in large letters (I)"

        /** The number of rows added at a time: more than the screen has room for. */
        val page: Int get() = 20 + window.innerHeight / 30

        /** Milliseconds between two updates of the table. */
        const val PAUSE = 200
    }
}
