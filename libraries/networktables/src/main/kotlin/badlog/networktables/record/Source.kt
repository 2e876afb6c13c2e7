package badlog.networktables.record

import badlog.networktables.TopicType
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject

/**
 * What is known of one server. Used on the recorder's thread only, except for [server].
 *
 * @property isRobot whether its clock is that of the log.
 */
internal class Source(val server: RecordedServer, val isRobot: Boolean) {
    val sync = TimeSync()

    /** The current connection, or null. */
    var link: Link? = null

    /** Whether it has answered and sends values. */
    var isSubscribed = false

    /** The number of the entry that says whether it is connected; 0 for none. */
    var connectedEntry = 0

    val byName = LinkedHashMap<String, RecordedTopic>()
    val byId = HashMap<Long, RecordedTopic>()

    /** The name of the entry that says whether it is connected. */
    val connectedName: String get() = if (isRobot) "Recorder/Connected" else "Recorder/Connected ${server.prefix.trimEnd(':')}"

    companion object {
        /** As many as a reader takes. */
        const val MAX_TOPICS = 65_536
    }
}

/**
 * A topic of a server.
 *
 * @property name its name there.
 * @property typeName its type there, such as `int` or `struct:Pose2d`.
 * @property logName its name in the log.
 */
internal class RecordedTopic(val name: String, val typeName: String, val logName: String, properties: JsonObject) {
    val type: TopicType = TopicType.of(typeName)

    /** Its type in a WPILOG, which calls an integer by its size. */
    val logType: String get() = if (typeName == "int" || typeName == "int[]") typeName.replace("int", "int64") else typeName

    var properties: JsonObject = properties
        private set

    /** What WPILib's own logger writes for a topic of NetworkTables. */
    val metadata: String get() = "{\"properties\":$properties,\"source\":\"NT\"}"

    /** Its last value, as in a record, and since when it holds, in the server's time; null before the first. */
    var latest: ByteArray? = null
    var latestMicros = 0L

    /** The number of its entry in the current file, 0 for none; and the time of its last record there, or null. */
    var entry = 0
    var writtenMicros: Long? = null

    /** Whether the server is about to send its current value, which may be known already. */
    var isRepeating = true

    fun update(changes: JsonObject) {
        properties = JsonObject((properties + changes).filterValues { it !is JsonNull })
    }

    fun replaceProperties(all: JsonObject) {
        properties = all
    }
}
