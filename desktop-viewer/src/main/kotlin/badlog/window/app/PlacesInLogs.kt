package badlog.window.app

import androidx.compose.foundation.lazy.LazyListState
import badlog.viewer.choices.board.BoardGraph
import badlog.window.log.GraphBoard
import badlog.window.topics.TopicListing
import java.nio.file.Path

/**
 * A person's place in each log since the window was opened: the search for topics, and the scroll positions. Use it only on the window's
 * thread.
 *
 * @param graphs the scroll state of the graphs of [board].
 */
internal class PlacesInLogs(private val topics: TopicListing, private val board: GraphBoard, private val graphs: LazyListState) {
    /**
     * @property topic the number of the first visible row of the topics; [topicOffset] is its hidden height in pixels.
     * @property graph the first visible graph; graphs of a finding may be above it. [graphOffset] is its hidden height in pixels.
     */
    private class Place(
        val query: String,
        val topic: Int,
        val topicOffset: Int,
        val graph: Pair<List<String>, Boolean>?,
        val graphOffset: Int,
    )

    /** The places by log, in the order in which the logs were left. */
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
        if (known.size > MAX_PLACES) known.remove(known.keys.first())
    }

    /** Goes to the place where the person was in [file], or otherwise to its beginning. The graphs of [file] must be on the board. */
    fun enter(file: Path) {
        val place = known[file]
        topics.change { searching(place?.query.orEmpty()) }
        topics.list.requestScrollToItem(place?.topic ?: 0, place?.topicOffset ?: 0)
        val graph = board.state.graphs.indexOfFirst { drawn(it) == place?.graph }
        if (place != null && graph >= 0) graphs.requestScrollToItem(graph, place.graphOffset) else graphs.requestScrollToItem(0)
    }

    /** Forgets the place in [file], which was closed, and clears the search for topics. */
    fun close(file: Path) {
        known.remove(file)
        topics.change { searching("") }
    }

    private fun drawn(graph: BoardGraph) = graph.lines to graph.isXy
}

/** The maximum number of remembered places. A person returns to fewer logs. */
private const val MAX_PLACES = 100
