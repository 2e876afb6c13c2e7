package badlog.page.app

import badlog.core.analysis.LogView
import badlog.page.board.BoardDrag
import badlog.page.board.BoardKeys
import badlog.page.board.BoardSection
import badlog.page.board.TopicDialog
import badlog.page.compare.CompareBar
import badlog.page.compare.PageComparison
import badlog.page.dom.Icon
import badlog.page.dom.PageEvents
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.embedded.About
import badlog.page.embedded.GivenLayout
import badlog.page.export.sendMoment
import badlog.page.findings.EvidenceSection
import badlog.page.findings.FindingsSection
import badlog.page.findings.SignalChoice
import badlog.page.folder.EventsLink
import badlog.page.folder.FolderList
import badlog.page.folder.FolderNavigation
import badlog.page.folder.folderOf
import badlog.page.formula.FormulaDialog
import badlog.page.formula.FormulaGraphs
import badlog.page.formula.Formulas
import badlog.page.graph.GraphsInSight
import badlog.page.graph.VisibleGraphs
import badlog.page.header.Downloads
import badlog.page.header.ExportMenu
import badlog.page.header.Printing
import badlog.page.header.ProblemSection
import badlog.page.header.SearchBox
import badlog.page.header.ThemeSwitch
import badlog.page.header.ZoomBar
import badlog.page.header.additionProblems
import badlog.page.header.infoSection
import badlog.page.header.pageHeader
import badlog.page.layout.PageLayouts
import badlog.page.note.NoteDialog
import badlog.page.note.NoteList
import badlog.page.note.PageNotes
import badlog.page.opened.LogOpening
import badlog.page.opened.OpenedLog
import badlog.page.opened.acceptFiles
import badlog.page.opened.isManifest
import badlog.page.opened.isZip
import badlog.page.panel.CursorPanel
import badlog.page.panel.HelpOverlay
import badlog.page.panel.ModulesPanel
import badlog.page.video.VideoPanel
import badlog.page.view.PageBoard
import badlog.page.view.PageStore
import badlog.page.view.Scene
import badlog.page.view.startOf
import badlog.page.view.timelineOf
import badlog.protocol.PageAdditions
import badlog.rules.Finding
import badlog.rules.LogFindings
import badlog.rules.incident.Incident
import badlog.rules.incident.evidenceOf
import badlog.rules.incident.firstEvidenceOf
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.board.boardAbove
import badlog.viewer.choices.board.evidenceBoard
import badlog.viewer.choices.note.NoteHistory
import badlog.viewer.draw.path.fieldOfJson
import badlog.viewer.input.KeyAction
import badlog.viewer.session.link.PageAddress
import badlog.viewer.shown.outline.outlineOf
import badlog.viewer.state.FindingAction
import badlog.viewer.state.FindingRequest
import badlog.viewer.state.GraphChange
import badlog.viewer.state.PlaceAction
import badlog.viewer.text.countText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/** Assembles the page of a recording. */
internal class LogPage(
    private val formulas: Formulas,
    private val about: About,
    additions: PageAdditions?,
    private val layout: GivenLayout,
    downloads: Downloads,
    theme: ThemeSwitch,
    axisChoice: HTMLElement?,
    onOtherSignals: () -> Unit,
    private val opening: LogOpening,
    copyWith: (NoteHistory, String, compared: List<File>, removed: List<File>) -> Promise<Blob>,
) {
    private val additions = additions ?: PageAdditions()
    private val view = formulas.view
    private val embeddedFindings = this.additions.findings + this.additions.hooks.flatMap { it.findings }
    private val signals = this.additions.rules.signals
    private val hookGraphs = this.additions.hooks.flatMap { folderOf(it).graphs }
    val store: PageStore = PageStore(startOf(view), PageShown({ scene }, { findings }, { keys })) { perform(it) }
    private val board = PageBoard(about.fileKey, linesNow(), store)
    private val notes = PageNotes(about.fileKey, this.additions)
    private val scene = Scene(view, about.name, theme.palette, board, downloads.notice, signals, store).apply {
        findings = timelineOf(embeddedFindings)
        notes = this@LogPage.notes.now.notes
        this@LogPage.additions.field?.let { field = fieldOfJson(it) }
    }
    private val graphs = VisibleGraphs(scene)
    private val outline = outlineOf(view, signals, formulas.names)
    val folders = FolderList(outline, scene, about.fileKey, this.additions.hooks, graphs::add, graphs::remove) {
        if (formulas.formulaOf(it) == null) "" else "formula"
    }
    val navigation = FolderNavigation(folders)
    private val formulaGraphs = FormulaGraphs(formulas, board, graphs, folders, navigation, scene.notice, ::beforeFormulas, ::linesNow)
    private val search = SearchBox { show(it) }
    val eventsLink = EventsLink(folders)
    val formulaDialog = FormulaDialog(formulas, formulaGraphs::add, formulaGraphs::change, formulaGraphs::remove)
    private val formulaButton = element("div", "formula-button") {
        addButton("", "", "${KeyAction.NEW_FORMULA.meaning} (${KeyAction.NEW_FORMULA.shortcut})") { formulaDialog.open() }.apply {
            id = "add-formula"
            setAttribute("aria-label", KeyAction.NEW_FORMULA.meaning)
            appendChild(Icon.FORMULA.draw())
            add("span", "", "Formula")
        }
    }
    private val lines = PageLines(scene, { boardSection.cards + evidence.cards }, { folders.cards })
    val values: CursorPanel = CursorPanel(scene, lines::shown, lines::all) { if (modules.isOpen) modules.toggle() }
    val modules: ModulesPanel = ModulesPanel(scene) { if (values.isOpen) values.toggle() }
    val noteDialog = NoteDialog(scene, notes)
    private val panelLinks =
        listOf(search.element, navigation.choice, eventsLink.element, formulaButton, noteDialog.button, values.button, modules.button)
    val video = VideoPanel(scene, about.fileKey, this.additions.video)
    private val link = PageLink(
        scene,
        formulas,
        video,
        { asked, then -> formulaGraphs.addAll(asked, isRemembered = false, then) },
        { address, isAgain -> goal.go(address, isAgain) },
        { opened.now },
        { opened.open(it) },
    )
    private val zoomBar = ZoomBar(scene, panelLinks, link.element)
    private val help = HelpOverlay()
    val live = LiveRegion(scene, lines::shown)
    private val comparison = PageComparison(formulas, about.name)
    val compareBar = CompareBar(comparison, scene)
    val changes: LogChanges = LogChanges(opening, comparison, compareBar, scene.notice, { element }) { difference ->
        pinEvidence(difference, null)
        boardSection.bringIntoSight()
    }
    val signalChoice = SignalChoice(formulas.given, signals, scene.notice, onOtherSignals)
    private val hasRules = this.additions.rules.rules.isNotEmpty()
    val findings = FindingsSection(scene, signalChoice, embeddedFindings, hasRules, { changes.differences }, store::send)
    private val rules = PageRules(this.additions, embeddedFindings, about.name, findings) { element.isConnected }
    val noteList = NoteList(scene, notes)
    private val evidence = EvidenceSection(scene, graphs, signals, { store.send(FindingAction.StepWithin(it)) }, ::send)
    private val topicDialog = TopicDialog(scene)
    val layouts =
        PageLayouts(scene, formulas, formulaGraphs, about.name, { boardAbove(view, signals) }) { boardSection.bringIntoSight() }
    val boardSection: BoardSection = BoardSection(scene, graphs, topicDialog, layouts.buttons.element)
    private val inSight = GraphsInSight { boardSection.cards + folders.cards }
    val keys = BoardKeys(board, graphs, boardSection)
    private val goal: LinkGoal = LinkGoal(boardSection, inSight, findings)
    private val opened = ReaderParts(search, values, modules, boardSection)
    private val problems = ProblemSection(scene, view.problems, additionProblems(formulas, additions, layout))
    private val printing = Printing(scene, { boardSection.cards + evidence.cards }, { folders.cards }) {
        problems.print(it)
        findings.print(it)
    }
    private val copy = PageCopy(about, scene.notice, comparison, compareBar) { compared, removed ->
        copyWith(notes.history, layouts.now().toJson(), compared, removed)
    }
    private val export = ExportMenu(scene, printing, copy::save) { boardSection.cards }
    val content: HTMLElement = element("div", "content")

    /** The notice that nothing matches the search. */
    val nothingFound: HTMLElement = element("p", "nothing-found", "Nothing matches. Escape clears the search.").apply { isHidden = true }

    private val tools = listOfNotNull(
        opening.tools(),
        export.element,
        downloads.element,
        video.button,
        compareBar.button,
        element("div", "page-settings") {
            appendChild(theme.element)
            addIconButton("", Icon.HELP, "Keys and gestures (?)") { help.toggle() }.id = "help-button"
        },
    )

    val element: HTMLElement = element("div", "log-page") {
        addButton("skip", "Skip to the graphs") { inSight.focusFirst() }
        appendChild(pageHeader(scene, about, formulas.logged.recording, tools))
        axisChoice?.let(::appendChild)
        appendChild(problems.element)
        appendChild(findings.element)
        appendChild(noteList.element)
        appendChild(printing.element)
        appendChild(compareBar.element)
        appendChild(zoomBar.element)
        appendChild(evidence.element)
        appendChild(boardSection.element)
        add("div", "columns") {
            appendChild(navigation.list)
            appendChild(content).apply {
                appendChild(nothingFound)
                appendChild(folders.element)
                appendChild(infoSection(view, formulas.logged.recording, about))
            }
        }
        appendChild(video.element)
        appendChild(values.element)
        appendChild(modules.element)
        appendChild(help.element)
        appendChild(formulaDialog.element)
        appendChild(topicDialog.element)
        appendChild(noteDialog.element)
        appendChild(layouts.dialog.element)
        appendChild(scene.notice.element)
        appendChild(live.element)
    }

    init {
        changes.start(findings::show)
        board.onChange(values::refresh)
        board.onChange(comparison::followFormulas)
        comparison.onChange {
            scene.compared = comparison.drawn
            scene.openName = comparison.openName
            graphs.renew()
            search.again()
            values.refresh()
        }
        acceptFiles(onDrop = ::openDropped)
        notes.onChange {
            scene.notes = notes.now.notes
            redraw()
        }
        BoardDrag(board, graphs, boardSection)
        Keyboard(search, evidence, help, store::send)
    }

    /** The part of the page that stays when the log has grown. */
    val left: PageSnapshot
        get() = PageSnapshot(with(link.now) { PageAddress(visible = visible, video = video, opened = opened) }, rules.found, rules.ranAt)

    /**
     * Goes to the place in the address, and draws the graphs on the screen. If [left] is the state of an earlier page of this log, goes to
     * the newest moment instead. Call it when [element] is on the page.
     */
    fun start(left: PageSnapshot? = null) {
        left?.let(rules::continueFrom)
        link.start(left?.place) { asked ->
            board.begin(asked) { layout.board ?: boardAbove(view, signals) }
            folders.layOut(window.innerHeight / LOWEST - boardSection.cards.size)
        }
        if (left != null) store.send(PlaceAction.FollowEnd)
        opening.live.store = store
        PageEvents.onEnd { opening.live.store = null }
        graphs.start(boardSection.cards + evidence.cards + folders.cards)
        values.refresh()
    }

    /**
     * Lays out the whole page, and runs its rules on [logged], the recording with the exporter's formulas. Call it when the first graphs
     * are visible.
     *
     * @param compared the files of the logs that the page compares with its own from the beginning.
     * @param showsWorst whether to go to the worst finding, unless the reader has pinned the cursor somewhere before it is known.
     */
    fun complete(logged: LogView, compared: Promise<List<File>>, showsWorst: Boolean) {
        folders.layOut(Int.MAX_VALUE)
        compared.then(compareBar::open) { scene.notice.say("The compared log ${it.message}") }
        rules.start(logged) { found, incidents -> showFound(found, incidents, showsWorst) }
    }

    private fun showFound(found: LogFindings, incidents: List<Incident>, showsWorst: Boolean) {
        if (layout.board == null) board.beginAgain(boardAbove(view, signals, firstEvidenceOf(incidents, scene.findings.worstFirst)))
        // `has:finding` now finds more.
        search.followFindings()
        // The place in the address is known only now.
        link.followAgain()
        // A reader who has pinned the cursor in the meantime is not taken there. Nor is one who follows the log: the cursor is pinned at
        // its end.
        if (showsWorst && !scene.cursor.now.isPinned) findings.goToWorst(found.findings)
        // Draws into the existing graphs, since a reader may be dragging over one.
        if (found.findings.isNotEmpty()) redraw()
    }

    private fun redraw() {
        graphs.redraw()
        zoomBar.repaint()
    }

    /** Redraws everything with the current colors. */
    fun repaint() {
        graphs.repaint()
        modules.repaint()
        zoomBar.repaint()
    }

    private fun beforeFormulas() {
        link.leave()
        search.clear()
    }

    private fun linesNow() = BoardLines(formulas.view, hookGraphs)

    private fun openDropped(files: List<File>) {
        if (files.any { isZip(it) || isManifest(it) }) {
            return scene.notice.ask("The files of a match", "Open them as one log" to { opening.open(files) })
        }
        val logs = files.filterNot { layouts.buttons.open(it) || video.open(it) }
        val name = OpenedLog.logsIn(logs).firstOrNull()?.fileName ?: return
        scene.notice.ask(name, "Compare with this log" to { compareBar.open(logs) }, "Open instead" to { opening.open(logs) })
    }

    private fun send(said: String) {
        val text = listOfNotNull("${view.title ?: about.name}: $said", link.shared).joinToString("\n")
        sendMoment(scene, text, evidence.cards.map { it::drawOn })
    }

    /** Adds the graphs of [finding] to the board. */
    fun pinEvidence(finding: Finding, incident: Incident?) {
        val shown = evidenceBoard(view, incident.evidenceOf(finding), signals).graphs.filterNot(board.now::has)
        board.send(GraphChange.AddAll(shown))
        scene.notice.say("${countText(shown.size, "graph")} added to the board.")
    }

    /** Shows the evidence of a finding. */
    fun showEvidence(request: FindingRequest.Show) {
        evidence.show(request.place, request.incident, request.isWhole)
        values.refresh()
        if (evidence.cards.isEmpty()) inSight.showAny()
    }
}

/** The minimum height of almost all graphs, in pixels. */
private const val LOWEST = 100
