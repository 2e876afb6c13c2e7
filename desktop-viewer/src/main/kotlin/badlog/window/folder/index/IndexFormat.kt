package badlog.window.folder.index

import badlog.core.analysis.SeriesStatistics
import badlog.core.recording.Severity
import badlog.core.recording.TopicKind
import badlog.files.LogFile
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.nio.ByteBuffer
import java.nio.file.Path
import java.util.zip.CRC32

/**
 * The bytes of an index: [MAGIC], [VERSION], the CRC-32 of the rest; then every different text once; then the entries, which
 * refer to texts by index. Numbers are big-endian.
 */
internal object IndexFormat {
    private const val MAGIC = 0x62616478
    private const val HEAD = 12

    /** Increase it whenever the meaning of the bytes, or of what is stored about a file, changes. */
    const val VERSION = 5

    /** Returns the bytes of [entries], made with the names of signals identified by [names]. */
    fun encode(entries: Collection<LogEntry>, names: Int = 0): ByteArray {
        val bodyBytes = ByteArrayOutputStream(entries.sumOf { it.topics.size } * 220 + 1024)
        val texts = TextTable()
        val writer = EntryWriter(DataOutputStream(bodyBytes), texts)
        for (entry in entries) writer.write(entry)
        val tableBytes = ByteArrayOutputStream()
        DataOutputStream(tableBytes).let { out ->
            out.writeInt(texts.all.size)
            for (text in texts.all) {
                val bytes = text.encodeToByteArray()
                out.writeInt(bytes.size)
                out.write(bytes)
            }
            out.writeInt(entries.size)
        }
        val all = ByteBuffer.allocate(HEAD + tableBytes.size() + bodyBytes.size())
        all.putInt(MAGIC).putInt(VERSION + names).putInt(0).put(tableBytes.toByteArray()).put(bodyBytes.toByteArray())
        return all.putInt(HEAD - 4, checksum(all.array())).array()
    }

    /** Returns the entries of [bytes]; null if they are damaged, or not an index of this version and these [names]. */
    fun decode(bytes: ByteArray, names: Int = 0): List<LogEntry>? {
        if (bytes.size < HEAD) return null
        val buffer = ByteBuffer.wrap(bytes)
        if (buffer.getInt() != MAGIC || buffer.getInt() != VERSION + names || buffer.getInt() != checksum(bytes)) return null
        return try {
            decode(buffer)
        } catch (_: RuntimeException) {
            // A damaged index may contain any path, number of topics or kind: badlog did not write it.
            null
        }
    }

    private fun decode(buffer: ByteBuffer): List<LogEntry>? {
        val texts = Array(buffer.count(minBytes = 4)) {
            val bytes = ByteArray(buffer.count(minBytes = 1))
            buffer.get(bytes)
            bytes.decodeToString()
        }
        val reader = EntryReader(buffer, texts)
        val entries = List(buffer.count(minBytes = EntryReader.MIN_BYTES)) { reader.read() }
        return entries.takeIf { !buffer.hasRemaining() }
    }

    private fun checksum(bytes: ByteArray): Int = CRC32().apply { update(bytes, HEAD, bytes.size - HEAD) }.value.toInt()
}

/**
 * Reads the number of items that follow, each of at least [minBytes], so that a damaged number cannot request more memory than the file
 * has.
 */
internal fun ByteBuffer.count(minBytes: Int): Int {
    val count = getInt()
    require(count >= 0 && count.toLong() * minBytes <= remaining()) { "$count of something do not fit." }
    return count
}

/** Numbers texts in order of first appearance. */
internal class TextTable {
    private val places = LinkedHashMap<String, Int>()

    /** All of them. */
    val all: Collection<String> get() = places.keys

    /** Returns the index of [text]; -1 for null. */
    fun placeOf(text: String?): Int = if (text == null) -1 else places.getOrPut(text) { places.size }
}

/** Writes entries in the form that [EntryReader] reads. */
internal class EntryWriter(private val out: DataOutputStream, private val texts: TextTable) {
    /** Writes [entry]. */
    fun write(entry: LogEntry) = with(entry) {
        text(file.toString())
        out.writeLong(source.size)
        out.writeLong(source.modified)
        text(match.event)
        text(match.type)
        text(match.number)
        text(match.alliance)
        out.writeLong(date.second)
        out.writeByte(date.source.ordinal)
        out.writeDouble(duration ?: Double.NaN)
        text(xUnit)
        out.writeLong(samples)
        out.writeInt(problems.errors)
        out.writeInt(problems.warnings)
        out.writeInt(problems.notes)
        out.writeByte(content.ordinal)
        text(trouble)
        out.writeDouble(batteryMinimum ?: Double.NaN)
        text(batteryTopic)
        out.writeInt(topics.size)
        topics.forEach(::write)
        write(found)
    }

    private fun write(found: LogFound?) {
        out.writeByte(
            if (found == null) {
                NOT_SEARCHED
            } else if (found.rules == null) {
                NOT_SEARCHABLE
            } else {
                SEARCHED
            },
        )
        out.writeInt(found?.key ?: 0)
        out.writeInt(found?.rules?.size ?: 0)
        for (rule in found?.rules.orEmpty()) {
            text(rule.name)
            out.writeByte(rule.severity.ordinal)
        }
    }

    private fun write(topic: TopicSummary) = with(topic.statistics) {
        text(topic.name)
        text(topic.unit)
        out.writeByte(topic.kind.ordinal)
        out.writeInt(count)
        out.writeInt(gaps)
        out.writeDouble(min)
        out.writeDouble(max)
        out.writeDouble(mean)
        out.writeDouble(standardDeviation)
        out.writeDouble(percentile5)
        out.writeDouble(median)
        out.writeDouble(percentile95)
        out.writeDouble(first)
        out.writeDouble(last)
        out.writeDouble(integral)
        out.write(topic.preview.bytes)
    }

    private fun text(text: String?) = out.writeInt(texts.placeOf(text))
}

/** Reads entries written by [EntryWriter]; throws a [RuntimeException] if the bytes are not entries. */
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
        found = readFound(),
    )

    private fun readFound(): LogFound? {
        val state = buffer.get().toInt()
        val key = buffer.getInt()
        val rules = List(buffer.count(RULE_BYTES)) { FoundRule(text()!!, Severity.entries[buffer.get().toInt()]) }
        require(state in NOT_SEARCHED..SEARCHED) { "$state is not whether a log was searched." }
        return if (state == NOT_SEARCHED) null else LogFound(key, rules.takeIf { state == SEARCHED })
    }

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
        private const val RULE_BYTES = 4 + 1
        private const val TOPIC_BYTES = 4 + 4 + 1 + 2 * 4 + 10 * 8 + PreviewLine.BYTES

        /** No entry has fewer bytes. */
        const val MIN_BYTES = 4 + 2 * 8 + 4 * 4 + 8 + 1 + 8 + 4 + 8 + 3 * 4 + 1 + 4 + 8 + 4 + 4 + 1 + 4 + 4

        /** Seconds within years of four digits. */
        private val PLAUSIBLE = -62_000_000_000L..250_000_000_000L
    }
}

private const val NOT_SEARCHED = 0
private const val NOT_SEARCHABLE = 1
private const val SEARCHED = 2
