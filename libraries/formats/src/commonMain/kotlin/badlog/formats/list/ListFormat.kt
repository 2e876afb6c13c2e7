package badlog.formats.list

import badlog.core.recording.LogFormat
import badlog.core.recording.LogParser

/**
 * A list of samples, one in each line of a CSV file. A line has its time in s, the name of its topic, and its value. DataLogTool of WPILib
 * and AdvantageScope export such lists, which are recognized by the titles `Timestamp`, `Name` or `Key`, and `Value`.
 */
internal object ListFormat : LogFormat {
    override val id: String get() = "csv_list"

    override val title: String get() = "CSV list"

    override val endings: List<String> get() = listOf(".csv")

    override val signatureSize: Int get() = SIGNATURE_SIZE

    override fun matches(bytes: ByteArray, size: Int): Boolean = separatorIn(bytes, size) != null

    override fun parser(keepSamples: Boolean): LogParser = ListParser(keepSamples)

    /** Returns the byte between the titles of a list that begins with the first [size] of [bytes]. Null if it is not one. */
    fun separatorIn(bytes: ByteArray, size: Int): Int? {
        val text = bytes.decodeToString(0, minOf(size, SIGNATURE_SIZE)).removePrefix("\uFEFF")
        val end = text.indexOfFirst { it == '\n' || it == '\r' }
        if (end < 0) return null
        return SEPARATORS.find { separator ->
            val titles = text.take(end).split(separator).map { it.trim().removeSurrounding("\"").lowercase() }
            titles.size == NAMES.size && titles.indices.all { titles[it] in NAMES[it] }
        }?.code
    }

    private val NAMES = listOf(setOf("timestamp"), setOf("name", "key"), setOf("value"))
    private const val SEPARATORS = ",;\t"
    private const val SIGNATURE_SIZE = 64
}
