package badlog.viewer.choices.board

import badlog.core.analysis.LogView
import badlog.signals.pose.Pose
import badlog.signals.pose.PoseRole
import badlog.signals.pose.posesOf
import badlog.viewer.shown.outline.everChanges
import badlog.viewer.shown.search.Query

/** Returns the paths of [view] in one graph: driven, planned and seen ones, a few of each. Without a driven path, the board is empty. */
fun pathBoard(view: LogView): Board {
    val changing = view.recording.topics.filter(::everChanges).mapTo(HashSet()) { it.name }
    val poses = posesOf(view.recording.topics).filter { it.x in changing || it.y in changing }
    fun of(role: PoseRole, most: Int) = poses.filter { it.role == role }.distinctBy { it.list ?: it.name }.sortedBy { it.depth }.take(most)
    val driven = of(PoseRole.DRIVEN, MAX_DRIVEN)
    if (driven.isEmpty()) return Board()
    val shown = driven + of(PoseRole.PLANNED, MAX_PLANNED) + of(PoseRole.SEEN, MAX_SEEN)
    return Board().withGraphs(
        listOf(BoardGraph(0, "Path", shown.flatMap { listOf(it.x, it.y) }.distinct(), isXy = true)),
    )
}

/**
 * Returns the graphs of paths that a search for [query] offers beside the topics; none without a query. There is one for each of [poses],
 * or for all elements of an array of poses; it is found by its name and by the word “path”.
 */
fun pathGraphs(poses: List<Pose>, query: Query): List<BoardGraph> {
    if (query.isEmpty) return emptyList()
    return poses.groupBy { it.list ?: it.name }
        .map { (name, places) -> BoardGraph(0, "Path of $name", places.flatMap { listOf(it.x, it.y) }.distinct(), isXy = true) }
        .filter { query.matches(it.title) }.take(MAX_OFFERED)
}

private const val MAX_OFFERED = 20
private const val MAX_DRIVEN = 2
private const val MAX_PLANNED = 2
private const val MAX_SEEN = 3
