package badlog.cli.convert

import badlog.cli.input.Failure
import badlog.cli.output.Omissions
import badlog.cli.text.counted
import badlog.core.analysis.periodicTimes
import badlog.core.analysis.samplesBetween
import badlog.core.analysis.timesOf
import badlog.core.recording.Recording
import badlog.formats.wpilog.isOfBytes
import badlog.report.topicCalled
import java.nio.file.Path

/**
 * The times of rows for a log without rows.
 *
 * @param period the time between rows, in seconds; null for [DEFAULT_PERIOD].
 * @property topic a topic with times to use instead; null for none.
 */
internal class Rows(private val period: Double?, val topic: String?) {
    /**
     * Returns the times for [recording], which was read from [file].
     *
     * @throws badlog.report.TopicException if it has no such topic.
     * @throws Failure if there would be too many.
     */
    fun timesIn(recording: Recording, file: Path): DoubleArray {
        if (topic != null) return timesOf(recording, recording.topicCalled(topic, file) { "for --rows-at" })
        return try {
            periodicTimes(recording, period ?: DEFAULT_PERIOD)
        } catch (e: IllegalArgumentException) {
            throw Failure("$file: ${e.message} Choose a longer --period.")
        }
    }

    companion object {
        /** The period of a robot's loop, in seconds. */
        const val DEFAULT_PERIOD = 0.02
    }
}

/** Returns the content of [recording], in which topics have their own times, that rows at [times] cannot hold. */
internal fun rowOmissions(recording: Recording, times: DoubleArray): Omissions {
    val between = recording.topics.sumOf { samplesBetween(it, times) }
    val topics = recording.topics
    return Omissions(
        listOfNotNull(
            Omissions.thing(topics.count { it.type.isNotEmpty() }, "type"),
            topicsText("the metadata", topics.count { it.metadata.isNotEmpty() }),
            topicsText("the bytes", topics.count { it.isOfBytes }),
        ),
        remarks = listOfNotNull(betweenText(between)),
        hasLoss = between > 0,
    )
}

private fun betweenText(count: Long): String? = when (count) {
    0L -> null
    1L -> "1 sample lies between two rows and is left out (--rows-at, --period)"
    else -> counted(count, "sample") + " lie between two rows and are left out (--rows-at, --period)"
}

private fun topicsText(what: String, count: Int): String? = if (count == 0) null else "$what of ${counted(count.toLong(), "topic")}"
