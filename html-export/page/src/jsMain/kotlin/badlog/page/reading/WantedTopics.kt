package badlog.page.reading

import badlog.core.bag.BagParser
import badlog.core.bag.RecordingParser
import badlog.core.recording.LogFormat
import badlog.core.recording.LogParser
import badlog.core.recording.NumberSink
import badlog.core.recording.NumberSinks
import badlog.core.recording.Recording
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.WpilogFormat
import badlog.formats.wpilog.WpilogParser
import org.w3c.files.Blob

/** The topics [names] to read from a log that is too large to be read whole. */
internal class WantedTopics(val names: Set<String>) {
    /** Returns a parser for a log of [bytes] that keeps only the samples of these topics. */
    fun parser(bytes: Long): RecordingParser {
        val sinks = NumberSinks { name, _ -> if (name in names) null else NumberSink.NONE }
        return RecordingParser(LOG_FORMATS.map { if (it === WpilogFormat) wpilog else it }, keepSamples = true) {
            BagParser(bytes, keepSamples = true, sinks)
        }
    }

    /** Returns [read] with only these topics. */
    fun of(read: Recording): Recording = read.copy(topics = read.topics.filter { it.name in names })

    private val wpilog = object : LogFormat by WpilogFormat {
        override fun parser(keepSamples: Boolean): LogParser = WpilogParser(keepSamples) { entry ->
            // An entry of a struct or an array has several topics.
            names.any { it.startsWith(entry) && (it.length == entry.length || it[entry.length] in "/[") }
        }
    }
}

/**
 * A recording that was read.
 *
 * @property isDamaged whether the page was changed since it was exported, so that anything in [recording] may be wrong.
 * @property made the log of a match, made of several logs, as a WPILOG; null for a log that was read as it is.
 */
internal class ReadLog(val recording: Recording, val isDamaged: Boolean, val made: Blob? = null)
