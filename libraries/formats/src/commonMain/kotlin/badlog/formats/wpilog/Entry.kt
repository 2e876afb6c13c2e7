package badlog.formats.wpilog

/**
 * An entry of a file: one name and type, started under any number of ids.
 *
 * @property name the name exactly as in the file.
 * @property type the type exactly as in the file.
 * @property isValue whether it is a value written by badlog rather than a topic.
 */
internal class Entry(val name: String, val type: String, val isValue: Boolean, val decoder: PayloadDecoder) {
    /** Whether each record is one whole number of 8 bytes. */
    val isInteger: Boolean get() = type == "int64" || type == "int"

    // The size of a value in bytes; 0 if it varies.
    private val width = ValueLayout.of(type.removeSuffix("[]"))?.width ?: 0
    private val isArray = type.endsWith("[]")

    /** Whether all its records have the same size. */
    val hasOneSize: Boolean get() = width > 0 && !isArray

    /** Its last metadata in the file. */
    var metadata = ""

    /** The listener that also receives each payload, if the entry concerns the whole recording; otherwise null. */
    var listener: EntryListener? = null

    /** The unit of its samples. */
    val unit: String get() = if (decoder.isUndecoded) BYTE else unitIn(metadata)

    val attributes: List<String> get() = attributesIn(metadata, name)

    /** Its role in a bag that badlog converted to a WPILOG: [X_AXIS], [SPARSE], or anything else. Null if it has none. */
    val formerRole: String? get() = formerRoleIn(metadata)

    /** Returns whether a record of it may have a payload of [size] bytes. */
    fun fits(size: Int): Boolean = width == 0 || if (isArray) size % width == 0 else size == width

    companion object {
        /** The entry in which WPILib's loggers write the time of day. */
        const val SYSTEM_TIME = "systemTime"

        /** The folder of all type descriptions; also below `NT:`. */
        const val SCHEMA_FOLDER = "/.schema/"

        /** The type of the entries that describe messages of Protocol Buffers. */
        const val MESSAGE_SCHEMA = "proto:FileDescriptorProto"
    }
}

/** Receives the payloads of an entry. */
internal fun interface EntryListener {
    /** Receives the payload from [from] until [until] of a record at [micros]. */
    fun handle(micros: Double, bytes: ByteArray, from: Int, until: Int)
}
