package badlog.networktables.record

import badlog.networktables.TopicType
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject

/**
 * The state of one server. Use it only on the recorder's thread, except for [server].
 *
 * @property isRobot whether it is the robot's server, with the clock that the log uses.
 */
internal class Source(val server: RecordedServer, val isRobot: Boolean) {
    val sync = TimeSync()

    /** The current connection; null if there is none. */
    var link: Link? = null

    /** Whether the server has answered and sends values. */
    var isSubscribed = false

    /** The number of the entry that says whether it is connected; 0 for none. */
    var connectedEntry = 0

    val byName = LinkedHashMap<String, RecordedTopic>()
    val byId = HashMap<Long, RecordedTopic>()

    /** The name of the entry that says whether it is connected. */
    val connectedName: String get() = if (isRobot) "Recorder/Connected" else "Recorder/Connected ${server.prefix.trimEnd(':')}"

    companion object {
        /** The maximum number of topics that readers of logs accept. */
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

    /** Its type in a WPILOG, where integer types include their size. */
    val logType: String get() = if (typeName == "int" || typeName == "int[]") typeName.replace("int", "int64") else typeName

    var properties: JsonObject = properties
        private set

    /** Its entry's metadata, as WPILib's own logger writes it. */
    val metadata: String get() = "{\"properties\":$properties,\"source\":\"NT\"}"

    /** Its last value as a record's payload, and the server's time when it was set; null before the first value. */
    var latest: ByteArray? = null
    var latestMicros = 0L

    /** The number of its entry in the current file, 0 for none. Beside it is the time of its last record there, null for none. */
    var entry = 0
    var writtenMicros: Long? = null

    /** Whether the next value may repeat one already received. */
    var isRepeating = true

    fun update(changes: JsonObject) {
        properties = JsonObject((properties + changes).filterValues { it !is JsonNull })
    }

    fun replaceProperties(all: JsonObject) {
        properties = all
    }
}
