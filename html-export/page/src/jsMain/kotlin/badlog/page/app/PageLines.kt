package badlog.page.app

import badlog.core.analysis.GraphSeries
import badlog.page.graph.GraphCard
import badlog.page.view.Scene

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
