package badlog.samples.generated

import badlog.core.bag.RecordingParser
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.formats.LOG_FORMATS

/** Returns the recording of [match], read as badlog's programs read it. */
internal fun recordingOf(match: GeneratedMatch): Recording = RecordingParser(LOG_FORMATS, match.bytes.size.toLong()).run {
    accept(match.bytes, 0, match.bytes.size)
    finish()
}

/** Returns the times of the samples of [topic], in s. */
internal fun timesOf(recording: Recording, topic: Topic): DoubleArray = topic.times ?: recording.topics.first { "xaxis" in it.attributes }.samples

/** The samples of [topic], held in between, to compare a match with the same match without its fault. */
internal class HeldSamples(recording: Recording, topic: Topic) {
    private val times = timesOf(recording, topic)
    private val texts = topic.texts
    private val samples = topic.samples
    val size = times.size
    private var at = -1

    /**
     * Returns the number at [time], which must ascend from call to call; NaN before the first sample. Each text has a number of its own.
     */
    fun at(time: Double): Double {
        while (at + 1 < times.size && times[at + 1] <= time) at++
        if (at < 0) return Double.NaN
        if (samples.isNotEmpty() && !samples[at].isNaN()) return samples[at]
        return (0 until texts.size).lastOrNull { texts.rows[it] <= at }?.let { texts[it].hashCode().toDouble() } ?: Double.NaN
    }
}
