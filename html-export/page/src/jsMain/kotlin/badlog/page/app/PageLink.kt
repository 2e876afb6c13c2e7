package badlog.page.app

import badlog.core.analysis.Span
import badlog.page.board.BoardSection
import badlog.page.dom.Icon
import badlog.page.dom.PageEvents
import badlog.page.dom.addIconButton
import badlog.page.dom.copyText
import badlog.page.dom.element
import badlog.page.findings.FindingsSection
import badlog.page.formula.Formulas
import badlog.page.graph.GraphsInSight
import badlog.page.header.SearchBox
import badlog.page.panel.CursorPanel
import badlog.page.panel.ModulesPanel
import badlog.page.video.VideoPanel
import badlog.page.view.Scene
import badlog.rules.LogFindings
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.fittedTo
import badlog.viewer.session.link.OpenedParts
import badlog.viewer.session.link.PageAddress
import badlog.viewer.session.link.pageAddressOf
import badlog.viewer.state.PlaceAction
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement

/**
 * Follows the page's address, see [PageAddress], when the page opens and when the address changes. Also has the button that copies an
 * address for the current view.
 *
 * @param onFormulas calculates the formulas of an address, then calls `then` with sentences about mistakes in them.
 * @param onJump called when the cursor and the board match the address; called again for the same address when the findings are known.
 * @param opened returns the panels that the reader has opened.
 * @param open opens the panels that an address names.
 */
internal class PageLink(
    private val scene: Scene,
    private val formulas: Formulas,
    private val video: VideoPanel,
    private val onFormulas: (List<String>, then: (List<String>) -> Unit) -> Unit,
    private val onJump: (PageAddress, isAgain: Boolean) -> Unit,
    private val opened: () -> OpenedParts,
    private val open: (OpenedParts) -> Unit,
) {
    /** The address that was followed, and where it led, until the reader looks elsewhere. */
    private var followed: Pair<PageAddress, Span>? = null

    val element: HTMLElement = element("div", "copy-link") {
        addIconButton("", Icon.LINK, "Copy a link to this time, range and board") { copy() }.id = "copy-link"
    }

    /**
     * Follows [place], or the current address if it is null, and then each change of the address. Calls [begin] with the first board; null
     * if there is none.
     */
    fun start(place: PageAddress?, begin: (Board?) -> Unit) {
        follow(place ?: pageAddressOf(window.location.hash), begin)
        PageEvents.on(window, "hashchange") { follow(pageAddressOf(window.location.hash)) { asked -> asked?.let(scene.board::visit) } }
        scene.board.onKeep = ::leave
    }

    /**
     * Makes the board and the formulas of a link the reader's own, because the reader is changing one of them. Otherwise they would return
     * when the page is loaded again, and replace the reader's changes.
     */
    fun leave() {
        val hash = window.location.hash
        if ("f=" in hash) formulas.remember()
        if ("f=" in hash || "board=" in hash) showAddress("")
    }

    /** Follows the address again when the findings are known, unless the reader has moved to another place. */
    fun followAgain() {
        val (address, there) = followed ?: return
        val moment = address.moment?.let { scene.range.full.run { it.coerceIn(from, to) } }
        val isThere = scene.range.now == there && moment == scene.cursor.now.pinned
        if ((address.board == null || address.finding != null) && isThere) go(address, isAgain = true)
    }

    private fun follow(address: PageAddress, onBoard: (Board?) -> Unit) {
        onFormulas(address.formulas) { mistakes ->
            val board = address.board?.fittedTo { scene.board.lines[it] != null }
            onBoard(board?.board)
            go(address)
            followed = address to scene.range.now
            open(address.opened)
            address.video?.let { video.alignment = it }
            scene.notice.say(*(address.problems + mistakes + listOfNotNull(board?.sentence)).toTypedArray())
        }
    }

    private fun go(address: PageAddress, isAgain: Boolean = false) {
        address.moment?.let(scene::goTo)
        if (address.moment != null) address.second?.let { x -> scene.store.send(PlaceAction.Click(x, 0.0, isShifted = true)) }
        if (address.moment != null || address.board != null) onJump(address, isAgain)
        address.visible?.let { range -> scene.store.send(PlaceAction.Show(range.from, range.to)) }
    }

    /** The link to the current view; null if others could not open it, because the page is on a disk. */
    val shared: String? get() = window.location.href.takeIf { it.startsWith("http") }?.let { it.substringBefore('#') + textNow() }

    /** The end of a link: the log, if a link named it, and the view of it. */
    private fun textNow(): String {
        val named = window.location.hash.removePrefix("#").split('&').firstOrNull { it.startsWith("url=") }
        val shown = now.toText().removePrefix("#").ifEmpty { null }
        return listOfNotNull(named, shown).joinToString("&").let { if (it.isEmpty()) it else "#$it" }
    }

    /** The address of the current view. */
    val now: PageAddress
        get() = PageAddress(
            moment = scene.cursor.x.takeIf { scene.cursor.isPlaced },
            finding = scene.visitedAt(scene.cursor.x),
            visible = scene.range.now.takeIf { scene.range.isZoomed },
            board = scene.board.now.takeIf { it.graphs.isNotEmpty() && !scene.board.isUntouched }?.renumbered(),
            formulas = formulas.own,
            video = video.alignment,
            second = scene.cursor.now.second,
            opened = opened(),
        ).seenIn(scene.range.now.width)

    private fun copy() {
        val end = textNow()
        val link = window.location.href.substringBefore('#') + end
        copyText(link).then { isCopied ->
            if (!isCopied) showAddress(end)
            scene.notice.say(if (isCopied) "Link copied." else "Copy the link from the address bar.")
        }
    }

    /** Makes the page's address end with [end], without following it. */
    private fun showAddress(end: String) {
        try {
            window.history.replaceState(window.history.state, "", window.location.href.substringBefore('#') + end)
        } catch (_: Throwable) {
            // Pages in some frames have no address of their own.
        }
    }
}

