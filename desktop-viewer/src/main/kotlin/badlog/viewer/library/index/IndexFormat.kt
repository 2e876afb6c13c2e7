package badlog.viewer.library.index

import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.nio.ByteBuffer
import java.util.zip.CRC32

/**
 * The bytes of an index: [MAGIC], [VERSION], the CRC-32 of the rest; then every different text once; then the entries, which
 * speak of texts by their place. Numbers are big-endian.
 */
internal object IndexFormat {
    private const val MAGIC = 0x62616478
    private const val HEAD = 12

    /** To be raised whenever the bytes, or what is found out about a file, change their meaning. */
    const val VERSION = 2

    /** The bytes of [entries]. */
    fun encode(entries: Collection<LogEntry>): ByteArray {
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
        all.putInt(MAGIC).putInt(VERSION).putInt(0).put(tableBytes.toByteArray()).put(bodyBytes.toByteArray())
        return all.putInt(HEAD - 4, checksum(all.array())).array()
    }

    /** The entries of [bytes]; null when they are not an index of this version, or damaged. */
    fun decode(bytes: ByteArray): List<LogEntry>? {
        if (bytes.size < HEAD) return null
        val buffer = ByteBuffer.wrap(bytes)
        if (buffer.getInt() != MAGIC || buffer.getInt() != VERSION || buffer.getInt() != checksum(bytes)) return null
        return try {
            decode(buffer)
        } catch (_: RuntimeException) {
            // Whatever a damaged index makes of a path, a number of topics or a kind: it is none that we wrote.
            null
        }
    }

    private fun decode(buffer: ByteBuffer): List<LogEntry>? {
        val texts = Array(buffer.count(leastBytes = 4)) {
            val bytes = ByteArray(buffer.count(leastBytes = 1))
            buffer.get(bytes)
            bytes.decodeToString()
        }
        val reader = EntryReader(buffer, texts)
        val entries = List(buffer.count(leastBytes = EntryReader.LEAST_BYTES)) { reader.read() }
        return entries.takeIf { !buffer.hasRemaining() }
    }

    private fun checksum(bytes: ByteArray): Int = CRC32().apply { update(bytes, HEAD, bytes.size - HEAD) }.value.toInt()
}

/** Reads how many of something follow, each of [leastBytes] or more; so no damaged number asks for more memory than the file. */
internal fun ByteBuffer.count(leastBytes: Int): Int {
    val count = getInt()
    require(count >= 0 && count.toLong() * leastBytes <= remaining()) { "$count of something do not fit." }
    return count
}

/** Numbers texts in the order in which they are met. */
internal class TextTable {
    private val places = LinkedHashMap<String, Int>()

    /** All of them. */
    val all: Collection<String> get() = places.keys

    /** The place of [text]; -1 for null. */
    fun placeOf(text: String?): Int = if (text == null) -1 else places.getOrPut(text) { places.size }
}
