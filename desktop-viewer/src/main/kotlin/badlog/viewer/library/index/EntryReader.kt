package badlog.viewer.library.index

import badlog.analysis.SeriesStatistics
import badlog.file.LogFile
import badlog.recording.TopicKind
import java.nio.ByteBuffer
import java.nio.file.Path

/** Reads entries as [EntryWriter] wrote them; throws some [RuntimeException] when the bytes are no entries. */
internal class EntryReader(private val buffer: ByteBuffer, private val texts: Array<String>) {
    /** Reads the next entry. */
    fun read() = LogEntry(
        source = LogFile(Path.of(text()!!), buffer.getLong(), buffer.getLong()),
        match = MatchFacts(text(), text(), text(), text()),
        date = LogDate(buffer.getLong().also { require(it in PLAUSIBLE) }, DateSource.entries[buffer.get().toInt()]),
        duration = number(),
        xUnit = text()!!,
        samples = buffer.getLong(),
        problems = ProblemCounts(buffer.getInt(), buffer.getInt(), buffer.getInt()),
        content = Content.entries[buffer.get().toInt()],
        trouble = text(),
        batteryMinimum = number(),
        batteryTopic = text(),
        topics = List(buffer.count(TOPIC_BYTES)) { readTopic() },
    )

    private fun readTopic() = TopicSummary(
        name = text()!!,
        unit = text()!!,
        kind = TopicKind.entries[buffer.get().toInt()],
        statistics = SeriesStatistics(
            count = buffer.getInt(),
            gaps = buffer.getInt(),
            min = buffer.getDouble(),
            max = buffer.getDouble(),
            mean = buffer.getDouble(),
            standardDeviation = buffer.getDouble(),
            percentile5 = buffer.getDouble(),
            median = buffer.getDouble(),
            percentile95 = buffer.getDouble(),
            first = buffer.getDouble(),
            last = buffer.getDouble(),
            integral = buffer.getDouble(),
        ),
        preview = PreviewLine(ByteArray(PreviewLine.BYTES).also { buffer.get(it) }),
    )

    private fun number(): Double? = buffer.getDouble().takeIf { !it.isNaN() }

    private fun text(): String? = buffer.getInt().let { if (it == -1) null else texts[it] }

    companion object {
        private const val TOPIC_BYTES = 4 + 4 + 1 + 2 * 4 + 10 * 8 + PreviewLine.BYTES

        /** No entry has fewer bytes. */
        const val LEAST_BYTES = 4 + 2 * 8 + 4 * 4 + 8 + 1 + 8 + 4 + 8 + 3 * 4 + 1 + 4 + 8 + 4 + 4

        /** Seconds that are of a year with four digits. */
        private val PLAUSIBLE = -62_000_000_000L..250_000_000_000L
    }
}
