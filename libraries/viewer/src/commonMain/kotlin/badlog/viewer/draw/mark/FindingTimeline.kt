package badlog.viewer.draw.mark

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import kotlin.math.abs

/** A place of [finding] on the x axis, at [span]; a moment has no width. */
class FindingPlace<F>(val finding: F, val severity: Severity, val span: Span)

/**
 * The findings of a recording by their places on the x axis.
 *
 * @param severityOf returns the severity of a finding.
 * @param placesOf returns the places of a finding, the one to look at first before the others; empty if it is about the whole log.
 */
class FindingTimeline<F>(all: List<F>, private val severityOf: (F) -> Severity, placesOf: (F) -> List<Span>) {
    /** All places of all findings, in the order of x. */
    val places: List<FindingPlace<F>> =
        all.flatMap { finding -> placesOf(finding).map { FindingPlace(finding, severityOf(finding), it) } }.sortedBy { it.span.from }

    // For each place, the last end of it and all previous ones. A log may have ten thousand places, and each frame needs them.
    private val lastEnds = DoubleArray(places.size).also { ends ->
        for (i in ends.indices) ends[i] = if (i == 0) places[0].span.to else maxOf(ends[i - 1], places[i].span.to)
    }

    /**
     * All findings, the worst first, and within a severity in the order of x. Findings about the whole log come before the ones with a
     * place.
     */
    val worstFirst: List<F> = all.map { it to (placesOf(it).firstOrNull()?.from ?: Double.NEGATIVE_INFINITY) }
        .sortedWith(compareBy({ -severityOf(it.first).ordinal }, { it.second })).map { it.first }

    /** Returns the places of [finding], in the order of x. */
    private fun placesOf(finding: F): List<FindingPlace<F>> = places.filter { it.finding == finding }

    /**
     * Returns the place that begins at [x]; null if there is none. Of several, a finding for which [isPreferred] is true comes first, then
     * the worst finding.
     */
    fun placeAt(x: Double, isPreferred: (F) -> Boolean): FindingPlace<F>? =
        places.filter { it.span.from == x }.maxWithOrNull(compareBy({ isPreferred(it.finding) }, { it.severity }))

    /** Returns the index of the first place that begins after [x]. */
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
     * Returns the place of [finding] that is [steps] after the one that begins at [x]. If none begins there, the steps are counted from the
     * first place. They end at the first and last place. Null if the finding has no place.
     */
    fun within(finding: F, x: Double, steps: Int): FindingPlace<F>? {
        val own = placesOf(finding)
        return own.getOrNull((maxOf(0, own.indexOfFirst { it.span.from == x }) + steps).coerceIn(0, maxOf(0, own.size - 1)))
    }

    /** Returns the number of findings of [severity]. */
    fun count(severity: Severity): Int = worstFirst.count { severityOf(it) == severity }

    /** Returns the findings with a place at most [distance] from [x], or lasting over it, the worst first. */
    fun at(x: Double, distance: Double): List<F> {
        val found = HashSet<F>()
        var index = firstAfter(x + distance) - 1
        while (index >= 0 && lastEnds[index] >= x - distance) {
            val place = places[index--]
            if (place.span.to >= x - distance) found += place.finding
        }
        return if (found.isEmpty()) emptyList() else worstFirst.filter { it in found }
    }

    /**
     * Returns the finding that a pointer at [x] points at; null if there is none. It is the worst of the nearest ones with a mark, at the
     * start of a place in [visible], at most [reach] away. Otherwise it is the worst one that lasts over x, or ends at most half the
     * reach from it.
     */
    fun pointedAt(x: Double, reach: Double, visible: Span): F? {
        val nearest = places.filter { it.span.from in visible && abs(it.span.from - x) <= reach }
            .minWithOrNull(compareBy({ abs(it.span.from - x) }, { -it.severity.ordinal }))
        return if (nearest != null) nearest.finding else at(x, reach / 2).firstOrNull()
    }
}
