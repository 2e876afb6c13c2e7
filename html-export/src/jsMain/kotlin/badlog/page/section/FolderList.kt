package badlog.page.section

import badlog.analysis.LogView
import badlog.page.dom.Remembered
import badlog.page.dom.element
import badlog.page.graph.GraphCard
import badlog.page.view.Hits
import badlog.page.view.Query
import badlog.page.view.Scene
import org.w3c.dom.HTMLElement

/**
 * All folders, the root folder first. Which ones are closed is remembered for the file.
 *
 * @param fileKey tells this file from others.
 */
internal class FolderList(view: LogView, scene: Scene, fileKey: String) {
    private val key = "closed:$fileKey"
    private val closedBefore = Remembered[key].orEmpty().split('\n')

    /** The folders, in their order. */
    val sections: List<FolderSection> = view.folders.map { folder ->
        FolderSection(folder, scene, folder.name in closedBefore, ::remember)
    }

    /** All graphs, in their order. */
    val cards: List<GraphCard> = sections.flatMap { it.cards }

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

    private fun setAll(isClosed: Boolean) {
        for (section in sections) section.isClosed = isClosed
        remember()
    }

    private fun remember() {
        Remembered[key] = sections.filter { it.isClosed }.joinToString("\n") { it.folder.name }
    }
}
