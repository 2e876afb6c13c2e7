package badlog.viewer.app

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.analysis.Span
import badlog.plot.range.Viewport
import badlog.plot.timeline.EventTimeline
import badlog.viewer.compare.Comparison
import badlog.viewer.compare.ComparisonLoading
import badlog.viewer.files.FileChoice
import badlog.viewer.files.SystemFileChoice
import badlog.viewer.findings.Findings
import badlog.viewer.findings.RuleRunning
import badlog.viewer.formula.FormulaKeeping
import badlog.viewer.formula.FormulaSheet
import badlog.viewer.graph.GraphList
import badlog.viewer.graph.PlotGesture
import badlog.viewer.graph.plot.Plots
import badlog.viewer.keyboard.Command
import badlog.viewer.keyboard.Keyboard
import badlog.viewer.layout.LayoutKeeping
import badlog.viewer.library.LibraryFolder
import badlog.viewer.library.LibraryState
import badlog.viewer.panels.Panels
import badlog.viewer.playback.Playback
import badlog.viewer.recording.EventFilter
import badlog.viewer.recording.OpenRecording
import badlog.viewer.recording.RecordingLoading
import badlog.viewer.settings.Settings
import badlog.viewer.settings.UserFolders
import badlog.viewer.statistics.StatisticsChoice
import badlog.viewer.task.LongTasks
import badlog.viewer.task.Notices
import badlog.viewer.topic.TopicList
import kotlinx.coroutines.CoroutineScope

/**
 * All that a window shows, in parts that change apart from each other. Each part is plain data: a change replaces it by what
 * one of its transitions gives. To be used on the window's thread only; work is launched in [scope], off that thread.
 *
 * @param scope lives as long as the window, on its thread.
 * @property folders where the user's own files are.
 * @property files asks for files and folders.
 * @property notices what the window has to say.
 */
internal class Viewer(
    val scope: CoroutineScope,
    val folders: UserFolders,
    settings: Settings = Settings(),
    val files: FileChoice = SystemFileChoice,
    val notices: Notices = Notices(),
) {
    /** What the person has chosen. */
    var settings by mutableStateOf(settings)

    /** The folder of logs. */
    var library by mutableStateOf(LibraryState())

    /** The recording that is shown, or null. */
    var open by mutableStateOf<OpenRecording?>(null)

    /** What is drawn of it. */
    var graphs by mutableStateOf(GraphList())

    /** Which part of x is seen. */
    var viewport by mutableStateOf(Viewport(Span(0.0, 1.0)))

    /** Where on x the cursor stands, the same in all graphs; null for nowhere. */
    var cursor by mutableStateOf<Double?>(null)

    /** Whether the cursor stays where it is rather than going with the pointer. */
    var isCursorPinned by mutableStateOf(false)

    /** What is being dragged over a graph now, or null. */
    var gesture by mutableStateOf<PlotGesture?>(null)

    /** The part of x that a person has marked, or null. */
    var selection by mutableStateOf<Span?>(null)

    /** How the cursor runs by itself. */
    var playback by mutableStateOf(Playback())

    /** What is laid over the open recording. */
    var comparison by mutableStateOf(Comparison())

    /** Which topics and statistics the table across recordings has. */
    var statisticsChoice by mutableStateOf(StatisticsChoice())

    /** How the list of topics is searched and folded, and which are chosen there. */
    var topicList by mutableStateOf(TopicList())

    /** Which events are listed and marked. */
    var eventFilter by mutableStateOf(EventFilter())

    /** The events of the open recording that [eventFilter] lets through. */
    val matchingEvents: EventTimeline by derivedStateOf { open?.let { eventFilter.over(it.events, it.eventLogs) } ?: EventTimeline.NONE }

    /** The definitions of topics that are calculated from others, in the order in which they may use each other. */
    var formulas by mutableStateOf<List<String>>(emptyList())

    /** The formula that a person is writing, or null. */
    var formulaSheet by mutableStateOf<FormulaSheet?>(null)

    /** What rules found in the open recording. */
    var findings by mutableStateOf(Findings())

    /** Which parts of the window are open. */
    var panels by mutableStateOf(Panels())

    /** The pictures of the graphs. */
    val plots = Plots()

    /** What a person is waiting for. */
    val tasks = LongTasks(scope, notices)

    /** Reads what is compared. */
    val comparisonLoading = ComparisonLoading(this)

    /** Runs the rules over the open recording. */
    val ruleRunning = RuleRunning(this)

    /** Calculates the formulas. */
    val formulaKeeping = FormulaKeeping(this)

    /** Remembers how the window is arranged. */
    val layouts = LayoutKeeping(this)

    /** Opens recordings. */
    val loading = RecordingLoading(this)

    /** Keeps [library] as its folder is. */
    val libraryFolder = LibraryFolder(this)

    /** Who hears the keys. */
    val keyboard = Keyboard()

    /** What they do. */
    val commands: List<Command> = allCommands(this)
}
