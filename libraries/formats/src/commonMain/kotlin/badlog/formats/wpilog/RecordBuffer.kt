package badlog.formats.wpilog

/** The bytes of a WPILOG that is being written, record by record. */
internal class RecordBuffer {
    /** The bytes written since the last [clear], in the first [size] elements. */
    var bytes = ByteArray(1 shl 16)
        private set
    var size = 0
        private set

    fun clear() {
        size = 0
    }

    /** Writes the header, with [extra] as its additional text. */
    fun header(extra: String) {
        for (char in RecordSplitter.MAGIC) byte(char.code)
        byte(0)
        byte(1)
        text(extra)
    }

    fun start(id: Int, name: String, type: String, metadata: String, micros: Double = 0.0) {
        val texts = listOf(name, type, metadata).map { it.encodeToByteArray() }
        head(0, micros, 1 + Int.SIZE_BYTES + texts.sumOf { Int.SIZE_BYTES + it.size })
        byte(0)
        number(id, Int.SIZE_BYTES)
        for (text in texts) {
            number(text.size, Int.SIZE_BYTES)
            raw(text)
        }
    }

    fun double(id: Int, micros: Double, value: Double) {
        head(id, micros, Double.SIZE_BYTES)
        long(value.toRawBits())
    }

    fun float(id: Int, micros: Double, value: Float) {
        head(id, micros, Float.SIZE_BYTES)
        number(value.toRawBits(), Float.SIZE_BYTES)
    }

    fun int64(id: Int, micros: Double, value: Long) {
        head(id, micros, Long.SIZE_BYTES)
        long(value)
    }

    fun boolean(id: Int, micros: Double, value: Boolean) {
        head(id, micros, 1)
        byte(if (value) 1 else 0)
    }

    fun string(id: Int, micros: Double, text: ByteArray) {
        head(id, micros, text.size)
        raw(text)
    }

    /** Copies a record, or part of a file, unchanged from [source], from [from] until [until]. */
    fun copy(source: ByteArray, from: Int, until: Int) {
        reserve(until - from)
        source.copyInto(bytes, size, from, until)
        size += until - from
    }

    /** Writes a record of entry [id], 0 for a control record, with the payload in [source] from [from] until [until]. */
    fun record(id: Int, micros: Double, source: ByteArray, from: Int, until: Int) {
        head(id, micros, until - from)
        copy(source, from, until)
    }

    // Writes each number in as few bytes as possible, like WPILib's own writer.
    private fun head(id: Int, micros: Double, payload: Int) {
        reserve(MAX_HEAD_BYTES + payload)
        val time = micros.toLong()
        val idSize = sizeOf(id.toLong(), Int.SIZE_BYTES)
        val sizeSize = sizeOf(payload.toLong(), Int.SIZE_BYTES)
        val timeSize = sizeOf(time, Long.SIZE_BYTES)
        byte(idSize - 1 or (sizeSize - 1 shl 2) or (timeSize - 1 shl 4))
        number(id, idSize)
        number(payload, sizeSize)
        for (i in 0 until timeSize) byte((time ushr 8 * i).toInt())
    }

    private fun sizeOf(number: Long, most: Int): Int {
        var size = 1
        while (size < most && number ushr 8 * size != 0L) size++
        return size
    }

    private fun text(text: String) {
        val encoded = text.encodeToByteArray()
        reserve(Int.SIZE_BYTES + encoded.size)
        number(encoded.size, Int.SIZE_BYTES)
        raw(encoded)
    }

    private fun raw(more: ByteArray) {
        more.copyInto(bytes, size)
        size += more.size
    }

    private fun long(bits: Long) {
        number(bits.toInt(), Int.SIZE_BYTES)
        number((bits ushr Int.SIZE_BITS).toInt(), Int.SIZE_BYTES)
    }

    private fun number(number: Int, width: Int) {
        for (i in 0 until width) byte(number ushr 8 * i)
    }

    private fun byte(byte: Int) {
        bytes[size++] = byte.toByte()
    }

    private fun reserve(more: Int) {
        if (size + more > bytes.size) bytes = bytes.copyOf(maxOf(size + more, bytes.size * 2))
    }
}

private const val MAX_HEAD_BYTES = 17
