package badlog.formats.wpilog

import badlog.core.recording.PathName
import badlog.core.recording.Value
import badlog.core.text.originOf
import badlog.core.text.wallTimeText

/** The facts about the whole run that certain entries report: the match, and the time of day. */
internal class MatchMetadata {
    private var event: String? = null
    private var matchType: String? = null
    private var matchNumber: Long? = null
    private var alliance: String? = null
    private var wallOffset: Double? = null
    private val own = LinkedHashMap<String, String>()

    /** Listens to [entry] if it concerns the run. */
    fun watch(entry: Entry) {
        if (entry.name == Entry.SYSTEM_TIME && entry.isInteger) {
            // Later values are better: a robot's clock is set when the Driver Station connects.
            entry.listener = longListener { micros, number -> wallOffset = number.toDouble() - micros }
            return
        }
        if (entry.isValue) {
            entry.listener = EntryListener { _, bytes, from, until -> own[entry.name] = bytes.decodeToString(from, until) }
            return
        }
        if (SOURCES.none { it in entry.name }) return
        val name = PathName.baseNameOf(entry.name)
        when {
            name == "EventName" && entry.type == "string" ->
                entry.listener = EntryListener { _, bytes, from, until ->
                    if (until > from) event = bytes.decodeToString(from, until)
                }

            name == "MatchNumber" && entry.isInteger ->
                entry.listener = longListener { _, number -> if (number > 0) matchNumber = number }

            name == "MatchType" && entry.isInteger ->
                entry.listener = longListener { _, number ->
                    if (number in 1L..MATCH_TYPES.size) matchType = MATCH_TYPES[number.toInt() - 1]
                }

            name == "IsRedAlliance" && entry.type == "boolean" ->
                entry.listener = EntryListener { _, bytes, from, until ->
                    if (until > from) alliance = if (bytes[from].toInt() != 0) "Red" else "Blue"
                }

            name == "AllianceStation" && entry.isInteger ->
                entry.listener = longListener { _, number -> if (number in 1L..6L) alliance = if (number <= 3) "Red" else "Blue" }
        }
    }

    /**
     * Returns the time of day at [micros], in µs since 1970; null if it is unknown. The records of a laptop may have the time of day as
     * their time.
     */
    fun startMicros(micros: Double): Double? = (wallOffset ?: if (originOf(micros) > 0) 0.0 else null)?.plus(micros)

    /** Returns the facts that were found, for a recording that begins at [firstMicros]. */
    fun values(firstMicros: Double): List<Value> = buildList {
        for ((name, text) in own) add(Value(name, text))
        fun offer(name: String, text: String?) {
            if (text != null && name !in own) add(Value(name, text))
        }
        offer("Event Name", event)
        offer("Match Type", matchType)
        offer("Match Number", matchNumber?.toString())
        // Off the field, every robot is red.
        if (event != null || matchNumber != null) offer("Alliance", alliance)
        offer("Start Time", startMicros(firstMicros)?.let(::wallTimeText))
    }

    private fun longListener(handle: (micros: Double, number: Long) -> Unit) = EntryListener { micros, bytes, from, until ->
        if (until - from == Long.SIZE_BYTES) handle(micros, longAt(bytes, from))
    }

    private companion object {
        /** The folders in which WPILib, and a logger based on it, put the facts from the field. */
        val SOURCES = listOf("FMSInfo/", "DriverStation/")
        val MATCH_TYPES = listOf("Practice", "Qualification", "Elimination")
    }
}
