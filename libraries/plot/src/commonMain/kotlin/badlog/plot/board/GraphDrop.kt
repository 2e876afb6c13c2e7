package badlog.plot.board

/** Whether a graph that is let go at the [share] of another one's height, from its top, is drawn in that, rather than above or below it. */
public fun isDroppedInto(share: Double): Boolean = share in 0.2..0.8

/**
 * This board after graph [id] was let go at the [share] of the height of graph [onto], from its top: drawn in that, see [isDroppedInto], or
 * moved above or below it. Over itself it stays where it is.
 */
public fun Board.dropped(id: Int, onto: Int, share: Double): Board = when {
    id == onto -> this
    isDroppedInto(share) -> joined(onto, id)
    share < 0.5 -> movedBefore(id, onto)
    else -> movedBefore(id, graphs.getOrNull(graphs.indexOfFirst { it.id == onto } + 1)?.id)
}
