package badlog.page.findings

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.bringIntoSight
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.graph.GraphCard
import badlog.page.graph.VisibleGraphs
import badlog.page.view.Scene
import badlog.page.view.graphsOf
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.rules.incident.evidenceOf
import badlog.rules.incident.nextOf
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.evidenceBoard
import badlog.viewer.choices.board.evidenceOffers
import badlog.viewer.choices.board.shortTitles
import badlog.viewer.choices.board.with
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.shown.finding.placeNumber
import badlog.viewer.state.GraphChange
import badlog.viewer.text.word
import org.w3c.dom.HTMLElement

/**
 * The evidence of a finding at one place: its sentences, the next step, and its graphs, together on one screen. Hidden until a person goes
 * to a finding.
 *
 * @param onStep called to go to another place of the same finding, with the number of places to advance.
 * @param onSend called to send the shown evidence, with its sentences.
 */
internal class EvidenceSection(
    private val scene: Scene,
    private val graphs: VisibleGraphs,
    private val signals: SignalVocabulary,
    private val onStep: (Int) -> Unit,
    private val onSend: (String) -> Unit,
) {
    private var board = Board()
    private val drawn = ArrayList<GraphCard>()
    private var said = ""
    private lateinit var severity: HTMLElement
    private lateinit var heading: HTMLElement
    private lateinit var steps: HTMLElement
    private lateinit var number: HTMLElement
    private lateinit var text: HTMLElement
    private lateinit var next: HTMLElement
    private lateinit var caveats: HTMLElement
    private lateinit var body: HTMLElement
    private lateinit var offers: HTMLElement
    private lateinit var keep: HTMLElement

    val element: HTMLElement = element("section", "evidence card") {
        id = "evidence"
        setAttribute("aria-label", "Evidence")
        add("header", "graph-head") {
            severity = add("span")
            heading = add("h2", "findings-title")
            steps = add("span", "evidence-steps") {
                addIconButton("", Icon.BACK, "Previous place") { onStep(-1) }
                number = add("span", "unit") { setAttribute("role", "status") }
                addIconButton("evidence-next", Icon.BACK, "Next place") { onStep(1) }
            }
            add("div", "graph-tools") {
                addIconButton("", Icon.SEND, "Send this moment: a picture with these sentences") { onSend(said) }.id = "send-moment"
                keep = addIconButton("", Icon.PIN, "Keep these graphs on the board") { keep() }.apply { id = "keep-evidence" }
                addIconButton("", Icon.CLOSE, "Close the evidence (Escape)") { close() }.id = "close-evidence"
            }
        }
        text = add("div")
        next = add("p", "evidence-text incident-next")
        caveats = add("div")
        body = add("div", "folder-body")
        offers = add("div", "evidence-offers")
        isHidden = true
    }

    val isOpen: Boolean get() = !element.isHidden

    /** The cards of the graphs that it shows. */
    val cards: List<GraphCard> get() = drawn

    /**
     * Shows the finding at [place], with all evidence of its [incident] if there is one. If [isWhole], shows the sentences of the whole
     * incident.
     */
    fun show(place: FindingPlace<Finding>, incident: Incident?, isWhole: Boolean) {
        val finding = place.finding
        val whole = incident.takeIf { isWhole }
        val word = (whole?.severity ?: finding.severity).word
        severity.className = "severity is-$word"
        severity.showText(word)
        heading.showText(whole?.name ?: finding.rule)
        steps.isHidden = whole != null || finding.places.size < 2
        number.showText(finding.placeNumber(place.span))
        text.textContent = ""
        val sentences = whole?.sentences?.map { it.text } ?: listOf(finding.textAt(place.span))
        for (sentence in sentences) text.add("p", "evidence-text", sentence)
        said = sentences.joinToString(" ")
        val advice = incident.nextOf(finding)
        next.isHidden = advice.isEmpty()
        next.showText("Next: $advice")
        caveats.textContent = ""
        for (caveat in finding.caveats) caveats.add("p", "evidence-text evidence-caveat", caveat)
        element.isHidden = false
        draw(evidenceBoard(scene.view, incident.evidenceOf(finding), signals))
        element.bringIntoSight()
    }

    /** Hides the section. */
    fun close() {
        draw(Board())
        element.isHidden = true
    }

    /** Moves the graphs to the board. */
    private fun keep() {
        val kept = board.graphs
        draw(Board())
        scene.store.send(GraphChange.AddAll(kept.filterNot(scene.board.now::has)))
        keep.isHidden = true
        offers.textContent = ""
    }

    private fun draw(wanted: Board) {
        if (!wanted.showsSame(board)) {
            board = wanted
            for (card in drawn) {
                graphs.remove(card)
                card.element.remove()
            }
            drawn.clear()
            for ((spec, title) in board.graphs.zip(board.shortTitles)) {
                for ((graph, lines) in graphsOf(spec, scene.board.lines)) {
                    val card = GraphCard(graph, scene, look = spec, lines = lines)
                    card.title = title
                    body.appendChild(card.element)
                    graphs.add(card)
                    drawn += card
                }
            }
        }
        keep.isHidden = board.graphs.isEmpty()
        offers.textContent = ""
        for (offer in evidenceOffers(scene.view, signals, board)) {
            offers.addButton("text-button", "+ ${offer.label}", offer.topics.joinToString()) {
                draw(board.with(offer, scene.view, signals))
            }
        }
    }
}
