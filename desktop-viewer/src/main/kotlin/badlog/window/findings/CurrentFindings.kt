package badlog.window.findings

import androidx.compose.runtime.snapshotFlow
import badlog.catalog.folder.SignalAssignment
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.rules.folder.FolderRules
import badlog.rules.incident.evidenceOf
import badlog.rules.incident.firstEvidenceOf
import badlog.rules.incident.incidentsIn
import badlog.rules.over
import badlog.viewer.choices.board.evidenceBoard
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.shown.finding.firstStep
import badlog.viewer.state.FindingAction
import badlog.viewer.state.PlaceAction
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.state.StateHolder
import badlog.window.task.assertOffWindow
import badlog.window.task.returnUnusedMemory
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.filterNotNull
import kotlinx.coroutines.runInterruptible
import kotlinx.coroutines.withTimeoutOrNull
import java.nio.file.Path
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * The findings in the current recording. Use it only on the window's thread. Rules run in the background, after its graphs are drawn, and
 * again when it has grown; another recording cancels them.
 *
 * @param folder returns the folder of logs, which may have rules.
 * @param awaitDrawn waits until the opened recording is visible.
 * @param rest waits until the rules may run again over a growing log, after they took the time `running`.
 * @param find runs the rules over a recording.
 */
internal class CurrentFindings(
    private val current: CurrentRecording,
    private val view: AxisView,
    private val board: GraphBoard,
    private val folder: () -> Path?,
    private val awaitDrawn: suspend () -> Unit,
    private val rest: suspend (running: Duration) -> Unit = { delay(pauseAfter(it)) },
    private val find: (view: LogView, file: Path, library: Path?) -> RuleResults = ::findingsOf,
) : StateHolder<Findings>(Findings()) {
    /** The log that will show its worst finding once that is known; null for none. */
    private var worstRequested: Path? = null

    /** The finding that a person went to last; null for none. */
    val selected: Finding? get() = view.visited?.finding

    /** The finding with its time shaded in the graphs; null for none. */
    val shown: Finding? get() = state.pointed ?: selected

    /** Runs the rules over each opened log, until cancelled. */
    suspend fun run() {
        var before: Path? = null
        snapshotFlow { RulesRequest(current.recording?.file, folder(), state.timesAsked) }.collectLatest { wanted ->
            change { unknown() }
            view.send(FindingAction.Forget)
            select(null)
            // A person has opened another log in the meantime.
            if (wanted.file != before && wanted.file != worstRequested) worstRequested = null
            before = wanted.file
            if (wanted.file == null) return@collectLatest
            withTimeoutOrNull(PATIENCE) { awaitDrawn() }
            snapshotFlow { current.recording?.takeIf { it.file == wanted.file }?.forRules }.filterNotNull().conflate().collect { logged ->
                val began = TimeSource.Monotonic.markNow()
                val list = runInterruptible(Dispatchers.IO) { find(logged, wanted.file, wanted.library) }
                change { withList(list) }
                // A growing log may have the same finding again, as another object.
                select(selected?.let(list::like))
                view.send(FindingAction.Know)
                if (worstRequested == wanted.file) goToWorst() else beginWithFirst(list)
                if (logged.recording.sampleCount > MANY_SAMPLES) runInterruptible(Dispatchers.IO) { returnUnusedMemory() }
                rest(began.elapsedNow())
            }
        }
    }

    /**
     * Goes to the worst result for [log] as soon as the rules have run: the start of its worst incident, or otherwise its worst finding.
     * The log is open or being opened.
     */
    fun showWorst(log: Path) {
        worstRequested = log
        if (current.recording?.file == log && state.list != null) goToWorst()
    }

    private fun goToWorst() {
        worstRequested = null
        val list = state.list ?: return
        firstStep(list.all, list.incidents)?.let { view.send(FindingAction.GoTo(it.place, it.incident, isWhole = it.incident != null)) }
    }

    /** Adds the graphs of the first result, unless a person has arranged other graphs. */
    private fun beginWithFirst(list: RuleResults) {
        val open = current.recording ?: return
        if (!board.shows(open.standardGraphs)) return
        board.beginWith(open.standardGraphs(firstEvidenceOf(list.incidents, list.all)))
    }

    /** Runs the rules over the open log again; until they are done, no findings are known. */
    fun runAgain() = change { copy(timesAsked = timesAsked + 1) }

    /** Assigns [topic] to the signal [signal] in all logs of the folder, and runs the rules again. If that fails, it reports the reason. */
    fun assign(signal: String, topic: String) {
        val open = current.recording ?: return
        val refusal = SignalAssignment(open.file, folder()).assign(signal, topic, open.forRules)
        view.send(FindingAction.Refuse(refusal))
        if (refusal == null) runAgain()
    }

    /** Records the [finding] under the pointer; null for none. If the pointer is on its mark, [place] is the x there. */
    fun point(finding: Finding?, place: Double = Double.NaN) = change { copy(pointed = finding, pointedPlace = place) }

    /** Goes to [place], where [finding] was found, see [FindingAction.GoTo]. */
    fun goTo(finding: Finding, place: Double = finding.time) =
        view.send(FindingAction.GoTo(placeOf(finding, place), state.list?.incidentOf(finding)))

    /** Shows, above all other graphs, the evidence of [finding] and of its incident. */
    fun showEvidence(finding: Finding) {
        val open = current.recording ?: return
        board.showEvidence(evidenceBoard(open.view, state.list?.incidentOf(finding).evidenceOf(finding), open.vocabulary))
    }

    private fun select(finding: Finding?) {
        if (finding === selected) return
        view.send(PlaceAction.Visit(finding?.let { placeOf(it, view.visited?.span?.from ?: Double.NaN) }))
    }

    private fun placeOf(finding: Finding, from: Double) =
        FindingPlace(finding, finding.severity, finding.places.find { it.from == from } ?: Span(from, from))

    private data class RulesRequest(val file: Path?, val library: Path?, val timesAsked: Int)

    private companion object {
        val PATIENCE = 3.seconds

        /** The number of samples in a log that needs more memory than all else in the window. */
        const val MANY_SAMPLES = 5_000_000L
    }
}

