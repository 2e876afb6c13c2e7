package badlog.plot.timeline

import badlog.analysis.Span
import badlog.recording.Severity
import kotlin.math.abs

/** A place on the x axis, [span], at which [finding] was found; a moment has no width. */
public class FindingPlace<F>(public val finding: F, public val severity: Severity, public val span: Span)

/**
 * The findings of a recording by their places on the x axis.
 *
 * @param severityOf how bad a finding is.
 * @param placesOf everywhere it was found, the place to look at first before the others; empty when it is about the whole log.
 */
public class FindingTimeline<F>(all: List<F>, private val severityOf: (F) -> Severity, placesOf: (F) -> List<Span>) {
    /** All places of all of them, in the order of x. */
    public val places: List<FindingPlace<F>> =
        all.flatMap { finding -> placesOf(finding).map { FindingPlace(finding, severityOf(finding), it) } }.sortedBy { it.span.from }

    // Up to each place the last end of it and those before: a log may have ten thousand places, and be asked for them in each frame.
    private val lastEnds = DoubleArray(places.size).also { ends ->
        for (i in ends.indices) ends[i] = if (i == 0) places[0].span.to else maxOf(ends[i - 1], places[i].span.to)
    }

    /** The worst first, and of one severity in the order of x; those about the whole log come before those with a place. */
    public val worstFirst: List<F> = all.map { it to (placesOf(it).firstOrNull()?.from ?: Double.NEGATIVE_INFINITY) }
        .sortedWith(compareBy({ -severityOf(it.first).ordinal }, { it.second })).map { it.first }

    /** The places of [finding], in the order of x. */
    public fun placesOf(finding: F): List<FindingPlace<F>> = places.filter { it.finding == finding }

    /** The place that begins at [x] of the finding that [isMeant], or else of the worst there; null for none. */
    public fun placeAt(x: Double, isMeant: (F) -> Boolean): FindingPlace<F>? =
        places.filter { it.span.from == x }.maxWithOrNull(compareBy({ isMeant(it.finding) }, { it.severity }))

    /** The index of the first place that begins after [x]. */
    private fun firstAfter(x: Double): Int {
        var low = 0
        var high = places.size
        while (low < high) {
            val middle = (low + high) / 2
            if (places[middle].span.from <= x) low = middle + 1 else high = middle
        }
        return low
    }

    /**
     * The place of [finding] that is [steps] further on than the one which begins at [x], or else than its first; beyond the ends its
     * last or its first. Null where it has no place.
     */
    public fun within(finding: F, x: Double, steps: Int): FindingPlace<F>? {
        val own = placesOf(finding)
        return own.getOrNull((maxOf(0, own.indexOfFirst { it.span.from == x }) + steps).coerceIn(0, maxOf(0, own.size - 1)))
    }

    /** How many are of [severity]. */
    public fun count(severity: Severity): Int = worstFirst.count { severityOf(it) == severity }

    /** Those with a place that is no further than [distance] from [x], or lasts over it, the worst first. */
    public fun at(x: Double, distance: Double): List<F> {
        val found = HashSet<F>()
        var index = firstAfter(x + distance) - 1
        while (index >= 0 && lastEnds[index] >= x - distance) {
            val place = places[index--]
            if (place.span.to >= x - distance) found += place.finding
        }
        return if (found.isEmpty()) emptyList() else worstFirst.filter { it in found }
    }

    /**
     * The one whose mark, where a place in [visible] begins, is no further than [reach] from [x]: of the nearest the worst. Else the
     * worst of those that last over x, or end no further than half the reach from it; null for none.
     */
    public fun pointedAt(x: Double, reach: Double, visible: Span): F? {
        val nearest = places.filter { it.span.from in visible && abs(it.span.from - x) <= reach }
            .minWithOrNull(compareBy({ abs(it.span.from - x) }, { -it.severity.ordinal }))
        return if (nearest != null) nearest.finding else at(x, reach / 2).firstOrNull()
    }

    /**
     * The place [steps] after that of [current] which begins at [x], where the cursor still is; else the first after x, or with a
     * negative number the last before it. Beyond the ends the last or the first; null without any. An x that is NaN is not a place.
     */
    public fun beside(current: F?, x: Double, steps: Int): FindingPlace<F>? {
        val index = places.indexOfFirst { it.finding == current && it.span.from == x }
        val next = when {
            index >= 0 -> index + steps
            steps > 0 -> steps - 1 + if (x.isNaN()) 0 else places.count { it.span.from <= x }
            else -> steps + if (x.isNaN()) places.size else places.count { it.span.from < x }
        }
        return places.getOrNull(next.coerceIn(0, maxOf(0, places.size - 1)))
    }
}
