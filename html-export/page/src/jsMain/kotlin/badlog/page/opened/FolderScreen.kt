package badlog.page.opened

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isDisabled
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.rules.RuleSet
import badlog.viewer.shown.folder.Listing
import badlog.viewer.text.countText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement

/**
 * The logs of a folder: what their names say at once, the rest as they are read.
 *
 * @param logs the logs; those that turn out to be none are not listed.
 * @param rules those that run over each.
 * @param settings returns what can be changed on every page.
 * @param onLeave called when a person wants something else.
 * @param onOpen called with the log to open, those to compare with it, and whether to show the worst that was found.
 */
internal class FolderScreen(
    logs: List<OpenedLog>,
    rules: RuleSet,
    private val settings: () -> HTMLElement,
    onLeave: () -> Unit,
    private val onOpen: (OpenedLog, compared: List<OpenedLog>, showsWorst: Boolean) -> Unit,
) {
    private val known = logs.associateByTo(LinkedHashMap()) { it.path }
    private var listing = Listing(logs, folder = folderOf(logs) + "/")
    private val unread = logs.filter { it.isHere }.mapTo(HashSet()) { it.path }
    private val checked = LinkedHashSet<String>()
    private val reading = FolderReading(rules, ::nextToRead, ::take) { unread += it.path }
    private var timer = 0
    private lateinit var tools: HTMLElement
    private lateinit var progress: HTMLElement
    private lateinit var compare: HTMLElement
    private lateinit var nothing: HTMLElement
    private val table =
        LogTable({ column -> list(listing.sorted(column)) }, ::check) { log, showsWorst -> onOpen(log, emptyList(), showsWorst) }

    val element: HTMLElement = element("div", "start folder-logs") {
        add("header", "page-head") {
            add("h1", "", folderOf(logs))
            tools = add("div", "page-tools") {
                addButton("", "", "Open something else", onLeave).apply {
                    id = "go-back"
                    appendChild(Icon.BACK.draw())
                    add("span", "", "Open…")
                }
            }
        }
        add("div", "log-tools") {
            add("div", "search") {
                appendChild(Icon.SEARCH.draw())
                addSearch()
            }
            compare = addButton("", "Compare", "Draw the checked logs over each other") { compareChecked() }
            compare.id = "compare-logs"
            addHidingOfEmpty()
            progress = add("p", "unit") { setAttribute("role", "status") }
        }
        appendChild(table.element)
        nothing = add("p", "nothing-found")
    }

    init {
        show()
    }

    /** The listed logs, in order. */
    val visible: List<OpenedLog> get() = listing.visible

    /** Goes on reading: it is shown again. */
    fun resume() {
        tools.appendChild(settings())
        reading.start()
    }

    /** Returns whether [log] is one of its logs. */
    fun has(log: OpenedLog): Boolean = log.path in known

    /** Takes over that the bytes of [log] are here now, so that it can be read, too. */
    fun keep(log: OpenedLog) {
        known[log.path] = log
        if (log.isUnread) unread += log.path
        listing = listing.copy(entries = known.values.toList())
    }

    /** Stops reading, because a log is being read that a person wants to see. */
    fun pause() {
        reading.stop()
        for (log in known.values) if (log.isUnread) unread += log.path
    }

    private fun HTMLElement.addSearch() {
        val input = add("input", "search-input").unsafeCast<HTMLInputElement>()
        input.id = "search"
        input.type = "search"
        input.placeholder = "Search matches, findings, files"
        input.setAttribute("aria-label", "Search logs")
        input.addEventListener("input", { list(listing.copy(filter = input.value)) })
    }

    private fun HTMLElement.addHidingOfEmpty() = add("label") {
        val box = add("input").unsafeCast<HTMLInputElement>()
        box.type = "checkbox"
        box.id = "hide-empty"
        box.addEventListener("change", { list(listing.copy(hidesEmpty = box.checked)) })
        add("span", "", "Hide idle logs")
    }

    /** What is seen first is read first. */
    private fun nextToRead(): OpenedLog? {
        val path = listing.visible.firstOrNull { it.path in unread }?.path ?: unread.firstOrNull() ?: return null
        unread -= path
        return known[path]
    }

    private fun take(log: OpenedLog) {
        known[log.path] = log
        if (!log.isReadable) checked -= log.path
        showLater()
    }

    /** Rows come in quicker than anybody reads. */
    private fun showLater() {
        if (timer != 0) return
        timer = window.setTimeout({
            timer = 0
            // A button that is being pressed must not be replaced by a new one.
            if (table.isPressed) showLater() else list(listing.copy(entries = known.values.toList()))
        }, PAUSE)
    }

    private fun list(changed: Listing<OpenedLog>) {
        listing = changed
        show()
    }

    private fun check(log: OpenedLog, isChecked: Boolean) {
        if (isChecked) checked += log.path else checked -= log.path
        show()
    }

    private fun compareChecked() {
        val logs = checked.mapNotNull(known::get)
        onOpen(logs.first(), logs.drop(1), false)
    }

    private fun show() {
        table.show(listing, checked)
        val left = listing.entries.count { it.isUnread }
        progress.showText(
            if (left ==
                0
            ) {
                countText(listing.size, "log")
            } else {
                "${listing.size - left} of ${countText(listing.size, "log")} read"
            },
        )
        compare.isDisabled = checked.size < 2
        nothing.isHidden = listing.visible.isNotEmpty()
        nothing.showText(if (listing.size == 0) "There are no logs in this folder." else "No log matches.")
    }

    private val OpenedLog.isUnread: Boolean get() = isHere && found == null && isReadable && !isGray

    private companion object {
        /** Milliseconds between two updates of the table. */
        const val PAUSE = 200

        /** Returns the name of the folder of [logs]. */
        fun folderOf(logs: List<OpenedLog>): String = logs.first().path.substringBefore('/', "Logs")
    }
}