/**
 * Returns the pause after the rules took the time [running] over a growing log. It leaves the machine mostly free for the program that
 * writes the log.
 */
internal fun pauseAfter(running: Duration): Duration = maxOf(2.seconds, running * 9)

/**
 * Runs the rules for [file], which was read as [view]. Call it off the window's thread; interrupting the thread cancels it.
 *
 * @param library the folder of logs, see [FolderRules.of].
 */
internal fun findingsOf(view: LogView, file: Path, library: Path?): RuleResults {
    assertOffWindow()
    val rules = FolderRules.of(file, library)
    return try {
        val found = rules.rules.over(view, file.fileName.toString(), isEverywhere = true) {
            if (Thread.interrupted()) throw InterruptedException()
        }
        val source = rules.file?.let { "${it.fileName} in ${it.parent.fileName}" }
        RuleResults(found.findings, found.skipped, rules.rules.incidentsIn(found.findings), found.ran, source, rules.problem)
    } catch (_: OutOfMemoryError) {
        RuleResults(trouble = "There is not enough memory to run the rules over this log; close other logs and run them again.")
    }
}

/**
 * The state of the open recording's findings.
 *
 * @property list the findings; null until the rules have run.
 * @property pointed the finding under the pointer, or null.
 * @property pointedPlace the x of the pointer on the finding's mark; NaN if the pointer is on its line in a list.
 * @property timesAsked the number of a person's requests to run the rules again.
 */
internal data class Findings(
    val list: RuleResults? = null,
    val pointed: Finding? = null,
    val pointedPlace: Double = Double.NaN,
    val timesAsked: Int = 0,
) {
    /** The names of the topics that a finding is about. */
    val topics: Set<String> get() = list?.topics.orEmpty()

    /** Returns the findings with [list]. */
    fun withList(list: RuleResults): Findings = copy(list = list, pointed = pointed?.let(list::like))

    /** Returns the findings without a list. */
    fun unknown(): Findings = Findings(timesAsked = timesAsked)
}
