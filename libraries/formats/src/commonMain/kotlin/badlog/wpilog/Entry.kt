package badlog.wpilog

/**
 * What a file says of one name and type, under however many numbers it was begun.
 *
 * @property name as it stands in the file.
 * @property type as it stands in the file.
 * @property isValue whether it is not a topic, but a value that badlog has written.
 */
internal class Entry(val name: String, val type: String, val isValue: Boolean, val decoder: PayloadDecoder) {
    // How many bytes a value has; 0 where it may be any number.
    private val width = ValueLayout.of(type.removeSuffix("[]"))?.width ?: 0
    private val isArray = type.endsWith("[]")

    /** Whether all its records have one size. */
    val hasOneSize: Boolean get() = width > 0 && !isArray

    /** What the file said of it last. */
    var metadata = ""

    /** Takes each payload too, where it says something about the whole recording. */
    var listener: EntryListener? = null

    /** The unit of its samples. */
    val unit: String get() = if (decoder.isUndecoded) BYTE else unitIn(metadata)

    /** What is to be done with it. */
    val attributes: List<String> get() = attributesIn(metadata, name)

    /** Whether it was the x axis of a bag that badlog has written as a WPILOG. */
    val wasXAxis: Boolean get() = X_AXIS_METADATA in metadata

    /** Whether a record of it may have a payload of [size] bytes. */
    fun fits(size: Int): Boolean = width == 0 || if (isArray) size % width == 0 else size == width

    companion object {
        /** The entry in which WPILib's loggers tell the time of day. */
        const val SYSTEM_TIME = "systemTime"

        /** The folder of everything that describes types; also below `NT:`. */
        const val SCHEMA_FOLDER = "/.schema/"

        /** The type of the entries that describe messages of Protocol Buffers. */
        const val MESSAGE_SCHEMA = "proto:FileDescriptorProto"
    }
}

/** Hears the payloads of an entry. */
internal fun interface EntryListener {
    /** The payload from [from] until [until] of a record at [micros]. */
    fun heard(micros: Double, bytes: ByteArray, from: Int, until: Int)
}
