package badlog.page.section

import badlog.analysis.Folder
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.graph.GraphCard
import badlog.page.text.countText
import badlog.page.text.unitText
import badlog.page.view.Hits
import badlog.page.view.Query
import badlog.page.view.Scene
import org.w3c.dom.HTMLElement

/**
 * A folder: its values, its event logs, its graphs. All but the root folder can be closed.
 *
 * @param isClosed whether it is closed to begin with.
 * @param onToggle is told when a person opens or closes it.
 */
internal class FolderSection(
    val folder: Folder,
    scene: Scene,
    isClosed: Boolean,
    private val onToggle: () -> Unit,
) {
    private val values = folder.values.takeIf { it.isNotEmpty() }?.let(::ValueList)
    private val haystacks = folder.graphs.map { graph ->
        val lines = graph.series.joinToString(" ") { "${it.topic.name} ${unitText(it.unit)}" }
        "${graph.name} ${unitText(graph.unit)} $lines".lowercase()
    }
    private var toggle: HTMLElement? = null
    private var countLabel: HTMLElement? = null
    private lateinit var body: HTMLElement
    private var isSearching = false

    /** The event logs, in their order. */
    val tables: List<EventTable> = folder.eventLogs.map { EventTable(it, scene) }

    /** The graphs, in their order. */
    val cards: List<GraphCard> = folder.graphs.map { GraphCard(it, scene) }

    /** How much there is in it; while something is searched for, how much of that. */
    var count: Int = cards.size + tables.size
        private set(value) {
            field = value
            countLabel?.showText(countText(value))
        }

    /** Whether it was closed by a person. */
    var isClosed: Boolean = isClosed && folder.name.isNotEmpty()
        set(value) {
            field = value && folder.name.isNotEmpty()
            showOpenness()
        }

    val element: HTMLElement = element("section", "folder") {
        setAttribute("data-name", folder.name)
        if (folder.name.isEmpty()) setAttribute("aria-label", "Top level") else addHeading()
        body = add("div", "folder-body") {
            values?.let { appendChild(it.element) }
            for (table in tables) appendChild(table.element)
            for (card in cards) appendChild(card.element)
        }
    }

    init {
        showOpenness()
    }

    /** Shows what [query] finds in it, opened while something is searched for. */
    fun filter(query: Query): Hits {
        isSearching = !query.isEmpty
        var graphs = 0
        cards.forEachIndexed { i, card ->
            card.element.isHidden = !query.matches(haystacks[i])
            if (!card.element.isHidden) graphs++
        }
        val hits = Hits(graphs, values?.filter(query) ?: 0, tables.sumOf { it.filter(query) })
        count = if (isSearching) hits.sum else cards.size + tables.size
        element.isHidden = isSearching && hits.isEmpty
        showOpenness()
        return hits
    }

    /** Opens it and brings [part] of it into sight. */
    fun reveal(part: HTMLElement = element) {
        if (isClosed) {
            isClosed = false
            onToggle()
        }
        part.scrollIntoView()
    }

    private fun HTMLElement.addHeading() {
        add("h2", "folder-head") {
            toggle = addButton("folder-toggle", "") {
                isClosed = !isClosed
                onToggle()
            }.apply {
                appendChild(Icon.CHEVRON.draw())
                add("span", "folder-name", folder.name.split('/').joinToString(" / "))
                countLabel = add("span", "count", countText(count))
            }
        }
    }

    private fun showOpenness() {
        val isOpen = !isClosed || isSearching
        toggle?.setAttribute("aria-expanded", isOpen.toString())
        body.isHidden = !isOpen
    }
}
