package badlog.page.view

import badlog.analysis.Span
import badlog.plot.text.countText
import badlog.recording.Severity

/**
 * Something that was found in the recording.
 *
 * @property source the rule or the hook that found it.
 * @property time where, NaN when it is about the whole.
 * @property until where it ends, NaN when it is a moment or about the whole.
 * @param further where else it was found.
 */
internal class Finding(
    val source: String,
    val severity: Severity,
    val text: String,
    val time: Double,
    val until: Double,
    further: List<Span> = emptyList(),
) {
    /** Whether it has a place on the x axis. */
    val isPlaced: Boolean get() = time.isFinite()

    /** Where it ends, or stands. */
    val end: Double get() = if (until > time) until else time

    /** Everywhere it was found, the first place first; none when it is about the whole. */
    val places: List<FindingPlace> = if (isPlaced) (listOf(Span(time, end)) + further).map { FindingPlace(this, it) } else emptyList()

    /** Its severity as a word, which is also the name of its style. */
    val word: String get() = severity.name.lowercase()
}

/** The first of [findings] with its severity, and how many more there are. */
internal fun findingText(findings: List<Finding>): String {
    val first = findings.firstOrNull() ?: return ""
    return "${first.word} · ${shortFindingText(findings)}"
}

/** The same without the severity. */
internal fun shortFindingText(findings: List<Finding>): String {
    val others = if (findings.size > 1) " (and ${countText(findings.size - 1)} more)" else ""
    return "${findings[0].source}: ${findings[0].text}$others"
}
