package badlog.cli.convert

import badlog.analysis.periodicTimes
import badlog.analysis.timesOf
import badlog.cli.Failure
import badlog.recording.Recording
import badlog.report.topicCalled
import java.nio.file.Path

/**
 * At which times a log without rows gets them.
 *
 * @param period how far apart, in seconds; null for [USUAL_PERIOD].
 * @param topic the topic at whose times they are instead, or null.
 */
internal class Rows(private val period: Double?, private val topic: String?) {
    /**
     * The times for [recording], which was read from [file].
     *
     * @throws badlog.report.TopicException when it has no such topic.
     * @throws Failure when there would be too many.
     */
    fun timesIn(recording: Recording, file: Path): DoubleArray {
        if (topic != null) return timesOf(recording, recording.topicCalled(topic, file) { "to make rows at" })
        return try {
            periodicTimes(recording, period ?: USUAL_PERIOD)
        } catch (e: IllegalArgumentException) {
            throw Failure("$file: ${e.message} Choose a longer --period.")
        }
    }

    companion object {
        /** A robot's loop. */
        const val USUAL_PERIOD = 0.02
    }
}
