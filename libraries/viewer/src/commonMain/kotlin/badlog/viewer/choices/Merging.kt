package badlog.viewer.choices

/**
 * Returns this list, which several tabs or windows change and remember in one place, with what the others have changed meanwhile: an
 * element that this one has not changed since it last [read] the list is as it is [stored] now, and one that only this one has changed,
 * added or removed stays so. Where both changed the same one, the later write counts, which is this one's. Without changes of others, it is
 * the same list.
 *
 * @param prefersStored whether that which both changed is as it is stored, so that a step back takes back nothing of others.
 * @param key returns what makes an element the same as another.
 * @param join returns an element that is in all three lists, or in this one and the stored one, as merged.
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

    // Each new element follows the one that it followed where it was added.
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

/** Returns what only one side has changed since [before]; of what both changed, [theirs] if [prefersTheirs], otherwise [mine]. */
internal fun <T> merged(mine: T, before: T?, theirs: T, prefersTheirs: Boolean): T =
    if (mine == before || (prefersTheirs && theirs != before)) theirs else mine
