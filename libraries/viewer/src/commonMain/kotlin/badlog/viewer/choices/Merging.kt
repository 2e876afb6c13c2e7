package badlog.viewer.choices

/**
 * Returns this list merged with the changes that others made to the [stored] list since this one [read] it. Several tabs or windows change
 * such a list, and remember it in one place. An element that is unchanged here is taken from [stored]; a change, addition or removal that
 * was made only here stays. If both sides changed an element, the change here counts as the later one. Without changes by others, this list
 * stays the same.
 *
 * @param key returns the identity of an element.
 * @param join returns the merged element from its versions in all three lists, or in this one and the stored one.
 */
fun <T : Any> List<T>.mergedWith(stored: List<T>, read: List<T>, key: (T) -> Any = { it }, join: (T, T?, T) -> T = ::merged): List<T> {
    val mine = associateBy(key)
    val before = read.associateBy(key)
    val theirs = stored.associateBy(key)

    fun mergedAt(place: Any): T? {
        val here = mine[place]
        val was = before[place]
        val there = theirs[place]
        return when {
            here == null -> there.takeIf { was == null }
            there == null -> here.takeIf { here != was }
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

/** Returns the value that only one side has changed since [before]; if both did, [mine]. */
internal fun <T> merged(mine: T, before: T?, theirs: T): T = if (mine == before) theirs else mine
