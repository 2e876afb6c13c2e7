package badlog.formats.driverstation

import badlog.formats.driverstation.Frames.Companion.MORE
import badlog.formats.driverstation.Frames.Companion.NONE
import kotlin.math.abs

/**
 * Finds the headers and the frames after them in bytes that are pushed to it. If no frame follows, it searches for the next place at which
 * several follow each other. The result depends only on the bytes, never on the pieces in which they arrive.
 *
 * @param begin receives the bytes at a header, and their end; returns the frames after the header, or null if they cannot be read.
 * @param skipped receives the range without frames, and the number of frames that it may have held.
 */
internal class FrameSplitter(
    private val begin: (bytes: ByteArray, at: Int, until: Int) -> Frames?,
    private val skipped: (from: Long, until: Long, frames: Int) -> Unit,
) {
    private var bytes = ByteArray(FIRST_SIZE)
    private var at = 0
    private var end = 0

    /** The position in the file of the first of [bytes]. */
    private var base = 0L
    private var frames: Frames? = null

    /** The version in the first header. */
    private var version = 0
    private var seconds = 0.0

    /** Whether another header may follow; only after records. */
    private var mayEnd = false

    /** The number of frames read. */
    var count = 0
        private set

    /** The position after which no frames have been found yet; below 0 if they continue. */
    var lostFrom = -1L
        private set

    /** The number of bytes received. */
    val total: Long get() = base + end

    /** The number of bytes at the end that are not a whole frame. */
    val pendingBytes: Int get() = end - at

    fun accept(piece: ByteArray, from: Int, until: Int) {
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
        go(isEnd = false)
    }

    fun finish(): Unit = go(isEnd = true)

    private fun go(isEnd: Boolean) {
        var goesOn = true
        while (goesOn && at < end) goesOn = step(isEnd)
    }

    /** Advances by a frame, a header or a lost byte. Returns false if that needs more bytes. */
    private fun step(isEnd: Boolean): Boolean {
        val current = frames
        if ((current == null || mayEnd) && !isEnd && end - at < HEADER_SIZE + Long.SIZE_BYTES) return false
        return when {
            current == null -> readHeader()
            isHeaderAt(at, if (lostFrom < 0) StationEvents.NEAR else SAME) -> readHeader()
            lostFrom < 0 -> readFrame(current, isEnd)
            else -> search(current, isEnd)
        }
    }

    /** Returns whether the header of the `.dsevents` is at [place], with a time less than [slack] s away. */
    private fun isHeaderAt(place: Int, slack: Double = SAME) = mayEnd && end - place >= HEADER_SIZE && wordAt(bytes, place) == version &&
        wordAt(bytes, place + Int.SIZE_BYTES) == 0 && abs(secondsAt(bytes, place + Int.SIZE_BYTES) - seconds) < slack

    private fun readHeader(): Boolean {
        if (end - at < HEADER_SIZE) return false
        frames?.let(::endSearch)
        version = wordAt(bytes, at)
        seconds = secondsAt(bytes, at + Int.SIZE_BYTES)
        val next = begin(bytes, at, end) ?: return false
        mayEnd = frames == null && next is StationRecords
        frames = next
        at += HEADER_SIZE
        return true
    }

    private fun readFrame(frames: Frames, isEnd: Boolean): Boolean {
        val size = frames.sizeAt(bytes, at, end, isEnd)
        if (size == NONE) {
            lostFrom = base + at
            return true
        }
        val after = at + if (size == MORE) 0 else size
        if (!isEnd && (size == MORE || (mayEnd && end - after < HEADER_SIZE))) return false
        // A record that was cut ends where the next file begins.
        for (place in at + 1 until if (size == MORE) end else after) {
            if (isHeaderAt(place)) {
                lostFrom = base + at
                at = place
                return true
            }
        }
        if (size == MORE) return false
        frames.take(bytes, at, size)
        count++
        at = after
        return true
    }

    private fun search(frames: Frames, isEnd: Boolean): Boolean {
        var place = at
        for (found in 0 until ROW) {
            if (found > 0 && ((place == end && isEnd) || isHeaderAt(place))) break
            if (!isEnd && mayEnd && end - place < HEADER_SIZE) return false
            val size = frames.sizeAt(bytes, place, end, isEnd)
            if (size == MORE && !isEnd) return false
            if (size <= 0 || !frames.isSure(bytes, place)) {
                at++
                return true
            }
            place += size
        }
        endSearch(frames)
        return true
    }

    private fun endSearch(frames: Frames) {
        if (lostFrom < 0) return
        val until = base + at
        skipped(lostFrom, until, frames.skip((until - lostFrom).toInt()))
        lostFrom = -1L
    }
}

private const val FIRST_SIZE = 1 shl 10

/** The maximum difference between the times in the headers of a pair of files, in s. */
private const val SAME = 2.0

/** The number of frames in a row that are not a coincidence. */
private const val ROW = 3
