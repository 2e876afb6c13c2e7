package badlog.page.section

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Finding
import badlog.page.view.FindingPlace
import badlog.page.view.Query
import badlog.page.view.Scene
import badlog.plot.text.countText
import badlog.plot.text.decimalsFor
import badlog.recording.Severity
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * What was found in the recording, the worst first: a few at once, all when asked for. A finding takes the cursor to its time.
 *
 * @param onJump is called when the cursor was taken somewhere.
 */
internal class FindingList(private val scene: Scene, private val onJump: () -> Unit) {
    private val all = scene.findings.worstFirst
    private val haystacks = all.map { "${it.source} ${it.word} ${it.text}".lowercase() }
    private val decimals = decimalsFor(scene.range.full.width)
    private val rows = HashMap<Finding, HTMLElement>()
    private var found = all
    private var listed = 0
    private var current: FindingPlace? = null
    private lateinit var count: HTMLElement
    private lateinit var list: HTMLElement
    private lateinit var body: HTMLElement
    private lateinit var more: HTMLElement
    private lateinit var fewer: HTMLElement

    val element: HTMLElement = element("section", "findings card") {
        id = "findings"
        setAttribute("aria-label", "Findings")
        isHidden = all.isEmpty()
        classList.toggle("has-spans", all.any { it.end > it.time })
        add("header", "graph-head") {
            add("h2", "findings-title", "Findings")
            count = add("span", "unit")
        }
        list = add("div", "findings-list") { body = add("ol") }
        add("div", "findings-more") {
            more = addButton("text-button", "") { list(listed + PAGE) }
            fewer = addButton("text-button", "Show fewer") { list(FEW) }
        }
    }

    init {
        showFound()
    }

    /** Shows the findings that [query] finds, and tells how many they are. */
    fun filter(query: Query): Int {
        found = if (query.isEmpty) all else all.filterIndexed { i, _ -> query.matches(haystacks[i]) }
        showFound()
        element.isHidden = found.isEmpty()
        return if (query.isEmpty) 0 else found.size
    }

    /** Goes to the next finding after the cursor, or the one before it when [steps] is negative. */
    fun step(steps: Int) {
        scene.findings.beside(current, scene.cursor.x, steps)?.let(::go)
    }

    private fun showFound() {
        val share = if (found.size == all.size) "" else "${countText(found.size)} of ${countText(all.size)}: "
        val parts = Severity.entries.reversed().mapNotNull { severity ->
            val number = found.count { it.severity == severity }
            if (number == 0) null else countText(number, severity.name.lowercase())
        }
        count.showText(share + parts.joinToString())
        list(FEW)
    }

    private fun list(wanted: Int) {
        // Nobody unfolds a list for two lines more.
        val until = if (found.size <= wanted + 2) found.size else wanted
        if (until < listed || wanted == FEW) {
            body.textContent = ""
            rows.clear()
            listed = 0
        }
        for (finding in found.subList(listed, until)) {
            val row = findingRow(finding, decimals, { go(it.places[0]) }, { zoom(it.places[0]) })
            rows[finding] = row
            body.appendChild(row)
        }
        listed = until
        more.isHidden = listed == found.size
        val left = found.size - listed
        more.showText(if (left > PAGE) "Show more (${countText(left)} are left)" else "Show all ${countText(found.size)}")
        val isLong = listed > FEW + 2
        fewer.isHidden = !isLong
        // What scrolls has to answer to the keys.
        if (isLong) list.setAttribute("tabindex", "0") else list.removeAttribute("tabindex")
        list.classList.toggle("is-long", isLong)
        mark()
    }

    private fun go(place: FindingPlace) {
        current = place
        scene.goTo(place.span.from)
        mark()
        onJump()
    }

    private fun zoom(place: FindingPlace) {
        current = place
        scene.zoomTo(place.span.from, place.span.to)
        mark()
        onJump()
    }

    private fun mark() {
        for ((finding, row) in rows) {
            if (finding == current?.finding) row.setAttribute("aria-current", "true") else row.removeAttribute("aria-current")
        }
    }

    private companion object {
        /** So many stand on the page before a person asks for more. */
        val FEW = if (window.innerWidth > NARROW) 5 else 3

        /** The widest of narrow screens in pixels, as the style sheet has it. */
        const val NARROW = 760

        /** So many rows are made at a time. */
        const val PAGE = 300
    }
}
