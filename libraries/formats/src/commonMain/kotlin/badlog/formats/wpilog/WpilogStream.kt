package badlog.formats.wpilog

/**
 * Writes a WPILOG record by record, for data that arrives while it is written. Not thread-safe.
 *
 * @param sink receives the file in pieces of up to 64 KiB, or one record, each `[0, size)` of the array, which is reused after the call.
 *   An exception from it is passed on; the piece is then lost.
 */
public class WpilogStream(private val sink: (bytes: ByteArray, size: Int) -> Unit) {
    private val out = RecordBuffer().apply { header("") }
    private var entries = 0

    /**
     * Starts an entry with a new number, and returns that number.
     *
     * @param type its type, such as `double` or `struct:Pose2d`.
     * @param metadata text about it, usually JSON; may be empty.
     */
    public fun start(name: String, type: String, metadata: String, micros: Long): Int {
        val id = ++entries
        out.start(id, name, type, metadata, micros.toDouble())
        passOn()
        return id
    }

    /** Writes a record of entry [id] at [micros], exact up to 2^53. [payload] must have the form that the entry's type requires. */
    public fun record(id: Int, micros: Long, payload: ByteArray) {
        out.record(id, micros.toDouble(), payload, 0, payload.size)
        passOn()
    }

    /** Replaces the metadata of entry [id]. */
    public fun changeMetadata(id: Int, metadata: String, micros: Long) {
        val text = metadata.encodeToByteArray()
        control(micros, byteArrayOf(ControlKind.SET_METADATA.toByte()) + bytesOf(id) + bytesOf(text.size) + text)
    }

    /** Ends entry [id]: no record of it may follow. */
    public fun finish(id: Int, micros: Long): Unit = control(micros, byteArrayOf(ControlKind.FINISH.toByte()) + bytesOf(id))

    /** Passes on everything that was written. */
    public fun flush() {
        val size = out.size
        if (size == 0) return
        // The buffer keeps its bytes until it is written to.
        out.clear()
        sink(out.bytes, size)
    }

    private fun control(micros: Long, payload: ByteArray) {
        out.record(0, micros.toDouble(), payload, 0, payload.size)
        passOn()
    }

    private fun passOn() {
        if (out.size >= PIECE) flush()
    }

    private fun bytesOf(number: Int) = ByteArray(Int.SIZE_BYTES) { (number ushr 8 * it).toByte() }
}

private const val PIECE = 1 shl 16
