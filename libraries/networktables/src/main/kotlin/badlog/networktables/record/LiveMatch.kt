package badlog.networktables.record

import java.nio.ByteBuffer
import java.nio.ByteOrder

/** The match according to the robot's topics in `/FMSInfo`, or from 2027 on in `/DriverStation`. */
internal class LiveMatch {
    private var event = ""
    private var type = 0L
    private var number = 0L

    /** Whether the robot is enabled; null if unknown. */
    var isEnabled: Boolean? = null
        private set

    /**
     * The end of the name of a match's log, as WPILib's `DataLogManager` forms it, such as `_CAMB_Q12`. Null if the robot is not in a
     * match.
     */
    val nameEnd: String?
        get() {
            if (number <= 0 || type !in 1L..TYPES.length) return null
            val place = event.replace(UNSAFE, "-").take(MAX_EVENT)
            return (if (place.isEmpty()) "" else "_$place") + "_${TYPES[type.toInt() - 1]}$number"
        }

    /** Handles a value of the topic [name], in the form of a record's payload. */
    fun handle(name: String, payload: ByteArray) {
        when (name.substringAfterLast('/')) {
            "EventName" -> event = payload.decodeToString()
            "MatchType" -> type = int(payload) ?: type
            "MatchNumber" -> number = int(payload) ?: number
            CONTROL -> isEnabled = int(payload)?.let { it and ENABLED != 0L } ?: isEnabled
            CONTROL_2027 -> isEnabled = int(payload)?.let { it and ENABLED_2027 != 0L } ?: isEnabled
        }
    }

    private fun int(payload: ByteArray): Long? =
        if (payload.size == Long.SIZE_BYTES) ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN).getLong() else null

    companion object {
        /** The folders of these topics, until 2026 and from 2027 on. */
        val FOLDERS = listOf("/FMSInfo/", "/DriverStation/")

        /** Returns whether the topic [name] is directly in one of these folders. */
        fun isMatchTopic(name: String): Boolean = FOLDERS.any { name.startsWith(it) && name.indexOf('/', it.length) < 0 }

        /** The topic that says whether the robot is enabled, in its lowest bit. */
        const val CONTROL = "FMSControlData"

        /** The same topic from 2027 on: a struct of 64 bits. The lower 58 are the op mode. */
        const val CONTROL_2027 = "ControlWord"
        private const val ENABLED = 1L
        private const val ENABLED_2027 = 1L shl 58
        private const val TYPES = "PQE"
        private const val MAX_EVENT = 40
        private val UNSAFE = Regex("[^A-Za-z0-9.-]")
    }
}
