package badlog.viewer.state

import badlog.signals.logging.LoggingLibrary
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.shown.statistics.ChannelOrder

/**
 * The state of an open log: the person's graphs, the place in the log, and the open parts of panels. Immutable: [reduce] returns the next
 * one.
 *
 * @property place the person's place in the log.
 * @property board the graphs that the person put together, with their history.
 * @property findings the search in the findings.
 * @property statistics the choices for statistics.
 * @property across the choices for statistics across logs, which stay when another log is opened; null for none.
 * @property unfolded the parts of panels that a person has unfolded, or folded, by their keys.
 * @property added each graph added to show a finding, in its original form, except graphs that a person keeps: undoing also brings back
 *   the graphs of previous findings.
 * @property following whether the person stays at the end of the log.
 */
data class ViewerState(
    val place: Place,
    val board: BoardHistory,
    val findings: FindingsState = FindingsState(),
    val statistics: StatisticsState = StatisticsState(),
    val across: AcrossState? = null,
    val unfolded: Map<String, Boolean> = emptyMap(),
    val added: Set<BoardGraph> = emptySet(),
    val following: EndFollowing = EndFollowing(),
) {
    /** All graphs that the person arranged, also those that the open log cannot draw. */
    val arranged: Board get() = Board(board.now.graphs - added)

    private val ofEvidence: Set<Int> get() = board.now.graphs.filter { it in added }.mapTo(HashSet()) { it.id }

    /** Returns the [drawn] graphs that were put on top to show a finding, except graphs that the person has changed. */
    fun evidenceIn(drawn: Board): Board = ofEvidence.let { ids -> Board(drawn.graphs.filter { it.id in ids }) }

    /** Returns the other [drawn] graphs: those that the person arranged. */
    internal fun arrangedIn(drawn: Board): Board = ofEvidence.let { ids -> Board(drawn.graphs.filter { it.id !in ids }) }

    internal fun at(place: Place) = copy(place = place)
}

/**
 * A person's search in the findings of a log.
 *
 * @property query the text of the search; empty for none.
 * @property listed the number of listed findings beside the incidents; null for only the first few.
 * @property library the library of the lines shown for missing signals.
 * @property refusal the reason why a topic was not assigned to a signal, as a sentence; null if nothing was refused.
 */
data class FindingsState(
    val query: String = "",
    val listed: Int? = null,
    val library: LoggingLibrary = LoggingLibrary.WPILIB,
    val refusal: String? = null,
)

/**
 * A person's choices for the statistics of graphs.
 *
 * @property range their range.
 * @property order the order of the channels of the power distribution.
 */
data class StatisticsState(val range: StatisticsRange = StatisticsRange.SHOWN, val order: ChannelOrder = ChannelOrder.CHARGE)

/** The range of statistics. */
enum class StatisticsRange {
    /** The selection, otherwise the range between both cursors, otherwise the visible range. */
    SHOWN,

    /** The time in which the robot was enabled. */
    ENABLED,

    /** All of the log. */
    ALL,
}
