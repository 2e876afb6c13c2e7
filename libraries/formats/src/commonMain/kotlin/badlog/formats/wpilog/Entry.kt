package badlog.formats.wpilog

/**
 * What a file says about one name and type, under however many ids it was started.
 *
 * @property name the name exactly as in the file.
 * @property type the type exactly as in the file.
 * @property isValue whether it is not a topic, but a value written by badlog.
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

    /** Also receives each payload, if it says something about the whole recording. */
    var listener: EntryListener? = null

    /** The unit of its samples. */
    val unit: String get() = if (decoder.isUndecoded) BYTE else unitIn(metadata)

    val attributes: List<String> get() = attributesIn(metadata, name)

    /** What it was in a bag that badlog converted to a WPILOG: [X_AXIS], [SPARSE], or anything else. */
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