/** The part of the page that a link points at: the board, a finding, or a graph. */
internal class LinkGoal(private val board: BoardSection, private val inSight: GraphsInSight, private val findings: FindingsSection) {
    /** The element that has the keyboard's focus because a link points at it. */
    private var focused: Element? = null

    /** Scrolls to the target of [address] and focuses it. [isAgain] is whether that was done before. */
    fun go(address: PageAddress, isAgain: Boolean) {
        if (address.board != null && address.finding == null) {
            board.bringIntoSight()
        } else {
            inSight.showAny()
            address.moment?.let { findings.visitAt(it, address.finding) }
        }
        focus(address, isAgain)
    }

    /** Focuses the target, unless the focus has moved since it was done before. */
    private fun focus(address: PageAddress, isAgain: Boolean) {
        val isElsewhere = isAgain && document.activeElement.let { it !== document.body && it !== focused }
        // A page in a frame leaves the focus to the page around it.
        if (isElsewhere || window.parent !== window) return
        if (address.finding == null || !findings.focusCurrent()) inSight.focusAny()
        focused = document.activeElement
    }
}

/** The parts of the page that a reader can open and close, in the form used by links. */
internal class ReaderParts(
    private val search: SearchBox,
    private val values: CursorPanel,
    private val modules: ModulesPanel,
    private val board: BoardSection,
) {
    /** The parts that are open. */
    val now: OpenedParts
        get() {
            val statistics = board.cards.withIndex().filter { it.value.hasStatistics }.map { it.index + 1 }
            return OpenedParts(search.text, values.isOpen, modules.isOpen, statistics)
        }

    /** Opens the parts in [wanted]; other open parts stay open. */
    fun open(wanted: OpenedParts) {
        if (wanted.search.isNotEmpty()) search.show(wanted.search)
        if (wanted.hasValues && !values.isOpen) values.toggle()
        if (wanted.hasModules && !modules.isOpen) modules.toggle()
        for (place in wanted.statistics) board.cards.getOrNull(place - 1)?.takeIf { !it.hasStatistics }?.toggleStatistics()
    }
}

/**
 * The part of a log's page that stays when the log has grown.
 *
 * @property place the reader's position on the page; board and formulas are remembered separately.
 * @property found the findings to show until the rules have run again; null if they have not run.
 * @property ranAt the time at which the last run of the rules ended, on the browser's clock, in ms.
 */
internal class PageSnapshot(val place: PageAddress, val found: LogFindings?, val ranAt: Double)
