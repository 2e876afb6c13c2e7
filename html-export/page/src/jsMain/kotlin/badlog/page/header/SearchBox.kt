package badlog.page.header

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addTextField
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.page.view.SearchCounts
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.search.Trait
import kotlinx.browser.window
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.events.KeyboardEvent

/** The search box. [search] is called after each change, and returns the matches. */
internal class SearchBox(private val search: (Query) -> SearchCounts) {
    private lateinit var input: HTMLInputElement
    private lateinit var count: HTMLElement

    val element: HTMLElement = element("div", "search") {
        setAttribute("role", "search")
        appendChild(Icon.SEARCH.draw())
        val hint = if (window.innerWidth <= SHORT_WIDTH) "Search" else "Search topics, values, events"
        input = addTextField("search-input", "search", "Search", hint)
        count = add("output", "search-count")
        add("kbd", "search-key", "/")
    }

    init {
        input.type = "search"
        count.setAttribute("for", "search")
        input.addEventListener("input", { run() })
        input.addEventListener("keydown", { event ->
            if (event.unsafeCast<KeyboardEvent>().key == "Escape") {
                event.stopPropagation()
                clear()
            }
        })
    }

    /** The searched text; empty if there is no search. */
    val text: String get() = input.value

    /** Searches for [text]. */
    fun show(text: String) {
        input.value = text
        run()
    }

    /** Focuses the box and selects its text. */
    fun focus() {
        input.focus()
        input.select()
    }

    /** Ends the search, so that the page shows everything again. */
    fun clear() {
        if (input.value.isEmpty()) input.blur()
        show("")
    }

    /** Repeats the search if it depends on findings. */
    fun followFindings() {
        if (Query(input.value).asksFor(Trait.FINDING)) run()
    }

    /** Repeats the search because the graphs were replaced. */
    fun again() {
        if (text.isNotEmpty()) run()
    }

    private fun run() {
        val query = Query(input.value)
        val hits = search(query)
        count.showText(if (query.isEmpty) "" else hits.text())
        element.classList.toggle("is-active", !query.isEmpty)
    }
}

/** The maximum window width, in CSS pixels, at which the style sheet keeps the box short. */
private const val SHORT_WIDTH = 1100
