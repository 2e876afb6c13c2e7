package badlog.window.app

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.snapshots.Snapshot
import badlog.catalog.folder.LogEntry
import badlog.core.analysis.EnabledSpan
import badlog.fetch.KnownHosts
import badlog.fetch.RobotAddress
import badlog.files.UserFolders
import badlog.viewer.choices.board.Board
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.shown.folder.headingOf
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.Shown
import badlog.viewer.state.Store
import badlog.window.battery.FolderSeason
import badlog.window.charts.FolderCharts
import badlog.window.choice.AxisChoice
import badlog.window.choice.FieldChoice
import badlog.window.choice.ShownRecordings
import badlog.window.choice.StationChoice
import badlog.window.compare.ComparedRecordings
import badlog.window.export.CutSaver
import badlog.window.export.PageSaver
import badlog.window.export.figure.FigureSaver
import badlog.window.files.FileChoice
import badlog.window.files.SystemFileChoice
import badlog.window.files.sayNoLog
import badlog.window.findings.CurrentFindings
import badlog.window.folder.Library
import badlog.window.folder.LibraryActions
import badlog.window.folder.LogOpener
import badlog.window.folder.NewLogs
import badlog.window.folder.SinceLastMatch
import badlog.window.formula.FormulaStore
import badlog.window.graph.SpokenCursor
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.scene.graphCommands
import badlog.window.layout.KeptLayouts
import badlog.window.layout.Layout
import badlog.window.layout.LayoutFiles
import badlog.window.layout.LayoutStore
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.FilteredEvents
import badlog.window.log.GraphBoard
import badlog.window.log.LiveView
import badlog.window.log.LogNotes
import badlog.window.log.OpenRecording
import badlog.window.log.RecordingChoices
import badlog.window.log.RecordingLoader
import badlog.window.log.RecordingReader
import badlog.window.log.RecordingWatcher
import badlog.window.log.StateVariable
import badlog.window.menu.Command
import badlog.window.menu.Keyboard
import badlog.window.robot.RecordedLog
import badlog.window.robot.RobotLink
import badlog.window.robot.RobotRecording
import badlog.window.settings.OwnFiles
import badlog.window.settings.Settings
import badlog.window.settings.SettingsStore
import badlog.window.sidebar.FrontPart
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import badlog.window.sidebar.Panels
import badlog.window.sidebar.TableSaver
import badlog.window.sidebar.WindowPanels
import badlog.window.task.FileWrites
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.todo.FolderTodo
import badlog.window.topics.TopicListing
import badlog.window.topics.foldersOf
import badlog.window.video.LogVideo
import badlog.window.video.Player
import badlog.window.video.isVideo
import badlog.window.video.unpackFfmpegInto
import badlog.window.welcome.SampleLog
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import java.awt.Toolkit
import java.nio.file.Path

/**
 * Creates the parts of a window and connects them: each receives the parts it needs, and none receives all. Use it only on the
 * window's thread; work is launched in [scope], off that thread.
 *
 * @param scope lives as long as the window, on its thread.
 * @param kept the stored settings.
 * @param robots returns the addresses to try for a robot, given the text that a person typed.
 */
