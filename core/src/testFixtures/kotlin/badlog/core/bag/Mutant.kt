package badlog.core.bag

import kotlin.random.Random

/**
 * A file damaged by a loss of power, a bad disk or a failed transfer.
 *
 * @property bytes the content of the file now.
 * @property origin for each byte its place in the original; -1 for a new byte.
 * @property damage a description of the damage, for messages.
 */
internal class Mutant(val bytes: ByteArray, val origin: IntArray, val damage: String) {
    /** Returns whether the bytes of the original from [from] until [until] are still together. */
    fun holds(from: Int, until: Int): Boolean {
        for (at in origin.indices) if (origin[at] == from && holdsAt(at, from, until)) return true
        return false
    }

    /** Returns whether the bytes of the original from [from] until [until] are at [at]. */
    fun holdsAt(at: Int, from: Int, until: Int): Boolean = at >= 0 && at + until - from <= origin.size && (from until until).all { origin[at + it - from] == it }

    private fun replaced(at: Int, size: Int, by: ByteArray, origins: IntArray, damage: String): Mutant {
        val end = minOf(bytes.size, at + size)
        return Mutant(
            bytes.copyOf(at) + by + bytes.copyOfRange(end, bytes.size),
            origin.copyOf(at) + origins + origin.copyOfRange(end, origin.size),
            "${this.damage}; $damage at $at",
        )
    }

    /** Returns this file with one more damaged place, which is in its first [head] bytes more often than elsewhere. */
    fun damaged(random: Random, head: Int): Mutant {
        val place = if (random.nextBoolean()) minOf(head, bytes.size) else bytes.size
        if (place == 0) return this
        val at = random.nextInt(place)
        val size = random.nextInt(1, if (random.nextBoolean()) 8 else 300)
        fun new(bytes: ByteArray) = replaced(at, bytes.size, bytes, IntArray(bytes.size) { -1 }, "${bytes.size} bytes")
        return when (random.nextInt(8)) {
            0, 1 -> new(byteArrayOf((bytes[at].toInt() xor (1 shl random.nextInt(8))).toByte()))
            2 -> new(byteArrayOf("-,\"\n\u0001 ;{".random(random).code.toByte()))
            3 -> new(ByteArray(size))
            4 -> new(random.nextBytes(minOf(size, 64)))
            5 -> replaced(at, size, ByteArray(0), IntArray(0), "loss of $size bytes")
            6 -> minOf(bytes.size, at + size).let { replaced(at, 0, bytes.copyOfRange(at, it), origin.copyOfRange(at, it), "repetition") }
            else -> Mutant(bytes.copyOf(at), origin.copyOf(at), "$damage; cut at $at")
        }
    }

    companion object {
        /** Returns the file [bytes] with one or two damaged places. */
        fun of(bytes: ByteArray, random: Random, head: Int): Mutant {
            val whole = Mutant(bytes, IntArray(bytes.size) { it }, "")
            val once = whole.damaged(random, head)
            return if (random.nextInt(4) == 0) once.damaged(random, head) else once
        }
    }
}
