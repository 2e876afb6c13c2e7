package badlog.formats.wpilog

import kotlin.math.abs

/**
 * Distinguishes records from bytes that only look like them. A WPILOG has neither checksums nor marks between its records, but each record
 * names a started entry, has a size that fits its type, and a time near the previous one's.
 *
 * Every result depends only on the bytes, never on how many of them have arrived: if they are not enough, it is [RecordLook.MORE].
 */
internal class RecordSearch(private val sink: RecordSink) {
    private val head = RecordHead()

    /** Judges whether the bytes at [at] are a record after one at [near] µs; NaN if there was none before. Reads them into [head]. */
    fun look(head: RecordHead, bytes: ByteArray, at: Int, until: Int, near: Double): RecordLook {
        val possible = head.read(bytes, at, until)
        if (possible != RecordLook.FITTING) return possible
        if (head.id != 0) {
            val entry = sink.entryOf(head.id)
            head.entry = entry
            val isExpected = if (entry != null) entry.fits(head.size) else sink.isStranger(head.id)
            return if (isExpected && isNear(head.micros, near)) possible else RecordLook.ODD
        }
        head.entry = null
        if (head.size < CONTROL_HEAD) return RecordLook.NONE
        if (head.length > until - at) return RecordLook.MORE
        val end = at + head.length
        return if (mayBeControlPayload(bytes, end - head.size, end)) possible else RecordLook.ODD
    }

    /** Judges as [look] does, but only an exact control record is one. Such a place need not be the start of a record. */
    private fun strictLook(bytes: ByteArray, at: Int, until: Int, near: Double): RecordLook {
        val look = look(head, bytes, at, until, near)
        if (look != RecordLook.FITTING || head.id != 0) return look
        val end = at + head.length
        return if (isControlPayload(bytes, end - head.size, end)) look else RecordLook.ODD
    }

    /** Returns whether two times, in µs, are as close as consecutive records' times. True if one is NaN. */
    fun isNear(one: Double, other: Double): Boolean = !(abs(one - other) > NEAR_MICROS)

    /**
     * Returns the first place after damage, from [from] and before [end], at which several fitting records follow each other.
     *
     * @param isInside whether the place is inside bytes that may themselves be a record; the first records there must be of types with a fixed size.
     * @return the place; [NOWHERE] if there is none; [waiting] of the place where the search must continue when more bytes have arrived.
     */
    fun find(bytes: ByteArray, from: Int, end: Int, until: Int, isEnd: Boolean, near: Double, isInside: Boolean): Int {
        for (at in from until minOf(end, until)) {
            when (rowAt(bytes, at, until, isEnd, near, isInside)) {
                RecordLook.FITTING -> return at
                RecordLook.MORE -> return waiting(at)
                else -> continue
            }
        }
        return if (end <= until || isEnd) NOWHERE else waiting(until)
    }

    /** Returns whether fitting records in a row begin at [from]. The time of the first must be consistent with the others. */
    private fun rowAt(bytes: ByteArray, from: Int, until: Int, isEnd: Boolean, near: Double, isInside: Boolean): RecordLook {
        var at = from
        var fitting = 0
        var odd = 0
        var last = Double.NaN
        var firstStep = Double.NaN
        var longestStep = TIGHT_MICROS
        while (true) {
            if (at == until) return if (!isEnd) RecordLook.MORE else rowOf(fitting, MIN_AT_END, firstStep, longestStep)
            if (at - from > FARTHEST) return rowOf(fitting, MIN_FAR_AWAY, firstStep, longestStep)
            val look = strictLook(bytes, at, until, last)
            if (look == RecordLook.NONE) return look
            if (isInside && fitting < SURE && (look == RecordLook.ODD || (look == RecordLook.FITTING && !isSure()))) return RecordLook.NONE
            val isFar = look != RecordLook.MORE && head.length > FARTHEST
            if (isFar || look == RecordLook.MORE || head.length > until - at) {
                return if (isFar || isEnd) rowOf(fitting, MIN_FAR_AWAY, firstStep, longestStep) else RecordLook.MORE
            }
            if (look == RecordLook.ODD) {
                if (fitting == 0 || ++odd > MAX_ODD + fitting) return RecordLook.NONE
            } else {
                // The lost part may have been minutes long, but no log continues hours later.
                if (fitting == 0 && head.id != 0 && abs(head.micros - near) > FAR_MICROS) return RecordLook.NONE
                fitting++
            }
            if (head.id != 0) {
                val step = abs(head.micros - last)
                if (firstStep.isNaN()) {
                    firstStep = step
                } else if (step > longestStep) {
                    longestStep = step
                }
                last = head.micros
            }
            if (fitting == ENOUGH) return rowOf(fitting, ENOUGH, firstStep, longestStep)
            at += head.length
        }
    }

