package badlog.formats.wpilog

import badlog.core.analysis.LogView
import badlog.core.bag.readHeader
import badlog.core.recording.Recording
import badlog.core.recording.Topic

/**
 * Writes a recording of any format as a WPILOG. Each topic is an entry, with unit and attributes in its metadata; each sample is a record
 * at its time; each value is a separate entry. [WpilogParser] reads all of that back.
 *
 * Parts of arrays, structs and messages are separate entries with the names that they have as topics.
 *
 * @param recording the recording to write; it must have been read with its samples.
 * @param changesOnly true to skip a sample that equals the previous one of its topic.
 */
public class WpilogWriter(private val recording: Recording, private val changesOnly: Boolean = false) {
    /**
     * Writes the whole recording, in the order of time.
     *
     * @param progress called after each piece with the number of samples done so far, and the total. An exception from it stops the writing
     *   and is passed on.
     * @param sink receives the file in pieces of about 64 KiB, each `[0, size)` of the array, which is reused after the call. An exception from it
     *   stops the writing and is passed on.
     * @return the content that the file cannot express.
     * @throws IllegalArgumentException if the recording was read without its samples.
     */
    public fun write(
        progress: (doneSamples: Long, totalSamples: Long) -> Unit = { _, _ -> },
        sink: (bytes: ByteArray, size: Int) -> Unit,
    ): List<Omission> {
        requireSamples()
        val times = RecordTimes(LogView.of(recording).xAxis)
        val out = RecordBuffer()
        out.header(WpilogParser.OWN_HEADER)
        val firstTime = times.first
        var id = 1
        for (value in recording.values) {
            out.start(id, value.name, "string", VALUE_METADATA)
            out.string(id++, firstTime, value.text.encodeToByteArray())
        }
        val entries = recording.topics.map { EntryWriter(id++, it, times, changesOnly).apply { start(out) } }
        val total = recording.sampleCount
        var done = 0L
        val queue = EntryQueue(entries)
        while (true) {
            val entry = queue.first ?: break
            entry.writeNext(out)
            queue.moveFirst()
            done++
            if (out.size >= PIECE) {
                sink(out.bytes, out.size)
                out.clear()
                progress(done, total)
            }
        }
        if (out.size > 0) sink(out.bytes, out.size)
        progress(total, total)
        return omissions(entries, times)
    }

    private fun omissions(entries: List<EntryWriter>, times: RecordTimes): List<Omission> = buildList {
        addAll(times.omissions())
        val repeats = entries.sumOf { it.repeats }
        if (repeats > 0) add(Omission(null, "Samples that repeat the previous one have no record.", repeats))
        val parts = recording.topics.count {
            it.type.endsWith("[]") || it.type.startsWith("struct:") ||
                (it.type.startsWith("proto:") && !it.isOfBytes)
        }
        if (parts > 0) add(Omission(null, "Parts of arrays, structs and messages are separate entries.", parts))
        for (topic in recording.topics) {
            if (topic.isOfBytes) {
                add(Omission(topic.name, "Only the size of undecoded bytes is kept.", topic.size))
            }
        }
        val unknown = recording.headerLine?.let(::readHeader)?.unknown.orEmpty()
        if (unknown.isNotEmpty()) add(Omission(null, "Other keys of the header: ${unknown.keys.joinToString()}.", unknown.size))
        for (entry in entries) addAll(entry.omissions())
    }

    private fun requireSamples() {
        for (topic in recording.topics) {
            val counts = topic.counts
            val isMissing = topic.samples.isEmpty() && counts.texts + counts.empty < counts.total
            require(!isMissing && topic.texts.size == counts.texts) { "The samples of “${topic.name}” were not kept." }
        }
    }
}

/**
 * Content of a recording that a file of another format cannot express.
 *
 * @property topic the topic it belongs to, or null if it belongs to none or to many.
 * @property what one sentence that names the missing content, or its replacement.
 * @property count the number of samples, topics or texts it concerns.
 */
public data class Omission(public val topic: String?, public val what: String, public val count: Int = 1)

/** Whether the topic only has the sizes of records that could not be decoded. */
public val Topic.isOfBytes: Boolean get() = unit == BYTE && (type == "raw" || type.startsWith("proto:"))

/** The unit of a topic that only has the sizes of its records. */
internal const val BYTE: String = "B"

private const val PIECE = 1 shl 16
