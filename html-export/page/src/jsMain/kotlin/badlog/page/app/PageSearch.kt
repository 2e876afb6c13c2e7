package badlog.page.app

import badlog.core.analysis.GraphSeries
import badlog.page.dom.bringIntoSight
import badlog.page.dom.isHidden
import badlog.page.graph.GraphCard
import badlog.page.view.Scene
import badlog.page.view.SearchCounts
import badlog.viewer.shown.search.Query
import badlog.viewer.state.FindingAction
import kotlinx.browser.window

/** Shows the matches of [query], and scrolls to them if necessary. */
internal fun LogPage.show(query: Query): SearchCounts {
    boardSection.filter(query)
    val inFolders = folders.filter(query)
    store.send(FindingAction.Search(query.text))
    val hits = inFolders + SearchCounts(findings = findings.hits, notes = noteList.filter(query))
    nothingFound.isHidden = query.isEmpty || !hits.isEmpty
    navigation.update(isSearching = !query.isEmpty)
    eventsLink.update()
    values.filter(query)
    // The findings begin above the screen if the page was scrolled before. They begin below it if there is a board above.
    val top = content.getBoundingClientRect().top
    val isBelow = top > window.innerHeight / 2 && !inFolders.isEmpty
    if (!query.isEmpty && (top < 0 || isBelow)) content.bringIntoSight()
    return hits
}

/**
 * The lines of the page's graphs.
 *
 * @param chosen returns the graphs of the board and the evidence.
 * @param folders returns the graphs of the folders.
 */
internal class PageLines(private val scene: Scene, private val chosen: () -> List<GraphCard>, private val folders: () -> List<GraphCard>) {
    /** Returns the lines of the board and the evidence, or of the folders if there is neither. */
    fun shown(): List<GraphSeries> = chosen().ifEmpty(folders).flatMap { it.series }

    /** Returns the lines of the folders and of all topics that have values. */
    fun all(): List<GraphSeries> = folders().flatMap { it.series } +
        scene.view.recording.topics.filter { it !== scene.xAxis.topic }.map(scene.view::seriesOf)
            .filter { it.states != null || it.topic.samples.isNotEmpty() }
}
