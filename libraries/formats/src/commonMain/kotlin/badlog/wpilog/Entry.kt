package badlog.wpilog

/**
 * What a file says of one name and type, under however many numbers it was begun.
 *
 * @property name as it stands in the file.
 * @property type as it stands in the file.
 * @property isValue whether it is not a topic, but a value that badlog has written.
 */
internal class Entry(val name: String, val type: String, val isValue: Boolean, val decoder: PayloadDecoder) {
    /** What the file said of it last. */
    var metadata = ""

    /** Takes each payload too, where it tells something of the whole recording. */
    var listener: EntryListener? = null

    /** The unit of its samples. */
    val unit: String get() = if (decoder.isUndecoded) "B" else unitIn(metadata)

    /** What is to be done with it. */
    val attributes: List<String> get() = attributesIn(metadata, name)

    /** Whether it was the x axis of a bag that badlog has written as a WPILOG. */
    val wasXAxis: Boolean get() = X_AXIS_METADATA in metadata

    companion object {
        /** The entry in which WPILib's loggers tell the time of day. */
        const val SYSTEM_TIME = "systemTime"

        /** The folder of everything that describes types; also below `NT:`. */
        const val SCHEMA_FOLDER = "/.schema/"
    }
}

/** Hears the payloads of an entry. */
internal fun interface EntryListener {
    /** The payload from [from] until [until] of a record at [micros]. */
    fun heard(micros: Double, bytes: ByteArray, from: Int, until: Int)
}
