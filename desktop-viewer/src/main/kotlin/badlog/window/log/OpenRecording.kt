package badlog.window.log

import badlog.catalog.match.MatchMaker
import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.EventLog
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.enabledSpans
import badlog.core.recording.Topic
import badlog.files.LogFile
import badlog.files.ReadOptions
import badlog.files.readLog
import badlog.formats.LOG_FORMATS
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.folder.FolderRules
import badlog.signals.clock.FoundStation
import badlog.signals.match.MatchOfLog
import badlog.signals.match.matchOf
import badlog.signals.over
import badlog.signals.overItsTime
import badlog.signals.signalTopicsOf
import badlog.signals.timeColumn
import badlog.signals.vocabulary.SignalTopics
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.FolderLayout
import badlog.viewer.choices.board.identifiedByLines
import badlog.viewer.choices.board.standardBoard
import badlog.viewer.choices.board.withFallback
import badlog.viewer.choices.formula.Formula
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.Clocks
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.path.FieldFile
import badlog.viewer.draw.path.LogPaths
import badlog.viewer.panel.LogTimes
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.window.pen.SkiaImage
import badlog.window.task.assertOffWindow
import org.jetbrains.skia.Image
import java.nio.file.Path

/**
 * A recording that was read, with everything to draw.
 *
 * @property file the file it was read from; absolute.
 * @param read the content of the file.
 * @property choices a person's choices for it.
 * @property vocabulary the names of its signals.
 * @property layout the layout file beside it.
 * @property field the field on which its paths are drawn.
 * @param rows the same recording over its rows; null unless a person has chosen to draw it over its time.
 * @param before the stages of the same file for other choices; null for none.
 * @param checkActive see [LogStages].
 */
