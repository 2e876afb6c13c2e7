package badlog.page.folder

import badlog.core.analysis.Folder
import badlog.core.analysis.Graph
import badlog.page.dom.LocalStorage
import badlog.page.dom.element
import badlog.page.graph.GraphCard
import badlog.page.view.Scene
import badlog.page.view.SearchCounts
import badlog.protocol.HookPart
import badlog.viewer.choices.mergedWith
import badlog.viewer.shown.outline.LogOutline
import badlog.viewer.shown.outline.OutlineFolder
import badlog.viewer.shown.search.Query
import org.w3c.dom.HTMLElement

/**
 * All folders: the root folder first, each hook's folder last. The browser remembers the closed folders of each file.
 *
 * @param fileKey identifies the file.
 * @param outline the graphs that are drawn initially, and those that are only listed.
 * @param onDraw called with each graph that is drawn on request.
 * @param onLeave called with each such graph that is removed.
 * @param origin returns the origin of a graph that was calculated; empty for a logged one.
 */
internal class FolderList(
    outline: LogOutline,
    private val scene: Scene,
    fileKey: String,
    hooks: List<HookPart>,
    private val onDraw: (GraphCard) -> Unit,
    private val onLeave: (GraphCard) -> Unit,
    private val origin: (Graph) -> String,
) {
    private val key = "closed:$fileKey"
    private val closedBefore = remembered()

    /** The closed folders as this tab last showed or stored them. */
    private var known = closedBefore
    private val own = outline.folders.mapTo(ArrayList(), ::sectionOf)
    private val folded = FoldedTopics(outline, scene, { add(it) }, onDraw)
    private val ofHooks = hooks.filter(::hasSection).map { hook ->
        val folder = folderOf(hook)
        FolderSection(folder, scene, folder.name in closedBefore, ::remember, { "from ${hook.name}" }, hook)
    }

    /** The folders, in their order. */
    val sections: List<FolderSection> get() = own + ofHooks

    /** All graphs, in their order. */
    val cards: List<GraphCard> get() = sections.flatMap { it.cards }

    val element: HTMLElement = element("div", "folders") {
        for (section in sections) appendChild(section.element)
        appendChild(folded.element)
    }

    /** Lays out the folders with the first [graphs] graphs. Laying out the folders below would delay the first graphs. */
    fun layOut(graphs: Int) {
        var above = 0
        for (section in sections) {
            section.element.style.display = if (above < graphs) "" else "none"
            above += section.count
        }
    }

    /** Opens all folders. */
    fun openAll() = setAll(false)

    /** Closes all folders except the root folder. */
    fun closeAll() = setAll(true)

    /** Shows the parts of the folders that match [query]. */
    fun filter(query: Query): SearchCounts {
        // A few matches are drawn at once; many remain a list to select from.
        val drawsListed = sections.sumOf { it.countListed(query) } <= MAX_DRAWN
        var hits = folded.filter(query)
        for (section in sections) hits += section.filter(query, drawsListed)
        return hits
    }

    /** Adds [graph] to its folder, which is created if necessary. If [isWanted], opens the folder and scrolls to the graph. */
    fun add(graph: Graph, isWanted: Boolean = true): GraphCard {
        for (section in own) {
            val there = section.cards.find { it.graph === graph } ?: continue
            return there.also { section.reveal(it.element) }
        }
        val section = own.find { it.folder.name == graph.folder } ?: newSection(graph.folder)
        val card = GraphCard(graph, scene, origin(graph))
        section.add(card)
        if (isWanted) section.reveal(card.element)
        return card
    }

    /** Removes the graph named [name], and its folder if that is then empty. */
    fun remove(name: String): GraphCard? {
        val section = own.find { section -> section.cards.any { it.graph.name == name } } ?: return null
        val card = section.cards.first { it.graph.name == name }
        section.remove(card)
        if (section.count == 0 && section.folder.values.isEmpty()) {
            own -= section
            section.element.remove()
        }
        return card
    }

    private fun newSection(name: String): FolderSection {
        val section = sectionOf(OutlineFolder(Folder(name, emptyList(), emptyList(), emptyList())))
        val next = own.indexOfFirst { it.folder.name.lowercase() > name.lowercase() }.let { if (it < 0) own.size else it }
        val following = sections.getOrNull(next)
        own.add(next, section)
        element.insertBefore(section.element, following?.element ?: folded.element)
        return section
    }

    private fun sectionOf(part: OutlineFolder): FolderSection {
        val folder = part.folder
        val isClosed = folder.name in closedBefore
        return FolderSection(folder, scene, isClosed, ::remember, origin, listed = part.listed, onDraw = onDraw, onLeave = onLeave)
    }

    private fun setAll(isClosed: Boolean) {
        for (section in sections) section.isClosed = isClosed
        remember()
    }

    private fun remember() {
        val own = known.filter { name -> sections.none { it.folder.name == name } } + sections.filter { it.isClosed }.map { it.folder.name }
        LocalStorage[key] = own.mergedWith(remembered(), known).joinToString("\n")
        known = own
    }

    private fun remembered() = LocalStorage[key]?.split('\n').orEmpty()
}

/** The maximum number of listed graphs that a search draws. */
private const val MAX_DRAWN = 12
