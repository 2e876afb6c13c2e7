package badlog.page.section

import badlog.analysis.Folder
import badlog.analysis.Graph
import badlog.analysis.LogView
import badlog.html.protocol.HookPart
import badlog.page.dom.LocalStorage
import badlog.page.dom.element
import badlog.page.graph.GraphCard
import badlog.page.view.Hits
import badlog.page.view.Scene
import badlog.plot.search.Query
import org.w3c.dom.HTMLElement

/**
 * All folders, the root folder first, then one for each hook. Which ones are closed is remembered for the file.
 *
 * @param fileKey identifies the file.
 * @param origin what calculated a graph, if it was not logged; else empty.
 */
internal class FolderList(
    view: LogView,
    private val scene: Scene,
    fileKey: String,
    hooks: List<HookPart>,
    private val origin: (Graph) -> String,
) {
    private val key = "closed:$fileKey"
    private val closedBefore = LocalStorage[key].orEmpty().split('\n')
    private val own = view.folders.mapTo(ArrayList(), ::sectionOf)
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
    }

    /** Opens all folders. */
    fun openAll() = setAll(false)

    /** Closes all folders but the root folder. */
    fun closeAll() = setAll(true)

    /** Shows what [query] finds. */
    fun filter(query: Query): Hits {
        var hits = Hits()
        for (section in sections) hits += section.filter(query)
        return hits
    }

    /** Adds [graph] to its folder, which is made if need be, and where it [isWanted] now opens that and brings it into sight. */
    fun add(graph: Graph, isWanted: Boolean = true): GraphCard {
        val section = own.find { it.folder.name == graph.folder } ?: newSection(graph.folder)
        val card = GraphCard(graph, scene, origin(graph))
        section.add(card)
        if (isWanted) section.reveal(card.element)
        return card
    }

    /** Takes away the graph called [name], and its folder if that is empty then. */
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
        val section = sectionOf(Folder(name, emptyList(), emptyList(), emptyList()))
        val next = own.indexOfFirst { it.folder.name.lowercase() > name.lowercase() }.let { if (it < 0) own.size else it }
        val following = sections.getOrNull(next)
        own.add(next, section)
        element.insertBefore(section.element, following?.element)
        return section
    }

    private fun sectionOf(folder: Folder) = FolderSection(folder, scene, folder.name in closedBefore, ::remember, origin)

    private fun setAll(isClosed: Boolean) {
        for (section in sections) section.isClosed = isClosed
        remember()
    }

    private fun remember() {
        LocalStorage[key] = sections.filter { it.isClosed }.joinToString("\n") { it.folder.name }
    }
}
