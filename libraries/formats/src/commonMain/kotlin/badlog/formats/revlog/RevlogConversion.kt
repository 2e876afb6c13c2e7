package badlog.formats.revlog

import badlog.core.recording.Loss
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.formats.wpilog.RecordBuffer

/**
 * Converts a `.revlog` that is pushed to it to a WPILOG. A `.revlog` has the status frames that REV's devices have sent on the CAN bus, and
 * their firmware versions. The topics of the WPILOG have the same names as from REV's own converter, such as
 * `REV/Spark-3/MOTOR_TEMPERATURE`.
 *
 * The file is a sequence of records. Each begins with a byte that has the widths of the next two numbers in its lowest four bits. These are
 * a number for its kind, and the size of its content: firmware (10 bytes per device), or status frames (16 bytes each: ms since the robot's
 * program began, the frame's identifier, eight bytes). The conversion never throws because of the bytes: if no record follows, it searches
 * for the next place at which one does.
 *
 * @param sink receives the WPILOG in pieces, each `[0, size)` of the array, which is reused after the call.
 */
public class RevlogConversion(private val sink: (bytes: ByteArray, size: Int) -> Unit) {
    private val wpilog = RecordBuffer().apply { header(extra = "") }
    private var entryCount = 0
    private val entries = HashMap<Long, IntArray>()
    private val problems = ArrayList<Problem>()
    private val known = HashSet<Int>()
    private var bytes = ByteArray(1 shl 12)
    private var at = 0
    private var end = 0

    /** The position in the file of the first of [bytes]. */
    private var base = 0L

    /** The position after which no records have been found yet; below 0 if they continue. */
    private var lostFrom = -1L

    /** Accepts the next bytes, from [from] until [until] of [piece]. */
    public fun accept(piece: ByteArray, from: Int = 0, until: Int = piece.size) {
        val size = until - from
        if (end + size > bytes.size) {
            val room = if (end - at + size > bytes.size / 2) ByteArray((end - at + size) * 2) else bytes
            bytes.copyInto(room, 0, at, end)
            bytes = room
            base += at
            end -= at
            at = 0
        }
        piece.copyInto(bytes, end, from, until)
        end += size
        while (step()) if (wpilog.size > PIECE) flush()
        flush()
    }

    /** Marks the end of the bytes. Returns their problems. */
    public fun finish(): List<Problem> {
        // A record with a damaged size may seem to extend beyond the end, with complete ones inside.
        val left = base + at
        while (at < end) {
            if (lostFrom < 0) lostFrom = base + at
            at++
            while (step()) continue
        }
        val total = base + end
        if (lostFrom in 0 until left) {
            lost(lostFrom, total)
        } else if (lostFrom >= 0) {
            problems += Problem(
                ProblemKind.RECORD_CUT,
                "The file ends inside a record, which was dropped.",
                loss = Loss(bytes = total - lostFrom),
            )
        }
        flush()
        return problems
    }

    private fun flush() {
        if (wpilog.size == 0) return
        sink(wpilog.bytes, wpilog.size)
        wpilog.clear()
    }

    /** Advances by a record or a lost byte. Returns false if that needs more bytes. */
    private fun step(): Boolean {
        if (at >= end) return false
        val head = RevlogHead.at(bytes, at, end)
        if (head === RevlogHead.MORE) return false
        if (head == null) {
            if (lostFrom < 0) lostFrom = base + at
            at++
            return true
        }
        val next = at + head.headSize + head.size
        if (next > end) return false
        if (lostFrom >= 0) {
            lost(lostFrom, base + at)
            lostFrom = -1L
        }
        for (frame in at + head.headSize until next step head.frameSize) if (head.isFirmware) firmware(frame) else status(frame)
        at = next
        return true
    }

    private fun lost(from: Long, until: Long) {
        problems += Problem(
            ProblemKind.RECORDS_SKIPPED,
            "Bytes $from to ${until - 1} are not records and were skipped.",
            loss = Loss(bytes = until - from),
        )
    }

    private fun firmware(frame: Int) {
        val id = wordAt(bytes, frame)
        val device = REV_DEVICES[typeOf(id)] ?: return
        if (!known.add(id and DEVICE)) return
        val entry = start("${nameOf(device, id)}/FIRMWARE", "string", VALUE)
        wpilog.string(entry, 0.0, device.version(bytes, frame + Int.SIZE_BYTES).encodeToByteArray())
    }

