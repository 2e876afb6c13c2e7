package badlog.viewer.choices

/**
 * Returns this list merged with the changes that others made to the [stored] list since this one [read] it. Several tabs or windows
 * change such a list, and remember it in one place. An element that this one has not changed is as [stored]; one that only this one has
 * changed, added or removed stays so. Of two changes of one element, the later write counts, which is this one's. Without changes of
 * others, the list is the same.
 *
 * @param prefersStored whether an element that both changed is as [stored], so that a step back undoes nothing of others.
 * @param key returns the identity of an element.
 * @param join returns an element of all three lists, or of this one and the stored one, as merged.
 */
fun <T : Any> List<T>.mergedWith(
    stored: List<T>,
    read: List<T>,
    prefersStored: Boolean = false,
    key: (T) -> Any = { it },
    join: (T, T?, T) -> T = { mine, before, theirs -> merged(mine, before, theirs, prefersStored) },
): List<T> {
    val mine = associateBy(key)
    val before = read.associateBy(key)
    val theirs = stored.associateBy(key)

    fun mergedAt(place: Any): T? {
        val here = mine[place]
        val was = before[place]
        val there = theirs[place]
        return when {
            here == null -> there.takeIf { was == null || (prefersStored && there != was) }
            there == null -> here.takeIf { was == null || (!prefersStored && here != was) }
            else -> join(here, was, there)
        }
    }

    // Each new element is placed after the one that it followed where it was added.
    val isMoved = mine.keys.filter { it in before } != before.keys.filter { it in mine }
    val (first, second) = if (isMoved) mine to theirs else theirs to mine
    val places = ArrayList(first.keys)
    var next = 0
    for (place in second.keys) {
        val at = places.indexOf(place)
        if (at < 0) places.add(next++, place) else next = at + 1
    }
    return places.mapNotNull(::mergedAt)
}

/** Returns the value that only one side has changed since [before]; if both did, [theirs] if [prefersTheirs], otherwise [mine]. */
internal fun <T> merged(mine: T, before: T?, theirs: T, prefersTheirs: Boolean): T =
    if (mine == before || (prefersTheirs && theirs != before)) theirs else mine
