package badlog.page.findings

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import badlog.page.dom.isHidden
import badlog.page.dom.isNarrow
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.page.view.end
import badlog.page.view.isPlaced
import badlog.rules.Finding
import badlog.rules.NotLookedAt
import badlog.rules.SkippedRule
import badlog.rules.incident.Incident
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.session.link.FindingName
import badlog.viewer.shown.finding.FindingOrder
import badlog.viewer.shown.finding.FindingSearch
import badlog.viewer.shown.finding.SearchedFindings
import badlog.viewer.shown.finding.firstStep
import badlog.viewer.shown.search.Query
import badlog.viewer.text.countText
import badlog.viewer.text.decimalsFor
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * What was found in the recording: incidents, then the findings that none of them mentions, the worst first; at first a few of those that
 * belong to no incident, on a phone the worst incident alone, all on request. Selecting a finding moves the cursor to its time, and shows
 * what is around it. Hidden while there is nothing to show.
 *
 * @param signals asks which topics are the signals that rules lack.
 * @param changes what is shown above all findings.
 * @param onVisit called when a person goes to a place, with the incident if it is part of one, and whether all of that was meant.
 * @param onPin called when a person wants to keep the graphs that show a finding.
 */
internal class FindingList(
    private val scene: Scene,
    private val signals: SignalChoice,
    changes: HTMLElement,
    private val onVisit: (FindingPlace<Finding>, Incident?, isWhole: Boolean) -> Unit,
    private val onPin: (Finding, Incident?) -> Unit,
) {
    private var search = FindingSearch(emptyList(), emptyList())
    private var query = Query("")
    private var found = search.foundBy(query)
    private val decimals = decimalsFor(scene.range.full.width)
    private val rows = HashMap<Finding, HTMLElement>()
    private val incidentRows = LinkedHashMap<Incident, HTMLElement>()

    // Those of them that no incident above the list mentions; first those that belong to none, `outside` in number.
    private var unmentioned = emptyList<Finding>()
    private var outside = 0
    private var listed = 0
    private val all: List<Finding> get() = search.all
    private val incidents: List<Incident> get() = search.incidents
    private val current: Finding? get() = scene.visited?.finding

    /** The order in which keys go through them. */
    var order: FindingOrder = FindingOrder(scene.findings, incidents)
        private set

    private var isSearching = false
    private var haveRun = false
    private lateinit var count: HTMLElement
    private lateinit var incidentList: HTMLElement
    private lateinit var list: HTMLElement
    private lateinit var body: HTMLElement
    private lateinit var more: HTMLElement
    private lateinit var fewer: HTMLElement
    private lateinit var hiddenNote: HTMLElement
    private lateinit var hiddenCount: HTMLElement
    private lateinit var mistakes: HTMLElement
    private lateinit var skipped: HTMLElement

    val element: HTMLElement = element("section", "findings card") {
        id = "findings"
        setAttribute("aria-label", "Findings")
        add("header", "graph-head") {
            add("h2", "findings-title", "Findings")
            count = add("span", "unit") { setAttribute("role", "status") }
        }
        appendChild(changes)
        mistakes = add("ul", "problem-list")
        incidentList = add("ol", "incidents") { setAttribute("aria-label", "Incidents") }
        hiddenNote = add("p", "findings-hidden") {
            hiddenCount = add("span")
            addButton("text-button", "Show them") { show(Query("")) }.id = "show-findings"
        }
        list = add("div", "findings-list") { body = add("ol") }
        add("div", "findings-more") {
            more = addButton("text-button", "") { list(listed + PAGE) }
            fewer = addButton("text-button", "Show fewer") { fold() }
        }
        skipped = add("details", "findings-skipped")
        appendChild(signals.chosen)
    }

    init {
        mistakes.isHidden = true
        skipped.isHidden = true
        show()
    }

    /** Shows that rules are still running, unless they end soon. */
    fun wait() {
        isSearching = true
        window.setTimeout({ if (isSearching) showFound() }, PATIENCE)
    }

    /** Shows the current findings of the scene, their [incidents], and which rules were skipped or are wrong; the others [ran]. */
    fun show(ran: Int, skippedRules: List<SkippedRule>, incidents: List<Incident>) {
        haveRun = true
        show(skippedRules, incidents, NotLookedAt(ran, skippedRules))
    }

    private fun show(
        skippedRules: List<SkippedRule> = emptyList(),
        incidents: List<Incident> = emptyList(),
        notLookedAt: NotLookedAt? = null,
    ) {
        isSearching = false
        search = FindingSearch(scene.findings.worstFirst, incidents)
        order = FindingOrder(scene.findings, incidents)
        element.classList.toggle("has-spans", all.any { it.end > it.time })
        val (wrong, lacking) = skippedRules.partition { it.isMistake }
        mistakes.textContent = ""
        mistakes.isHidden = true
        skipped.textContent = ""
        skipped.isHidden = true
        for (rule in wrong) addProblem("The rule “${rule.rule}” is wrong. ${rule.message.substringBefore('\n')}", rule.message)
        if (notLookedAt != null && lacking.isNotEmpty()) {
            skipped.isHidden = false
            skipped.add("summary", "", notLookedAt.text)
            skipped.appendChild(signals.fieldsFor(notLookedAt.lacking))
            skipped.add("ul") { for (rule in lacking) add("li", "", "${rule.rule}: ${rule.message}") }
        }
        filter(query)
    }

    /** Shows that the rules could not be run, because of [reason]. */
    fun fail(reason: String) {
        isSearching = false
        addProblem("The rules could not be run (${reason.trimEnd('.')}); reload the page, or run badlog report on the file.")
        showFound()
    }

    /** Shows the findings that [query] finds, and returns their number. */
    fun filter(query: Query): Int {
        this.query = query
        show(query)
        return if (query.isEmpty) 0 else found.findings.size
    }

    private fun show(query: Query) {
        found = search.foundBy(query)
        showIncidents()
        unmentioned = found.beside.outside + found.beside.within
        outside = found.beside.outside.size
        showFound()
    }

    /** Lists more on paper, where nothing can be unfolded, than on the screen. */
    fun print(isOnPaper: Boolean) {
        if (isOnPaper) list(PAGE) else fold()
    }

    /** Goes to what to see first of [found], as a list of logs and the window do, see [firstStep]. */
    fun goToWorst(found: List<Finding>) {
        firstStep(found, incidents)?.let { visit(it.place, it.incident, isWhole = it.incident != null) }
    }

    /** Goes [steps] places forward within the same finding, or back if [steps] is negative. */
    fun stepWithin(steps: Int) {
        val visited = scene.visited ?: return
        scene.findings.within(visited.finding, visited.span.from, steps)?.let { visit(it) }
    }

    /** Goes to the finding that begins at [x] and is called [name], or else to the worst one there. Returns whether there is one. */
    fun visitAt(x: Double, name: FindingName?): Boolean {
        val place = scene.findings.placeAt(x) { name?.isOf(it) == true } ?: return false
        visit(place)
        return true
    }

    /** Gives the keyboard's focus to the link of the finding that the reader has gone to. Nothing scrolls. Returns whether it is listed. */
    fun focusCurrent(): Boolean {
        val finding = current ?: return false
        val incident = incidentRows.keys.find { finding in it }
        val links = (rows[finding] ?: incidentRows[incident])?.querySelectorAll(".event-go") ?: return false
        // An incident has a link for each finding that has a place, a row of a finding has only its own.
        val index = incident?.sentences.orEmpty().map { it.finding }.filter { it.isPlaced }.indexOf(finding)
        val link = links.item(maxOf(0, index)) ?: links.item(0) ?: return false
        link.unsafeCast<HTMLElement>().focusInPlace()
        return true
    }

    private fun addProblem(text: String, pointed: String = "") {
        mistakes.isHidden = false
        mistakes.add("li", "problem") {
            add("span", "severity is-warning", "warning")
            add("div", "problem-text") {
                add("span", "", text)
                if ('\n' in pointed) add("pre", "pointer", pointed.substringAfter('\n'))
            }
        }
    }

    private fun showIncidents() {
        incidentList.textContent = ""
        incidentRows.clear()
        for (incident in found.incidents) {
            val pin = { onPin(incident.sentences.first().finding, incident) }
            val row = incidentRow(incident, decimals, pin) { finding, isWhole -> visit(firstPlaceOf(finding), incident, isWhole) }
            incidentRows[incident] = row
            incidentList.appendChild(row)
        }
        incidentList.isHidden = found.incidents.isEmpty()
    }

    private fun showFound() {
        val waiting = if (isSearching) "running the rules…" else ""
        val texts = if (all.isEmpty() && haveRun) listOf(SearchedFindings.NOTHING) else listOf(found.counts, waiting)
        count.showText(texts.filter { it.isNotEmpty() }.joinToString())
        hiddenNote.isHidden = found.hidden.isEmpty()
        hiddenCount.showText("${found.hidden} ")
        element.isHidden = all.isEmpty() && !isSearching && !haveRun && mistakes.isHidden
        fold()
    }

    /** Lists a few, as at first; on a phone, whose first screen shall have a graph, the worst incident and the one that was gone to. */
    private fun fold() {
        body.textContent = ""
        rows.clear()
        listed = 0
        val few = if (!isNarrow) {
            FEW
        } else if (incidentRows.isEmpty()) {
            1
        } else {
            0
        }
        // Nobody unfolds a list for two more lines.
        val slack = if (isNarrow && few == 0) 0 else SLACK
        list(if (outside <= few + slack) outside else few, isFolded = true)
    }

    private fun list(wanted: Int, isFolded: Boolean = false) {
        val until = minOf(maxOf(wanted, listed), unmentioned.size)
        for (finding in unmentioned.subList(listed, until)) {
            val row = findingRow(finding, decimals, { onPin(it, incidentOf(it)) }) { visit(firstPlaceOf(it)) }
            rows[finding] = row
            body.appendChild(row)
        }
        listed = until
        val others = incidentRows.entries.drop(1)
        for ((incident, row) in others) row.isHidden = isFolded && isNarrow && !isCurrent(incident)
        val left = unmentioned.size - listed + others.count { (_, row) -> row.isHidden }
        more.isHidden = left == 0
        more.showText(if (left > PAGE) "Show more (${countText(left)} left)" else "Show ${countText(left)} more")
        fewer.isHidden = isFolded
        val isLong = !isFolded && listed > 0
        // Anything that scrolls must react to keys.
        if (isLong) list.setAttribute("tabindex", "0") else list.removeAttribute("tabindex")
        list.classList.toggle("is-long", isLong)
        mark()
    }

    private fun firstPlaceOf(finding: Finding) = FindingPlace(finding, finding.severity, finding.places[0])

    private fun incidentOf(finding: Finding): Incident? = incidents.find { finding in it }

    private fun visit(place: FindingPlace<Finding>, incident: Incident? = incidentOf(place.finding), isWhole: Boolean = false) {
        scene.place.change { visiting(place) }
        show(place, incident, isWhole)
    }

    /** Shows the row of [place], to which the reader has gone; of its [incident] if that [isWhole]. */
    fun show(place: FindingPlace<Finding>, incident: Incident?, isWhole: Boolean) {
        val index = unmentioned.indexOf(place.finding)
        if (index >= listed || incidentRows[incident]?.isHidden == true) list(maxOf(index + 1, listed))
        mark()
        onVisit(place, incident, isWhole)
    }

    private fun mark() {
        for ((finding, row) in rows) row.markCurrent(finding == current)
        for ((incident, row) in incidentRows) row.markCurrent(isCurrent(incident))
        val row = rows[current] ?: return
        // Scrolls only the list: everything above and below it stays where it is.
        if (list.classList.contains("is-long")) list.scrollTop = (row.offsetTop - list.offsetTop - list.clientHeight / 2).toDouble()
    }

    private fun isCurrent(incident: Incident) = current?.let { it in incident } == true

    private fun HTMLElement.markCurrent(isCurrent: Boolean) {
        if (isCurrent) setAttribute("aria-current", "true") else removeAttribute("aria-current")
    }

    private companion object {
        /** The number of findings shown until a person asks for more, on a screen that is not narrow. */
        const val FEW = 5

        /** The number of further ones that are shown, too, if these are all. */
        const val SLACK = 2

        /** The number of rows created at a time. */
        const val PAGE = 300

        /** Milliseconds before running rules are mentioned. */
        const val PATIENCE = 400
    }
}
