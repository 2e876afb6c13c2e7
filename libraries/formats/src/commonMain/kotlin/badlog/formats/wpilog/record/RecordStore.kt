package badlog.formats.wpilog.record

import badlog.formats.wpilog.PayloadDecoder
import badlog.formats.wpilog.RecordBuffer

/** The bytes of records, in the order of their file, and the contents of their heads. */
internal class RecordStore {
    private val chunks = ArrayList<ByteArray>()
    private var used = 0
    private val chunk = IntList()
    private val head = IntList()
    private val payload = IntList()
    private val until = IntList()
    private val session = IntList()
    private var times = DoubleArray(64)
    private val sessionId = IntList()
    private val sessionEntry = IntList()
    private val sessionEnd = IntList()

    /** The number of records, including control records. */
    val size: Int get() = head.size

    /** Starts a session in which [id] belongs to [entry]. Returns the session, with which its records are added. */
    fun begin(id: Int, entry: Int): Int {
        sessionId.add(id)
        sessionEntry.add(entry)
        sessionEnd.add(Int.MAX_VALUE)
        return sessionId.size - 1
    }

    /** Ends [session]: its id no longer belongs to its entry. */
    fun end(session: Int) {
        sessionEnd[session] = size
    }

    /** Returns the first id from [wanted] on that no record has. */
    fun freeId(wanted: Int): Int {
        val taken = sessionId.toArray().toHashSet()
        return generateSequence(wanted) { it + 1 }.first { it !in taken }
    }

    /** Adds the record from [from] until [end] of [bytes]; its payload begins at [payloadFrom]. */
    fun add(bytes: ByteArray, from: Int, payloadFrom: Int, end: Int, micros: Double, session: Int, isControl: Boolean) {
        val length = end - from
        if (chunks.isEmpty() || chunks.last().size - used < length) {
            chunks += ByteArray(maxOf(CHUNK, length))
            used = 0
        }
        bytes.copyInto(chunks.last(), used, from, end)
        if (size == times.size) times = times.copyOf(size * 2)
        times[size] = micros
        chunk.add(chunks.size - 1)
        payload.add(used + payloadFrom - from)
        until.add(used + length)
        this.session.add(if (isControl) -1 - session else session)
        head.add(used)
        used += length
    }

    /** Returns whether record [index] begins, ends or describes an entry. */
    fun isControl(index: Int): Boolean = session[index] < 0

    /** Returns the first byte of the payload of the control record [index]: its kind. */
    fun controlKind(index: Int): Int = bytes(index)[payload[index]].toInt()

    /** Returns the time in record [index], in µs. */
    fun micros(index: Int): Double = times[index]

    /** Returns the entry of record [index]. */
    fun entry(index: Int): Int = sessionEntry[sessionOf(index)]

    /** Returns the id of record [index]'s entry in its session. */
    fun id(index: Int): Int = sessionId[sessionOf(index)]

    /** Returns the index of the record from which the id of record [index] no longer belongs to its entry. */
    fun sessionEnd(index: Int): Int = sessionEnd[sessionOf(index)]

    /** Marks record [index] as dropped. */
    fun drop(index: Int) {
        until[index] = -1
    }

    /** Returns whether record [index] is dropped. */
    fun isDropped(index: Int): Boolean = until[index] < 0

    /** Returns whether [decoder] can read the payload of record [index]. */
    fun fits(index: Int, decoder: PayloadDecoder): Boolean = decoder.fits(bytes(index), payload[index], until[index])

    /** Returns the payload of record [index]. */
    fun payload(index: Int): ByteArray = bytes(index).copyOfRange(payload[index], until[index])

    /** Writes record [index] unchanged. */
    fun copy(index: Int, out: RecordBuffer) = out.copy(bytes(index), head[index], until[index])

    /** Writes record [index] with another time, as a record of entry [id]; 0 for a control record. */
    fun copy(index: Int, id: Int, micros: Double, out: RecordBuffer) = out.record(id, micros, bytes(index), payload[index], until[index])

    /** Returns whether record [index] has the same payload as record [otherIndex] of [other]. */
    fun isSame(index: Int, other: RecordStore, otherIndex: Int): Boolean {
        val length = until[index] - payload[index]
        if (other.until[otherIndex] - other.payload[otherIndex] != length) return false
        val one = bytes(index)
        val two = other.bytes(otherIndex)
        val at = payload[index]
        val otherAt = other.payload[otherIndex]
        for (i in 0 until length) if (one[at + i] != two[otherAt + i]) return false
        return true
    }

    private fun bytes(index: Int) = chunks[chunk[index]]

    private fun sessionOf(index: Int) = session[index].let { if (it < 0) -1 - it else it }
}

/** A growing list of numbers, without an object for each. */
internal class IntList {
    private var numbers = IntArray(16)

    var size = 0
        private set

    fun add(number: Int) {
        if (size == numbers.size) numbers = numbers.copyOf(size * 2)
        numbers[size++] = number
    }

    operator fun get(index: Int): Int = numbers[index]

    operator fun set(index: Int, number: Int) {
        numbers[index] = number
    }

    fun toArray(): IntArray = numbers.copyOf(size)
}

private const val CHUNK = 1 shl 20