internal class Viewer(
    val scope: CoroutineScope,
    private val folders: UserFolders,
    kept: Settings = Settings(),
    val files: FileChoice = SystemFileChoice,
    val notices: Notices = Notices(),
    robots: (String) -> List<RobotAddress> = { RobotAddress.of(it) },
) {
    val tasks = LongTasks(scope, notices)
    val writes = FileWrites()
    private val own = OwnFiles(folders, notices)
    val settings = SettingsStore(own, writes, kept)
    val panels = WindowPanels()
    val library = Library(scope, folders.answers, settings)
    val current = CurrentRecording()
    val store: Store = Store(StateVariable(), shownOfLog()) { perform(it) }
    val view = AxisView(store)
    val board: GraphBoard = GraphBoard(store, ::isDrawn)
    private val reader = RecordingReader({ library.state.folder }, ::choicesFor)
    val compared: ComparedRecordings = ComparedRecordings(current, tasks, reader)
    val axis = AxisChoice(current)
    val stations: StationChoice = StationChoice(current, settings, folder = { library.state.folder })
    val fields: FieldChoice = FieldChoice(current, settings, files, tasks, notices, folder = { library.state.folder })
    val formulas: FormulaStore = FormulaStore(current, board, notices)
    val live = LiveView(current, view) { recordedNow() }
    val shown: ShownRecordings =
        ShownRecordings(current, compared, board, view, notices, { placing(it) }, { library.state.folder }) { recording ->
            choicesFor(recording.file).run { copy(overTime = overTime && recording.timeColumn != null) }
        }
    val events = FilteredEvents(current)
    val topics = TopicListing()
    val player = Player(current, view)
    val findings: CurrentFindings = CurrentFindings(current, view, board, folder = { library.state.folder }, ::awaitDrawn)
    val since = SinceLastMatch(current, library)
    val batteries = FolderSeason(scope, library, notices) { panels.state.main in setOf(MainView.PIT, MainView.BATTERIES) }
    val notes = LogNotes(scope, current, notices, writes)
    val video = LogVideo(scope, current, view, player, settings, files, notices)
    val layouts: LayoutStore =
        LayoutStore(own, library, current, board, view, compared, axis, formulas, panels, notices, writes, shown::afterShown)
    val keptLayouts = KeptLayouts(library, current, layouts, tasks, notices)
    val layoutFiles = LayoutFiles(layouts, keptLayouts, library, current, files, tasks, notices)
    val pages = PageSaver(scope, current, compared, board, formulas, fields, library, files, tasks, notices)
    val figures = FigureSaver(scope, current, compared, view, events, findings, notes, board, files, tasks, notices)
    val cuts = CutSaver(current, view, files, tasks, notices)
    val tables = TableSaver(files, tasks, notices)
    val charts = FolderCharts(scope, library, files, tasks, notices)
    val todo = FolderTodo(scope, library, settings, files, tasks, notices, writes)
    val graphs = GraphScene(
        current,
        board,
        view,
        compared,
        events,
        findings,
        notes,
        player,
        settings,
        figures::copy,
        ::askForTopics,
        axis,
        stations,
        fields,
        live,
    )
    private val places = PlacesInLogs(topics, board, graphs.list)
    private val watcher = RecordingWatcher(
        notices,
        read = { shown, isGrowing -> reader.read(shown.file, isGrowing) },
        update = { read, isGrowing ->
            live.grows(read.file.takeIf { isGrowing })
            shown.show(read)
        },
        ended = { live.grows(null) },
    )
    val loader = RecordingLoader(scope, tasks, watcher, reader, layouts::formulasToRead, ::show)
    val opener = LogOpener(library, loader, files, notices)
    val robot = RobotLink(
        scope,
        KnownHosts(folders.settings.resolve("known_hosts")) { scope.launch { own.cannotSave(it) } },
        notices,
        folder = { library.state.folder },
        show = loader::open,
        robots,
    )
    private val recorded = RecordedLog(current, live, loader, notices, isWriting = {
        keyboard.isTyping || notes.draft != null ||
            formulas.sheet != null
    })
    val recording = RobotRecording(scope, notices, folder = { library.state.folder }, robots, recorded)
    val newest = NewestLog(library, current, loader, opener, notices, ::recordedNow, isInUse = ::isInUse)
    val newLogs: NewLogs =
        NewLogs(library, current, settings, ::recordedNow, isShownByItself = {
            newest.hasShown(it) && !isInUse()
        }, ring = { Toolkit.getDefaultToolkit().beep() })
    val logActions = LibraryActions(
        open = {
            newLogs.seen(it.file)
            show(it) { showingLog() }
        },
        openInGraphs = ::openInGraphs,
        openFindings = ::openFindings,
        check = compared::toggle,
        opener = opener,
        // A folder's log stays open until another replaces it.
        closeLog = { ::closeLog.takeIf { current.recording != null && library.state.isWithoutLogs } },
        toggleTable = { panels.change { toggled(MainView.LOGS) } },
        toggleCharts = { panels.change { toggled(MainView.CHARTS) } },
        togglePit = { panels.change { toggled(MainView.PIT) } },
        toggleBatteries = { panels.change { toggled(MainView.BATTERIES) } },
        toggleTodo = { panels.change { toggled(MainView.TODO) } },
        showGraphs = { panels.change { copy(main = MainView.GRAPHS) } },
    )
    val spoken = SpokenCursor(current, board, view)
    val keyboard = Keyboard()

    /** All keyboard commands, in the order of the help. */
    val commands: List<Command> =
        libraryCommands(
            library,
            panels,
            opener,
            ::showNewLog,
        ) + topicCommands(topics, panels) + actionCommands(view::press) +
            graphCommands(
                view,
                graphs::scroll,
                live::begin,
            ) + playbackCommands(player) + exportCommands(pages, figures, board) + layoutCommands(layoutFiles) +
            windowCommands(panels, formulas, view)

    init {
        unpackFfmpegInto(folders.cache.resolve("ffmpeg"))
    }

    /** Starts the background work of the window. */
    fun start() {
        scope.launch { own.check() }
        scope.launch { layouts.autosave() }
        scope.launch { shown.run() }
        scope.launch { stations.run() }
        scope.launch { findings.run() }
        scope.launch { since.run() }
        scope.launch { batteries.run() }
        scope.launch { notes.run() }
        scope.launch { keptLayouts.run() }
        scope.launch { video.run() }
        scope.launch { settings.autosave() }
        scope.launch { newest.run() }
        scope.launch { newLogs.run() }
        scope.launch { robot.run() }
        scope.launch { recording.run() }
        scope.launch { todo.run() }
    }

    /** Shows [recording], which was just read, in one step for all observers. */
    fun show(recording: OpenRecording) = Snapshot.withMutableSnapshot {
        layouts.keepArranged()
        current.recording?.let { places.leave(it.file) }
        // What changed while the file was read follows, see ShownRecordings.
        current.replace(recording)
        formulas.replaceAll(layouts.formulasFor(recording.file, recording.layout))
        topics.change { listing(foldersOf(recording.signals)) }
        compared.share(recording)
        layouts.showGraphs(recording, isGrowing = recording.file == recordedNow())
        places.enter(recording.file)
        view.send(PlaceAction.Open(recording.span))
        live.opened()
        panels.change { copy(front = FrontPart.GRAPHS) }
        library.select(recording.file)
        recording.layout.problem?.let(notices::complain)
        recording.field.problem?.let(notices::complain)
    }

    /** Moves the keyboard focus to the search for topics, which are then added to graph [id]. */
    private fun askForTopics(id: Int) {
        topics.change { adding(id) }
        askForTopics(topics, panels)
    }

    /** Opens the files dropped onto the window: a layout, a video, or else folders and logs. */
    fun openDropped(paths: List<Path>) {
        val (videos, rest) = paths.partition(::isVideo)
        if (videos.isNotEmpty()) openVideo(videos.first())
        if (rest.isEmpty()) return
        val (layouts, others) = rest.partition { it.fileName.toString().endsWith(Layout.ENDING, ignoreCase = true) }
        when {
            layouts.isEmpty() -> opener.openNamed(others)
            current.recording != null -> layoutFiles.open(layouts.first())
            others.isEmpty() -> sayNoLog(notices)
            else -> opener.openNamed(others)
        }
    }

    private fun openVideo(file: Path) {
        video.open(file)
        if (video.state.file != null) panels.change { inspecting(InspectorTab.VIDEO).copy(main = MainView.GRAPHS) }
    }

    /** Returns the person's choices for the log in [file]. Thread-safe. */
    private fun choicesFor(file: Path) =
        RecordingChoices(formulas.definitions, axis.state == true, stations.shownWith(file), fields.selectedFor(file), fields.selections)

    private fun openInGraphs(entry: LogEntry) {
        show(entry) { copy(main = MainView.GRAPHS) }
    }

    /** Shows the log of [entry], with the keyboard's focus, and changes the panels by [step]. */
    private fun show(entry: LogEntry, step: Panels.() -> Panels) {
        opener.open(entry)
        if (!entry.isReadable) return
        panels.change(step)
        graphs.isFocusAsked = true
    }

    private fun openFindings(entry: LogEntry) {
        // An open log keeps its graphs.
        if (entry.file != current.recording?.file) openInGraphs(entry)
        if (!entry.isReadable) return
        panels.change { copy(main = MainView.GRAPHS, inspector = InspectorTab.FINDINGS) }
        findings.showWorst(entry.file)
    }

    /** Shows the newest log, at its worst finding. */
    fun showNewLog() {
        newLogs.takeLatest()?.let(::openFindings)
    }

    private suspend fun awaitDrawn() {
        if (panels.state.main == MainView.GRAPHS) graphs.awaitDrawn()
    }

    /** Whether the window shows its welcome: no log is open or being read, and the folder has none. */
    val isWithoutLogs: Boolean get() = current.recording == null && !loader.isReading && library.state.isWithoutLogs

    /** The heading of the window. */
    val heading: String by derivedStateOf {
        val open = current.recording
        val isListed = library.state.run { folder == null || !hasLooked || entries.any { it.file == open?.file } }
        if (open == null) "badlog" else headingOf(open.label, isListed)
    }

    /** Opens the sample match without its folder. That folder is part of the cache, not a place for the user’s own logs. */
    fun openSample() {
        tasks.run("Opening the sample match", { SampleLog.unpack(folders.cache) }, loader::open)
    }

    /** Closes the open log, which is in no folder of logs; so the window shows its welcome again. */
    private fun closeLog() = Snapshot.withMutableSnapshot {
        loader.stop()
        compared.clear()
        formulas.closeSheet()
        current.recording?.let { places.close(it.file) }
        current.close()
        board.replace(Board())
        panels.change { copy(main = MainView.GRAPHS, front = FrontPart.GRAPHS) }
    }

    /** Asks for the robot to copy logs from, and first for a folder if there is none yet. */
    fun askForRobot() {
        if (library.state.folder == null) opener.askForFolder("Select a folder for the robot’s logs")
        if (library.state.folder == null) return
        panels.change { copy(library = true, main = MainView.GRAPHS, front = FrontPart.LOGS) }
        robot.change { shown() }
    }

    /** The log that this window is recording now; null for none. */
    private fun recordedNow(): Path? = recording.state.file

    private fun shownOfLog() = object : Shown {
        override val isOpen: Boolean get() = current.recording != null
        override val samples: CursorSteps get() = current.recording?.cursorSteps ?: CursorSteps(emptyList())
        override val enabled: List<EnabledSpan> get() = current.recording?.enabled.orEmpty()
        override val found: RuleResults? get() = findings.state.list
        override val graphs: Board get() = board.state
        override val graph: Int? get() = board.current?.id
        override val newest: Double? get() = live.newest
    }

    private fun isDrawn(line: String): Boolean {
        val open = current.recording ?: return true
        return open.signal(line) != null || formulas.isAwaited(line, open)
    }

    private fun placing(show: () -> Unit) = layouts.following(show)

    private fun isInUse() =
        topics.state.query.isNotEmpty() || !layouts.isUntouched || player.state.isPlaying || panels.state.main != MainView.GRAPHS
}
