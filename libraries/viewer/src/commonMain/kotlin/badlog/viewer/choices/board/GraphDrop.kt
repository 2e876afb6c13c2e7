package badlog.viewer.choices.board

/**
 * Returns whether a graph that is dropped onto another one joins it, rather than being placed above or below. [share] is the height of
 * the drop within the other graph, from 0 at its top to 1.
 */
fun isDroppedInto(share: Double): Boolean = share in 0.2..0.8

/**
 * Returns this board after graph [id] was dropped onto graph [onto], at the [share] of its height from its top. They are joined, see
 * [isDroppedInto], or it is moved above or below. A graph dropped onto itself stays where it is.
 */
fun Board.dropped(id: Int, onto: Int, share: Double): Board = when {
    id == onto -> this
    isDroppedInto(share) -> joined(onto, id)
    share < 0.5 -> movedBefore(id, onto)
    else -> movedBefore(id, graphs.getOrNull(graphs.indexOfFirst { it.id == onto } + 1)?.id)
}