    private fun status(frame: Int) {
        val micros = wordAt(bytes, frame).toUInt().toDouble() * MICROS
        val id = wordAt(bytes, frame + Int.SIZE_BYTES)
        if (id shr CLASS_BIT and CLASS_MASK != STATUS_CLASS) return
        val device = REV_DEVICES[typeOf(id)] ?: return
        val index = id shr FRAME_BIT and FRAME_MASK
        val signals = device.frames[index] ?: return
        val numbers = entries.getOrPut((id and DEVICE).toLong() shl Int.SIZE_BITS or index.toLong()) {
            IntArray(signals.size) { start(nameOf(device, id), signals[it]) }
        }
        val bits = wordAt(bytes, frame + 8).toUInt().toLong() or (wordAt(bytes, frame + 12).toLong() shl Int.SIZE_BITS)
        for (i in signals.indices) {
            val number = signals[i].read(bits)
            if (signals[i].isFlag) wpilog.boolean(numbers[i], micros, number != 0.0) else wpilog.double(numbers[i], micros, number)
        }
    }

    private fun start(device: String, signal: RevSignal): Int {
        val folder = listOf("FAULT", "WARNING").firstOrNull { signal.name.endsWith(it) }?.let { "/$it" }.orEmpty()
        val metadata = if (signal.unit.isEmpty()) "" else "{\"unit\":\"${signal.unit}\"}"
        return start("$device$folder/${signal.name}", if (signal.isFlag) "boolean" else "double", metadata)
    }

    private fun start(name: String, type: String, metadata: String): Int {
        wpilog.start(++entryCount, name, type, metadata)
        return entryCount
    }

    private fun nameOf(device: RevDevice, id: Int) = "REV/${device.name}-${id and NUMBER}"
}

/** The head of a record: it has [headSize] bytes, and [size] bytes of frames follow. */
internal class RevlogHead private constructor(val headSize: Int, val size: Int, val isFirmware: Boolean) {
    /** The size of each of its frames in bytes. */
    val frameSize: Int get() = if (isFirmware) FIRMWARE_SIZE else STATUS_SIZE

    companion object {
        private const val FIRMWARE = 1
        private const val STATUS = 2
        private const val FIRMWARE_SIZE = 10
        private const val STATUS_SIZE = 16
        private const val MAX_SIZE = 1 shl 20
        private const val MANUFACTURER_BIT = 16
        private const val REV = 5

        /** The result if more bytes are needed to decide. */
        val MORE = RevlogHead(0, 0, false)

        /** Returns the head at [at] in [bytes], which end at [until]. Null if there is none; [MORE] if that is not clear yet. */
        fun at(bytes: ByteArray, at: Int, until: Int): RevlogHead? {
            if (at >= until) return MORE
            val widths = bytes[at].toInt()
            if (widths !in 0..0xF) return null
            val idSize = (widths and 3) + 1
            val sizeSize = (widths shr 2) + 1
            val headSize = 1 + idSize + sizeSize
            if (until - at < headSize) return MORE
            val kind = numberAt(bytes, at + 1, idSize)
            val size = numberAt(bytes, at + 1 + idSize, sizeSize)
            if (kind != FIRMWARE.toLong() && kind != STATUS.toLong()) return null
            val head = RevlogHead(headSize, size.toInt(), kind == FIRMWARE.toLong())
            if (size !in 1..MAX_SIZE || size % head.frameSize != 0L) return null
            // The frames must be REV's: the first one's identifier contains the manufacturer.
            val id = at + headSize + if (head.isFirmware) 0 else Int.SIZE_BYTES
            if (until - id < Int.SIZE_BYTES) return MORE
            return head.takeIf { wordAt(bytes, id) shr MANUFACTURER_BIT and 0xFF == REV }
        }

        private fun numberAt(bytes: ByteArray, at: Int, width: Int): Long {
            var number = 0L
            for (i in width - 1 downTo 0) number = number shl Byte.SIZE_BITS or (bytes[at + i].toLong() and 0xFF)
            return number
        }
    }
}

private fun typeOf(id: Int) = id shr 24 and 0x1F

private fun wordAt(bytes: ByteArray, at: Int): Int = (bytes[at].toInt() and 0xFF) or (bytes[at + 1].toInt() and 0xFF shl 8) or
    (bytes[at + 2].toInt() and 0xFF shl 16) or (bytes[at + 3].toInt() shl 24)

private const val CLASS_BIT = 10
private const val CLASS_MASK = 0x3F

/** The class of all status frames of REV's devices. */
private const val STATUS_CLASS = 46
private const val FRAME_BIT = 6
private const val FRAME_MASK = 0xF
private const val NUMBER = 0x3F
private const val DEVICE = 0x1F00003F

/** The metadata that mark an entry as a value in badlog's WPILOG. */
private const val VALUE = "{\"badlog\":\"value\"}"
private const val MICROS = 1000
private const val PIECE = 1 shl 16
