package badlog.page.section

import badlog.analysis.LogView
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.embedded.About
import badlog.page.graph.GraphDeck
import badlog.page.view.Hits
import badlog.page.view.Query
import badlog.page.view.Scene
import org.w3c.dom.HTMLElement

/** The page of a recording, put together. */
internal class LogPage(
    view: LogView,
    about: About,
    downloads: Downloads,
    theme: ThemeSwitch,
) {
    private val scene = Scene(view)
    private val folders = FolderList(view, scene, "${about.name}:${about.inflatedBytes}")
    private val navigation = FolderNavigation(folders)
    private val search = SearchBox(::filter)
    private val eventsLink = EventsLink(folders)
    private val zoomBar = ZoomBar(scene, listOf(search.element, navigation.choice, eventsLink.element))
    private val help = HelpOverlay()
    private val deck = GraphDeck(scene, folders.cards)
    private val nothingFound = element("p", "nothing-found", "Nothing matches. Escape clears the search.")

    private lateinit var content: HTMLElement

    private val tools = listOf(
        downloads.element,
        element("div", "page-settings") {
            appendChild(theme.element)
            addIconButton("", Icon.HELP, "Keys and gestures (?)") { help.toggle() }.id = "help-button"
        },
    )

    val element: HTMLElement = element("div", "log-page") {
        appendChild(pageHeader(scene, about, tools))
        appendChild(ProblemStrip(view).element)
        appendChild(zoomBar.element)
        add("div", "columns") {
            appendChild(navigation.list)
            content = add("div", "content") {
                appendChild(nothingFound)
                appendChild(folders.element)
                appendChild(infoSection(view, about))
            }
        }
        appendChild(help.element)
    }

    init {
        nothingFound.isHidden = true
        Keyboard(scene, zoomBar, search, help)
    }

    /** Draws the graphs; to be called when [element] is on the page. */
    fun start() = deck.start()

    /** Draws everything that has colours of its own again. */
    fun repaint() {
        deck.repaint()
        zoomBar.repaint()
    }

    private fun filter(query: Query): Hits {
        val hits = folders.filter(query)
        nothingFound.isHidden = query.isEmpty || !hits.isEmpty
        navigation.update()
        eventsLink.update()
        // What was found begins above the screen when the page was scrolled before.
        if (!query.isEmpty && content.getBoundingClientRect().top < 0) content.scrollIntoView()
        return hits
    }
}
