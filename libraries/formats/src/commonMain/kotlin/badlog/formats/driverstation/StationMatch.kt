package badlog.formats.driverstation

import badlog.core.recording.Value

/** The match, as reported by the field. */
internal class StationMatch {
    private var event = ""
    private var match: List<String> = emptyList()

    /** Searches the [text] of an entry for the match. */
    fun handle(text: String) {
        EVENT.find(text)?.let { event = it.groupValues[1] }
        MATCH.find(text)?.let { match = it.groupValues }
    }

    /** Returns the event and the match; empty if the field reported neither. */
    fun values(): List<Value> = buildList {
        if (event.isNotEmpty()) add(Value("Event Name", event))
        if (match.isNotEmpty()) {
            add(Value("Match Type", match[1]))
            add(Value("Match Number", match[2]))
            add(Value("Replay Number", match[3]))
        }
    }

    private companion object {
        val EVENT = Regex("FMS Event Name: *([^\\s<]+)")
        val MATCH = Regex("FMS Connected: +(\\w+) - (\\d+):(\\d+)")
    }
}
