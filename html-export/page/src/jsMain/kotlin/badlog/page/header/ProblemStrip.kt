package badlog.page.header

import badlog.core.analysis.LogView
import badlog.core.recording.Problem
import badlog.core.recording.Severity
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.isNarrow
import badlog.viewer.text.countText
import badlog.viewer.text.placeTextOf
import badlog.viewer.text.problemSummary
import badlog.viewer.text.word
import org.w3c.dom.HTMLElement

/**
 * The problems in the file: a summary line that unfolds to a list. On a wide screen and on paper, the list is open from the beginning if it
 * has 1 to [MAX_OPENED] errors. On a phone it opens on request, because it would push all graphs off the first screen.
 *
 * @param additions problems with the page's additions, which also open the list; on a phone only if the list is short.
 */
internal class ProblemStrip(private val view: LogView, private val additions: List<AdditionProblem> = emptyList()) {
    private val errors = view.count(Severity.ERROR)
    private val warnings = view.count(Severity.WARNING) + additions.size
    private val hints = view.count(Severity.NOTE)
    private val isListedAtOnce = additions.isNotEmpty() || errors in 1..MAX_OPENED
    private var wasOpen = false
    private lateinit var list: HTMLElement
    private lateinit var toggle: HTMLElement

    val element: HTMLElement = element("section", "problems") {
        id = "problems"
        setAttribute("data-errors", errors.toString())
        setAttribute("data-warnings", warnings.toString())
        setAttribute("data-hints", hints.toString())
        classList.add(
            when {
                errors > 0 -> "has-errors"
                warnings > 0 -> "has-warnings"
                else -> "has-hints"
            },
        )
        isHidden = errors + warnings + hints == 0
        setAttribute("aria-label", "Problems of this file")
        toggle = addButton("problems-toggle", "") { open(list.isHidden) }.apply {
            appendChild(Icon.CHEVRON.draw())
            add("span", "", problemSummary(view.problems, others = additions.size))
        }
        list = add("ul", "problem-list")
    }

    init {
        open(if (isNarrow) additions.isNotEmpty() && errors + warnings <= MAX_OPENED_ON_PHONE else isListedAtOnce)
    }

    /** Lists on paper, where nothing unfolds, the problems that a wide screen lists at once. */
    fun print(isOnPaper: Boolean) {
        if (isOnPaper) wasOpen = !list.isHidden
        open(wasOpen || (isOnPaper && isListedAtOnce))
    }

    private fun open(isOpen: Boolean) {
        toggle.setAttribute("aria-expanded", isOpen.toString())
        list.isHidden = !isOpen
        if (isOpen && list.childElementCount == 0) fill()
    }

    private fun fill() {
        list.addRows(Severity.ERROR)
        for (problem in additions) list.appendChild(row(problem))
        list.addRows(Severity.WARNING)
        if (hints == view.problems.size && additions.isEmpty()) {
            list.addRows(Severity.NOTE)
        } else if (hints > 0) {
            list.add("li").add("details", "hints") {
                add("summary", "", countText(hints, "hint"))
                add("ul").addRows(Severity.NOTE)
            }
        }
    }

    private fun HTMLElement.addRows(severity: Severity) {
        for (problem in view.problems) if (problem.severity == severity) appendChild(row(problem))
    }

    private fun row(problem: Problem): HTMLElement = element("li", "problem") {
        setAttribute("data-kind", problem.kind.name)
        add("span", "severity is-${problem.word}", problem.word)
        add("span", "problem-text") {
            add("span", "", problem.message)
            val place = placeTextOf(problem)
            if (place.isNotEmpty()) add("span", "problem-place", place)
        }
    }

    private fun row(problem: AdditionProblem): HTMLElement = element("li", "problem") {
        setAttribute("data-kind", "ADDITION")
        add("span", "severity is-warning", "warning")
        add("div", "problem-text") {
            add("span", "", problem.message)
            if (problem.pointer != null) add("pre", "pointer", problem.pointer)
        }
    }

    private companion object {
        const val MAX_OPENED = 5
        const val MAX_OPENED_ON_PHONE = 2
    }
}
