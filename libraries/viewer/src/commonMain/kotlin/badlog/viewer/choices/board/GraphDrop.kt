package badlog.viewer.choices.board

/**
 * Returns whether a graph dropped at the [share] of another one's height, from its top, is joined with that one, rather than placed above
 * or below it.
 */
fun isDroppedInto(share: Double): Boolean = share in 0.2..0.8

/**
 * Returns this board after graph [id] was dropped at the [share] of the height of graph [onto], from its top: joined with that one, see
 * [isDroppedInto], or moved above or below it. Dropped on itself, it stays where it is.
 */
fun Board.dropped(id: Int, onto: Int, share: Double): Board = when {
    id == onto -> this
    isDroppedInto(share) -> joined(onto, id)
    share < 0.5 -> movedBefore(id, onto)
    else -> movedBefore(id, graphs.getOrNull(graphs.indexOfFirst { it.id == onto } + 1)?.id)
}
