package badlog.cli.cut

import badlog.plot.Span
import badlog.recording.Recording

/**
 * The part of a log that is kept.
 *
 * @property recording what holds it.
 * @property rows which rows of [recording] it is; where that has no rows, it is all of it.
 * @property spans where on the x axis it lies.
 */
internal class CutPart(val recording: Recording, val rows: List<IntRange>, val spans: List<Span>) {
    /** How many rows it has. */
    val rowCount: Int get() = rows.sumOf { it.count() }

    /** How many samples it has. */
    val sampleCount: Long
        get() = if (recording.rowCount == 0) recording.sampleCount else rowCount.toLong() * recording.topics.size
}
