package badlog.viewer.draw.path

import badlog.signals.pose.Trail
import kotlin.math.abs

/**
 * The bounding boxes of blocks of a trail's samples. They make it possible to skip whole blocks that are invisible, within a pixel, or too
 * far from the pointer. The smallest blocks also have their straightness, which makes it possible to skip most of their samples.
 *
 * A block consists of [BLOCK] steps from sample to sample, so it shares its last sample with the next block; a block of the next level
 * consists of [BLOCK] blocks. All levels together take a sixth of the memory that the trail takes.
 */
internal class TrailPyramid(val trail: Trail) {
    /**
     * The levels, the finest first. Each block has its least and greatest x, then its least and greatest y. Without a place, they are
     * infinity and minus infinity.
     */
    private val levels = ArrayList<DoubleArray>()

    /**
     * The maximum distance of samples from straight lines, first in x, then in y. For each of the smallest blocks and each of [STRIDES].
     * The lines join samples that are a stride apart.
     */
    private val bends = FloatArray(2 * STRIDES.size * maxOf(0, (trail.size - 1) / BLOCK))

    init {
        for (i in bends.indices step 2) {
            val block = i / (2 * STRIDES.size)
            val stride = STRIDES[i / 2 % STRIDES.size]
            bends[i] = bendOf(trail.x, block * BLOCK, stride).toFloat()
            bends[i + 1] = bendOf(trail.y, block * BLOCK, stride).toFloat()
        }

        val blocks = DoubleArray(4 * maxOf(0, (trail.size - 1) / BLOCK))
        for (block in 0 until blocks.size / 4) boxOf(trail, block * BLOCK, blocks, 4 * block)
        var finer = blocks
        while (finer.isNotEmpty()) {
            levels += finer
            val below = finer
            finer = DoubleArray(below.size / 4 / BLOCK * 4) { i ->
                val isLeast = i % 2 == 0
                var value = below[i / 4 * 4 * BLOCK + i % 4]
                for (at in i / 4 * 4 * BLOCK + i % 4 until (i / 4 + 1) * 4 * BLOCK step 4) {
                    value = if (isLeast) minOf(value, below[at]) else maxOf(value, below[at])
                }
                value
            }
        }
    }

    private fun boxOf(trail: Trail, first: Int, into: DoubleArray, at: Int) {
        var left = Double.POSITIVE_INFINITY
        var right = Double.NEGATIVE_INFINITY
        var bottom = Double.POSITIVE_INFINITY
        var top = Double.NEGATIVE_INFINITY
        for (i in first..first + BLOCK) {
            val x = trail.x[i]
            val y = trail.y[i]
            if (x.isNaN() || y.isNaN()) continue
            if (x < left) left = x
            if (x > right) right = x
            if (y < bottom) bottom = y
            if (y > top) top = y
        }
        into[at] = left
        into[at + 1] = right
        into[at + 2] = bottom
        into[at + 3] = top
    }

    /** Returns the maximum distance of samples from straight lines; infinity if a sample has no place. */
    private fun bendOf(values: DoubleArray, first: Int, stride: Int): Double {
        var bend = 0.0
        var from = first
        while (from < first + BLOCK) {
            val rise = (values[from + stride] - values[from]) / stride
            for (i in 1 until stride) {
                val off = abs(values[from] + rise * i - values[from + i])
                if (!(off <= bend)) bend = if (off.isNaN()) Double.POSITIVE_INFINITY else off
            }
            from += stride
        }
        return bend
    }

    /**
     * Returns the largest stride with which a line through samples of the smallest [block] is accurate enough. Its distance from the
     * skipped samples is at most [bendX] in x and [bendY] in y.
     */
    fun strideOf(block: Int, bendX: Double, bendY: Double): Int {
        var at = 2 * STRIDES.size * block
        for (stride in STRIDES) {
            if (bends[at] <= bendX && bends[at + 1] <= bendY) return stride
            at += 2
        }
        return 1
    }

    /**
     * Calls [visit] with the samples from [start] until [end], in order, except those within blocks for which [isSkipped] is true.
     *
     * @param isSkipped receives a box and its number of steps. The box is an array and the index of its least x, which is followed by its
     *   greatest x, least y and greatest y. The block's first sample was visited or skipped before.
     * @param onSkip is called with the last sample of each skipped block.
     * @param strideOf returns the stride with which samples of the smallest block with the given index are visited.
     */
    inline fun visit(
        start: Int,
        end: Int,
        isSkipped: (DoubleArray, Int, Int) -> Boolean,
        onSkip: (Int) -> Unit,
        strideOf: (Int) -> Int = { 1 },
        visit: (Int) -> Unit,
    ) {
        var i = start
        var stride = 1
        while (i < end) {
            visit(i)
            if (i and BLOCK - 1 == 0) {
                var steps = stepsFrom(i, end, isSkipped)
                while (steps > 0) {
                    i += steps
                    onSkip(i)
                    steps = stepsFrom(i, end, isSkipped)
                }
                stride = if (i + BLOCK < end) strideOf(i shr BITS) else 1
            }
            i += stride
        }
    }

    /**
     * Returns the number of steps of the largest block that begins with sample [i]. The block ends before [end] and [isSkipped]; 0 if there
     * is none.
     */
    private inline fun stepsFrom(i: Int, end: Int, isSkipped: (DoubleArray, Int, Int) -> Boolean): Int {
        for (level in levels.indices.reversed()) {
            val steps = 1 shl BITS * (level + 1)
            if (i and steps - 1 == 0 && i + steps < end && isSkipped(levels[level], (i shr BITS * (level + 1)) * 4, steps)) return steps
        }
        return 0
    }

    internal companion object {
        private const val BITS = 4

        /** The number of steps of the smallest blocks. */
        const val BLOCK: Int = 1 shl BITS

        private val STRIDES = intArrayOf(16, 8, 4)
    }
}
