package badlog.wpilog

import badlog.bag.JsonMember
import badlog.bag.JsonReader
import badlog.recording.Topic

/**
 * What a file says of one name and type, under however many numbers it was begun.
 *
 * @property name as it stands in the file.
 * @property type as it stands in the file.
 * @property isValue whether it is no topic, but a value that badlog has written.
 */
internal class Entry(val name: String, val type: String, val isValue: Boolean, val decoder: PayloadDecoder) {
    /** What the file said of it last. */
    var metadata = ""

    /** Takes each payload too, where it tells something of the whole recording. */
    var listener: EntryListener? = null

    private val members: List<JsonMember> get() = JsonReader.readObject(metadata).orEmpty()

    /** Where loggers put a unit: beside their own remarks, or in the properties of a NetworkTables topic. */
    val unit: String
        get() {
            if (decoder.isUndecoded) return "B"
            val own = members.findLast { it.key == UNIT }
            val property = members.findLast { it.key == "properties" }?.value?.members?.findLast { it.key == UNIT }
            return (own ?: property)?.value?.text ?: Topic.UNITLESS
        }

    /** Those that badlog itself has written, and those that belong to what WPILib writes by itself. */
    val attributes: List<String>
        get() {
            val own = members.findLast { it.key == "attrs" }?.value?.items.orEmpty().mapNotNull { it.text }
            return when {
                own.isNotEmpty() -> own
                name == MESSAGES -> listOf("log")
                name == SYSTEM_TIME || SCHEMA_FOLDER in name -> listOf("hide")
                else -> own
            }
        }

    companion object {
        /** The entry in which WPILib's loggers tell the time of day. */
        const val SYSTEM_TIME = "systemTime"

        /** The folder of everything that describes types; also below `NT:`. */
        const val SCHEMA_FOLDER = "/.schema/"

        /** Where WPILib's logger puts what the program says. */
        private const val MESSAGES = "messages"
        private const val UNIT = "unit"
    }
}

/** Hears the payloads of an entry. */
internal fun interface EntryListener {
    /** The payload from [from] until [until] of a record at [micros]. */
    fun heard(micros: Double, bytes: ByteArray, from: Int, until: Int)
}