    private fun isSure() = head.id == 0 || head.hasOneSize

    // Damage may look like a record and end where a real one begins, but hardly with its time.
    private fun rowOf(fitting: Int, least: Int, firstStep: Double, longestStep: Double) =
        if (fitting >= least && !(firstStep > longestStep)) RecordLook.FITTING else RecordLook.NONE

    /** Returns whether the next records from [from] on fit, so that the previous one certainly ends there. */
    fun allFit(bytes: ByteArray, from: Int, until: Int, isEnd: Boolean): RecordLook {
        var at = from
        var last = Double.NaN
        repeat(GOES_ON) {
            if (at == until) return if (isEnd) RecordLook.FITTING else RecordLook.MORE
            val look = look(head, bytes, at, until, last)
            if (look == RecordLook.NONE || look == RecordLook.ODD || (look == RecordLook.FITTING && head.length > FARTHEST)) {
                return RecordLook.NONE
            }
            if (look == RecordLook.MORE || head.length > until - at) return if (isEnd) RecordLook.NONE else RecordLook.MORE
            if (head.id != 0) last = head.micros
            at += head.length
        }
        return RecordLook.FITTING
    }

    /** Returns whether records continue at [from], even if some are odd. If they do, the odd record before them has its correct size. */
    fun goesOn(bytes: ByteArray, from: Int, until: Int, isEnd: Boolean): RecordLook {
        var at = from
        var fitting = 0
        var odd = 0
        var last = Double.NaN
        while (fitting + odd < PATIENCE) {
            if (at == until) return if (isEnd) RecordLook.FITTING else RecordLook.MORE
            if (at - from > FARTHEST) break
            val look = look(head, bytes, at, until, last)
            if (look == RecordLook.NONE) return look
            if (look == RecordLook.MORE) return if (isEnd) RecordLook.FITTING else look
            if (look == RecordLook.FITTING) fitting++ else odd++
            if (fitting >= GOES_ON && fitting >= odd) break
            if (head.length > until - at) return if (isEnd) RecordLook.FITTING else RecordLook.MORE
            if (head.id != 0) last = head.micros
            at += head.length
        }
        return if (fitting > 0 || odd == PATIENCE) RecordLook.FITTING else RecordLook.NONE
    }

    companion object {
        /** The result of [find] if records continue nowhere. */
        const val NOWHERE = -1

        /** Returns the result of [find] if the search must continue at [at]. */
        fun waiting(at: Int): Int = NOWHERE - 1 - at

        /** Returns the place for which [waiting] returns [found]. */
        fun waitsAt(found: Int): Int = NOWHERE - 1 - found

        /** This many fitting records in a row are not a coincidence. */
        private const val ENOUGH = 10

        /** The number of them that must have types of a fixed size if the place may be inside a record. */
        private const val SURE = 2

        /** The number that is enough at the end of the file, or if they are very large. */
        private const val MIN_AT_END = 3
        private const val MIN_FAR_AWAY = 5

        /** The number of odd ones that may be among them, in addition to one for each fitting one. */
        private const val MAX_ODD = 2
        private const val GOES_ON = 4
        private const val PATIENCE = 100

        /** The maximum number of bytes to look ahead, which bounds the memory. */
        private const val FARTHEST = 1 shl 20

        /** One minute: the maximum distance between the times of consecutive records. */
        private const val NEAR_MICROS = 6e7
        private const val TIGHT_MICROS = 1e5

        /** Two hours. */
        private const val FAR_MICROS = 7.2e9
    }
}
