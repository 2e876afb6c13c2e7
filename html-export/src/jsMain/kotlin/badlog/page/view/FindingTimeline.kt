package badlog.page.view

import badlog.analysis.Span
import badlog.plot.text.countText
import badlog.recording.Severity
import badlog.rules.Finding

/** One of the places on the x axis at which [finding] was found. */
internal class FindingPlace(val finding: Finding, val span: Span)

/** The findings of a recording by their places on the x axis. */
internal class FindingTimeline(all: List<Finding>) {
    /** The worst first, and of one severity in the order of x; those about the whole come before those with a place. */
    val worstFirst: List<Finding> =
        all.sortedWith(compareBy<Finding> { -it.severity.ordinal }.thenBy { if (it.isPlaced) it.time else Double.NEGATIVE_INFINITY })

    /** All places of all of them, in the order of x. */
    val places: List<FindingPlace> = all.flatMap { finding -> finding.places.map { FindingPlace(finding, it) } }.sortedBy { it.span.from }

    /** How many are of [severity]. */
    fun count(severity: Severity): Int = worstFirst.count { it.severity == severity }

    /** Those that are no further than [distance] from [x], or last over it, the worst first. */
    fun at(x: Double, distance: Double): List<Finding> =
        worstFirst.filter { finding -> finding.places.any { x >= it.from - distance && x <= it.to + distance } }

    /**
     * The place [steps] after [current] while the cursor at [x] still is at that, else the first after x; before them when [steps]
     * is negative. Null beyond the last one.
     */
    fun beside(current: FindingPlace?, x: Double, steps: Int): FindingPlace? {
        val index = if (current?.span?.from == x) places.indexOf(current) else -1
        return when {
            index >= 0 -> places.getOrNull(index + steps)
            steps > 0 -> if (x.isNaN()) places.firstOrNull() else places.firstOrNull { it.span.from > x }
            else -> if (x.isNaN()) places.lastOrNull() else places.lastOrNull { it.span.from < x }
        }
    }

    /** The first place of [finding]. */
    fun placeOf(finding: Finding): FindingPlace = places.first { it.finding == finding && it.span == finding.places[0] }
}

/** Whether it has a place on the x axis. */
internal val Finding.isPlaced: Boolean get() = time.isFinite()

/** Everywhere it was found, the first place first; none when it is about the whole. */
internal val Finding.places: List<Span>
    get() = if (isPlaced) spans.ifEmpty { listOf(Span(time, time)) } else emptyList()

/** Where it ends first, or stands. */
internal val Finding.end: Double get() = maxOf(time, spans.firstOrNull()?.to ?: time)

/** Its severity as a word, which is also the name of its style. */
internal val Finding.word: String get() = severity.name.lowercase()

/** The first of [findings] with its severity, and how many more there are. */
internal fun findingText(findings: List<Finding>): String {
    val first = findings.firstOrNull() ?: return ""
    return "${first.word} · ${shortFindingText(findings)}"
}

/** The same without the severity. */
internal fun shortFindingText(findings: List<Finding>): String {
    val others = if (findings.size > 1) " (and ${countText(findings.size - 1)} more)" else ""
    return "${findings[0].rule}: ${findings[0].text}$others"
}
