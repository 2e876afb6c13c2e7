package badlog.page.findings

import badlog.core.analysis.LogView
import badlog.core.recording.TopicKind
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import badlog.page.dom.isHidden
import badlog.page.dom.panelRoom
import badlog.page.dom.saveFile
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.rules.AssignedSignals
import badlog.page.view.Notice
import badlog.page.view.Scene
import badlog.rules.Finding
import badlog.signals.assigning
import badlog.signals.refusalOf
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.panel.finding.FindingsShown
import badlog.viewer.panel.finding.findingsPanel
import badlog.viewer.panel.finding.isFixed
import badlog.viewer.session.link.FindingName
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.shown.finding.firstStep
import badlog.viewer.state.Action
import badlog.viewer.state.FindingAction
import org.w3c.dom.HTMLElement
import org.w3c.files.Blob

/**
 * The findings of the log, see [findingsPanel]. Hidden while there is nothing to show.
 *
 * @param signals the signals that a reader assigned to topics.
 * @param embedded the findings that were known when the page was made.
 * @param hasRules whether rules will run.
 * @param differences returns the differences between the log and the logs before it.
 * @param send lets an action change the state.
 */
internal class FindingsSection(
    private val scene: Scene,
    private val signals: SignalChoice,
    embedded: List<Finding>,
    private val hasRules: Boolean,
    private val differences: () -> List<Finding>,
    private val send: (Action) -> Unit,
) {
    private val nodes = PartNodes(scene.palette, send)
    private var drawn: FindingPlace<Finding>? = null
    private var isRunning = hasRules
    private var isInside = false

    val element: HTMLElement = element("section", "findings card") {
        id = "findings"
        setAttribute("aria-label", "Findings")
        // Not before: nothing may move below a finger or a button that is pressed.
        for (type in listOf("click", "keyup")) {
            addEventListener(type, {
                isInside = true
                keepHeight()
            })
        }
    }

    /** The findings of the rules, and the embedded ones. */
    var found: RuleResults = RuleResults(embedded)
        set(value) {
            field = value
            isRunning = false
            scene.findings = value.timeline
            show()
        }

    private val state get() = scene.store.state.findings

    init {
        scene.store.onChange { if (scene.visited !== drawn || it.findings != state || it.unfolded != scene.store.state.unfolded) show() }
        show()
    }

    /** Shows [trouble], the reason why the rules could not be run, beside the known findings. */
    fun fail(trouble: String) {
        found = RuleResults(found.all, found.skipped, found.incidents, found.ran, trouble = trouble)
    }

    /** The number of findings that match the search; 0 without a search. */
    val hits: Int get() = if (state.query.isBlank()) 0 else found.foundBy(state.query).findings.size

    /** Goes to the place that a reader should see first among [findings]. Lists of logs and the window do the same, see [firstStep]. */
    fun goToWorst(findings: List<Finding>) {
        firstStep(findings, found.incidents)?.let { send(FindingAction.GoTo(it.place, it.incident, isWhole = it.incident != null)) }
    }

    /** Goes to the finding named [name] that begins at [x], otherwise to the worst one there. Returns whether there is one. */
    fun visitAt(x: Double, name: FindingName?): Boolean {
        val place = scene.findings.placeAt(x) { name?.isOf(it) == true } ?: return false
        send(FindingAction.GoTo(place, found.incidentOf(place.finding)))
        return true
    }

    /** Focuses the link of the finding that the reader has gone to, without scrolling. Returns whether the finding is listed. */
    fun focusCurrent(): Boolean {
        val finding = scene.visited?.finding ?: return false
        val row = element.querySelector(".finding[aria-current]") ?: element.querySelector("[aria-current]") ?: return false
        val links = row.querySelectorAll(".event-go")
        // An incident has a link for each of its sentences, a row of a finding has only its own.
        val index = found.incidentOf(finding)?.sentences.orEmpty().indexOfFirst { it.finding === finding }
        val link = links.item(maxOf(0, index)) ?: links.item(0) ?: return false
        link.unsafeCast<HTMLElement>().focusInPlace()
        return true
    }

    /** Lists more findings if [isOnPaper], because nothing can be unfolded on paper. */
    fun print(isOnPaper: Boolean) = send(if (isOnPaper) FindingAction.ListMore else FindingAction.ListFew)

    /** Updates the section to the current state. */
    fun show() {
        val isGone = drawn !== scene.visited
        drawn = scene.visited
        val parts = findingsPanel(
            FindingsShown(
                found,
                isRunning,
                state,
                drawn,
                scene.times,
                differences(),
                signals.topics,
                signals.assigned,
                isComparing = scene.compared.isNotEmpty(),
                room = panelRoom,
                unfolded = scene.store.state.unfolded,
            ),
        )
        element.patch(nodes.of(parts))
        element.isHidden = parts.isEmpty()
        keepHeight()
        element.classList.toggle(
            "has-spans",
            found.all.any { finding ->
                finding.spans.firstOrNull()?.let { it.to > finding.time } == true
            },
        )
        if (!isGone) return
        val list = element.querySelector(".is-long")?.unsafeCast<HTMLElement>() ?: return
        val row = list.querySelector("[aria-current]")?.unsafeCast<HTMLElement>() ?: return
        // Scrolls only the list: everything above and below it stays where it is.
        list.scrollTop = (row.offsetTop - list.offsetTop - list.clientHeight / 2).toDouble()
    }

    private fun keepHeight() {
        element.classList.toggle("is-fixed", panelRoom.isFixed(hasRules, scene.enabled.isNotEmpty(), isInside || drawn != null))
    }
}

/**
 * Lets a person assign topics of [log] to signals that rules lack.
 *
 * @param signals the vocabulary of the page.
 * @param onChange called when a signal has another topic, because everything depends on it.
 */
internal class SignalChoice(
    private val log: LogView,
    private val signals: SignalVocabulary,
    private val notice: Notice,
    private val onChange: () -> Unit,
) {
    /** The topics that can be a signal. */
    val topics: List<String> by lazy { log.recording.topics.filter { it.kind != TopicKind.EMPTY }.map { it.name } }

    /** The topic of each signal that the reader assigned. */
    val assigned: Map<String, String> = AssignedSignals.of(log.recording).associate { it.key to it.value }

    /** Assigns [topic] to [signal], or shows why that is impossible. */
    fun assign(signal: String, topic: String) {
        val refusal = refusalOf(signal, topic, log, signals.assigning(signal, topic))
        if (refusal != null) return notice.say(refusal)
        AssignedSignals.assign(signal, topic)
        onChange()
    }

    /** Restores the original topic of [signal]. */
    fun forget(signal: String) {
        AssignedSignals.forget(signal)
        onChange()
    }

    /** Saves the assignments as a file for the folder of logs. */
    fun save() = saveFile(Blob(arrayOf(AssignedSignals.fileOf(AssignedSignals.of(log.recording)))), "badlog-signals.toml")
}
