package badlog.signals.clock

/**
 * The place of a log on a clock that it shares with other logs.
 *
 * @property seconds the offset to add to its times, in s.
 * @property fit the fit that gave the offset; its error includes the errors of the logs in between. Null if the offset was given.
 * @property beside the index of the log that it was fitted to; null if the offset was given.
 */
class ClockPlace(val seconds: Double, val fit: ClockFit? = null, val beside: Int? = null)

/**
 * Returns the place of each of [count] logs on one clock; null for a log if nothing shows its place.
 *
 * A log need not fit the first: it may fit any that has a place, and the surest fit is used next. The order of the logs decides only
 * between fits that are equally sure.
 *
 * @param given the offsets that are known, in s, by the index of the log; at least one.
 * @param fitOf returns the relation of the clock of the log with the first index to the clock of the second; null if nothing shows it.
 */
fun onOneClock(count: Int, given: Map<Int, Double>, fitOf: (own: Int, other: Int) -> ClockFit?): List<ClockPlace?> {
    val places = arrayOfNulls<ClockPlace>(count)
    val links = ArrayList<Link>()
    fun place(index: Int, place: ClockPlace) {
        places[index] = place
        links.removeAll { it.own == index }
        for (own in 0 until count) if (places[own] == null && own !in given) fitOf(own, index)?.let { links += Link(own, index, it) }
    }
    for ((index, seconds) in given) place(index, ClockPlace(seconds))
    while (true) {
        val (own, other, fit) = links.minWithOrNull(SUREST) ?: return places.asList()
        val before = checkNotNull(places[other])
        val error = fit.error + (before.fit?.error ?: 0.0)
        place(own, ClockPlace(before.seconds + fit.seconds, ClockFit(before.seconds + fit.seconds, fit.edges, error), other))
    }
}

/** How the clock of the log with the index [own] relates to the clock of [other], which has a place. */
private data class Link(val own: Int, val other: Int, val fit: ClockFit)

private val SUREST = compareBy<Link>({ -it.fit.edges }, { it.fit.error }, { it.own }, { it.other })