internal class OpenRecording(
    val file: Path,
    private val read: LogView,
    val choices: RecordingChoices = RecordingChoices(),
    val vocabulary: SignalVocabulary = RuleSet.BUILT_IN.signals,
    val layout: FolderLayout = FolderLayout.NONE,
    private val rows: LogView? = null,
    val field: FieldFile = FieldFile.NONE,
    before: LogStages? = null,
    checkActive: () -> Unit = {},
) {
    /** The definitions of the formulas calculated in it. */
    val definitions: List<String> get() = choices.definitions

    /** The Driver Station's log of the same match that is shown with it; null for none. */
    val station: FoundStation<LogFile>? get() = choices.station

    private val stages = LogStages(read, file.fileName.toString(), vocabulary, station, definitions, before, checkActive)

    /** The content of the file and of its [station]'s file. */
    val logged: LogView get() = stages.logged

    /** The view on which rules run. */
    val forRules: LogView get() = stages.forRules

    /** The names of the topics from its [station]. */
    val stationTopics: Set<String> get() = stages.stationTopics

    /** The match in which it was recorded. */
    val match: MatchOfLog by lazy { vocabulary.matchOf(read.recording, file.fileName.toString()) }

    /** The content of the file, and the topics of formulas. */
    val view: LogView get() = stages.view

    /** The result of each of [definitions], in order. */
    val formulas: List<Formula> get() = stages.formulas

    /** All signals to draw: the topics in the order of the file, topics of formulas, then the derived ones. */
    val signals: List<DrawableTopic> = signalsOf(view, formulas)

    /** The topics without any logged value: only a search lists them. */
    val empty: List<DrawableTopic> = view.recording.topics.filter { it !== view.xAxis.topic && it.samples.isEmpty() && it.texts.size == 0 }
        .map { DrawableTopic(it.name, isDerived = false, view.seriesOf(it)) }

    private val byName = signals.associateBy { it.name }

    /** The topics for the signals of [vocabulary]. */
    val signalTopics: SignalTopics by lazy { signalTopicsOf(view, vocabulary) }

    /** Returns the lines to draw for the signal [name]. */
    fun of(name: String): List<DrawableTopic> = signalTopics.of(name).mapNotNull { signal(it.topic) }

    /** The format of its times for people. */
    val times: LogTimes by lazy { LogTimes(span.width, view.xAxis, enabled) }

    /**
     * The initial graphs: the graphs of the [layout] beside it, or otherwise of its topics. Graphs of the [layout] that it cannot draw are
     * included. If it can draw none of them, the graphs of its topics follow.
     */
    val standardGraphs: Board by lazy { standardGraphs(pointed = emptyList()) }

    /**
     * Returns the initial graphs, see [standardGraphs], with graphs of the topics [pointed], to which a finding points. They are added only
     * if not all graphs of the topics are among the initial ones.
     */
    fun standardGraphs(pointed: List<String>): Board = (layout.layout?.board ?: Board()).identifiedByLines()
        .withFallback({ standardBoard(logged, vocabulary, pointed) }) { signal(it) != null }

    /** The events of all topics of texts. */
    val eventLogs: List<EventLog> = view.folders.flatMap { it.eventLogs }

    /** All events of [eventLogs], in the order of x. */
    val events: EventTimeline by lazy { EventTimeline.of(eventLogs) }

    /** The times when the robot was enabled; empty if they are unknown. */
    val enabled: List<EnabledSpan> by lazy { view.enabledSpans() }

    /** The robot's mode over x. */
    val modes: ModeTimeline by lazy { ModeTimeline.of(view) }

    /** The clocks besides the x axis. */
    val clocks: Clocks by lazy { Clocks(view, modes) }

    /** The range of x that has samples; wider if there is only a single x. */
    val span: Span = Viewport.of(view.xAxis.range).full

    /** The smallest x; 0 if there is none. */
    val firstX: Double = view.xAxis.range?.start ?: 0.0

    /** The places the cursor steps to. */
    val cursorSteps: CursorSteps = CursorSteps(view.xAxis.clocks)

    /** Its name for people: the match, or otherwise the name of the file. */
    val label: String get() = view.title ?: file.fileName.toString()

    /** The content for graphs of y over x. */
    val paths: LogPaths by lazy { LogPaths(view, field.field) { signal(it)?.line } }

    /** Its swerve drive; null for none. */
    val drive: SwerveDrive? by lazy { SwerveDrive.of(view) }

    /** The picture of its field; null if there is none, or it cannot be drawn. */
    val fieldPicture: SkiaImage? by lazy {
        val source = field.field.image?.source.orEmpty()
        // Skia rejects data that only begins like a picture.
        runCatching { field.picture?.let { SkiaImage(Image.makeFromEncoded(it), source) } }.getOrNull()
    }

    /** Returns the signal called [name], or null if this recording has none. */
    fun signal(name: String): DrawableTopic? = byName[name]

    /** Whether it is drawn over its [timeColumn], because a person has chosen that. */
    val isOverTime: Boolean get() = rows != null

    /** The time column of a recording that names no x axis. Null without such a column, or if an x axis is named. */
    val timeColumn: Topic? by lazy { (rows ?: read).recording.timeColumn() }

    /**
     * Returns the recording of the same file with the choices [wanted]; itself if it has them already. It may calculate all formulas and
     * read the file of a field: call it off the window's thread.
     *
     * @param library the folder of logs, see [FieldFile.of].
     * @param checkActive is called before each formula; an exception from it stops the work, and is passed on.
     */
    fun with(wanted: RecordingChoices, library: Path? = null, checkActive: () -> Unit = {}): OpenRecording {
        if (wanted == choices) return this
        assertOffWindow()
        val column = timeColumn
        val isOver = wanted.overTime && column != null
        val (changed, itsRows) = when {
            isOver == (rows != null) -> read to rows
            isOver -> LogView.of(read.recording.over(checkNotNull(column))) to read
            else -> checkNotNull(rows) to null
        }
        val isSameField = wanted.field == choices.field && wanted.fieldSelections == choices.fieldSelections
        val itsField = if (isSameField) field else fieldOf(file, wanted.field, library)
        return OpenRecording(file, changed, wanted, vocabulary, layout, itsRows, itsField, stages, checkActive)
            .also { it.prepare() }
    }

    /** Calculates in advance for graphs, panels and keys, so that the window's thread does not have to. */
    private fun prepare() {
        enabled
        forRules
        modes
        clocks
        events
        standardGraphs
        timeColumn
        signalTopics
        paths
        drive
        match
        fieldPicture
    }

    companion object {
        /**
         * Reads [file], an absolute path: a log, or a ZIP or `match.json` of a match.
         *
         * @param library the folder of logs, see [FolderRules.of]; null for the folder of [file] alone.
         * @param isGrowing whether text after the last line end is left out, as an incomplete row.
         * @param choices returns a person's choices for the log once it is read, given the layout beside it.
         * @param progress is called with the share that is done, from 0 to 1.
         * @throws badlog.files.NotReadException if it contains nothing to show.
         * @throws InterruptedException if the thread was interrupted.
         */
        fun read(
            file: Path,
            library: Path? = null,
            isGrowing: Boolean = false,
            choices: (FolderLayout) -> RecordingChoices = { RecordingChoices() },
            progress: (Float) -> Unit = {},
        ): OpenRecording {
            assertOffWindow()
            val recording = readLog(file, LOG_FORMATS, ReadOptions(untilLastLineEnd = isGrowing, maker = MatchMaker)) { done, total ->
                if (total > 0) progress(done.toFloat() / total)
            }.orThrow()
            val vocabulary = FolderRules.of(file, library).rules.signals
            val layout = FolderLayout.of(file, library) { vocabulary.matchOf(recording, file.fileName.toString()).type }
            val read = LogView.of(recording.overItsTime())
            val wanted = choices(layout)
            val column = if (wanted.overTime) read.recording.timeColumn() else null
            val shown = if (column == null) read else LogView.of(read.recording.over(column))
            val rows = read.takeIf { column != null }
            val field = fieldOf(file, wanted.field, library)
            val itsChoices = wanted.copy(overTime = column != null)
            return OpenRecording(file, shown, itsChoices, vocabulary, layout, rows, field, checkActive = ::checkInterrupt).also {
                it.prepare()
            }
        }

        /** Reads the field for [log]: from the [selected] file, or otherwise from the one beside the log. */
        fun fieldOf(log: Path, selected: Path?, library: Path?): FieldFile = selected?.let(FieldFile::read) ?: FieldFile.of(log, library)
    }
}

private fun checkInterrupt() {
    if (Thread.interrupted()) throw InterruptedException()
}

private fun signalsOf(view: LogView, formulas: List<Formula>): List<DrawableTopic> {
    val definitions = formulas.mapNotNull { formula -> formula.topic?.let { it.name to formula.definition } }.toMap()
    val logged = view.recording.topics
        .filter { it !== view.xAxis.topic && (it.samples.isNotEmpty() || it.texts.size > 0) }
        .map { topic -> definitions[topic.name].let { DrawableTopic(topic.name, isDerived = it != null, view.seriesOf(topic), it) } }
    val derived = view.folders.flatMap { it.graphs }
        .filter { graph -> graph.series.all { it.isDerived } }
        .map { DrawableTopic(it.name, isDerived = true, it.series.single()) }
    return logged + derived
}
