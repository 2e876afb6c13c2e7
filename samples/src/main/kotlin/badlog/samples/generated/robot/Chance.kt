package badlog.samples.generated.robot

import java.util.SplittableRandom
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.ln
import kotlin.math.sqrt

/**
 * Random numbers for one purpose. Each purpose of a match has its own, so that a fault has only its physical consequences: the same match
 * without it has the same driver, noise and hits.
 */
internal class Chance(seed: Long, purpose: String) {
    private val random = SplittableRandom(seed xor (purpose.hashCode().toLong() * -0x61c8864680b583ebL))

    fun between(from: Double, to: Double): Double = from + random.nextDouble() * (to - from)

    fun below(count: Int): Int = random.nextInt(count)

    fun <T> of(items: List<T>): T = items[below(items.size)]

    fun isIn(share: Double): Boolean = random.nextDouble() < share

    /** Returns a normally distributed number with standard deviation [deviation]. */
    fun normal(deviation: Double): Double = deviation * sqrt(-2 * ln(1 - random.nextDouble())) * cos(2 * PI * random.nextDouble())
}

/** Episodes of an intermittent fault. */
internal class Episodes private constructor(private val starts: DoubleArray, private val ends: DoubleArray) {
    private var next = 0

    /** Returns whether [time] is in one of the episodes. Times must ascend from call to call. */
    fun holdAt(time: Double): Boolean {
        while (next < ends.size && ends[next] <= time) next++
        return next < starts.size && time >= starts[next]
    }

    companion object {
        /** Returns episodes of [lengths] s between [from] and [until], which take [share] of that time. */
        fun of(chance: Chance, from: Double, until: Double, share: Double, lengths: ClosedFloatingPointRange<Double>): Episodes {
            val starts = ArrayList<Double>()
            val ends = ArrayList<Double>()
            var at = from
            while (at < until) {
                val length = chance.between(lengths.start, lengths.endInclusive)
                starts += at
                ends += minOf(at + length, until)
                at += length / share * if (share >= 1) 1.0 else chance.between(0.7, 1.3)
            }
            return Episodes(starts.toDoubleArray(), ends.toDoubleArray())
        }
    }
}
