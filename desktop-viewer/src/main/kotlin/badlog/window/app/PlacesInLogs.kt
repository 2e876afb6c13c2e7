package badlog.window.app

import androidx.compose.foundation.lazy.LazyListState
import badlog.viewer.choices.board.BoardGraph
import badlog.window.log.GraphBoard
import badlog.window.topics.TopicListing
import java.nio.file.Path

/**
 * Where a person was in each log since the window was opened: what the topics are searched for, and how far they and the graphs are
 * scrolled. Use it only on the window's thread.
 *
 * @param graphs the scroll state of the graphs of [board].
 */
internal class PlacesInLogs(private val topics: TopicListing, private val board: GraphBoard, private val graphs: LazyListState) {
    /**
     * @property topic the number of the first visible row of the topics, and [topicOffset] what is hidden of it.
     * @property graph the first visible graph, and [graphOffset] what is hidden of that: graphs of a finding may be above it.
     */
    private class Place(
        val query: String,
        val topic: Int,
        val topicOffset: Int,
        val graph: Pair<List<String>, Boolean>?,
        val graphOffset: Int,
    )

    /** The logs that were opened last are the last. */
    private val known = LinkedHashMap<Path, Place>()

    /** Remembers where the person is in [file]. */
    fun leave(file: Path) {
        known.remove(file)
        known[file] = Place(
            topics.state.query,
            topics.list.firstVisibleItemIndex,
            topics.list.firstVisibleItemScrollOffset,
            board.state.graphs.getOrNull(graphs.firstVisibleItemIndex)?.let(::drawn),
            graphs.firstVisibleItemScrollOffset,
        )
        if (known.size > MOST) known.remove(known.keys.first())
    }

    /** Goes to where the person was in [file], whose graphs are on the board, or else to its beginning. */
    fun enter(file: Path) {
        val place = known[file]
        topics.change { searching(place?.query.orEmpty()) }
        topics.list.requestScrollToItem(place?.topic ?: 0, place?.topicOffset ?: 0)
        val graph = board.state.graphs.indexOfFirst { drawn(it) == place?.graph }
        if (place != null && graph >= 0) graphs.requestScrollToItem(graph, place.graphOffset) else graphs.requestScrollToItem(0)
    }

    /** Forgets [file], which was closed, and leaves it. */
    fun close(file: Path) {
        known.remove(file)
        topics.change { searching("") }
    }

    private fun drawn(graph: BoardGraph) = graph.lines to graph.isXy

    private companion object {
        /** More than a person goes back to. */
        const val MOST = 100
    }
}
