package badlog.formats.wpilog

import badlog.formats.column.ColumnSource
import badlog.formats.column.SampleBlock
import badlog.formats.column.Timestamps
import kotlin.math.PI

/**
 * A decoder for arrays of numbers that may be the path of a `Field2d`, WPILib's picture of the field. A path has x and y in m and the
 * heading in degrees of each pose, one after another. The first array that is not empty decides. An array of three numbers may be anything,
 * so it does not count as a path.
 *
 * @param isOfField returns whether the entry belongs to a `Field2d`.
 */
internal class FieldArrayDecoder(private val source: ColumnSource, private val isOfField: () -> Boolean) : PayloadDecoder() {
    private val emptyTimes = ArrayList<Double>()
    private var decoder: PayloadDecoder? = null

    override val timestamps: Timestamps get() = known(0).timestamps
    override val blocks: List<SampleBlock> get() = known(0).blocks

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        if (from == until && decoder == null && emptyTimes.size < MAX_HELD) {
            emptyTimes += time
            return
        }
        val known = known((until - from) / Double.SIZE_BYTES)
        known.accept(time, bytes, from, until)
        badCount = known.badCount
        droppedValues = known.droppedValues
        longestPath = known.longestPath
    }

    override fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = decoder?.fits(bytes, from, until) != false

    private fun known(count: Int): PayloadDecoder = decoder ?: create(count).also { created ->
        decoder = created
        for (time in emptyTimes) created.accept(time, NOTHING, 0, 0)
        emptyTimes.clear()
    }

    private fun create(count: Int) = if (count > POSE && count % POSE == 0 && isOfField()) {
        FieldPathDecoder(source)
    } else {
        LayoutArrayDecoder(source, checkNotNull(ValueLayout.of("double")))
    }

    private companion object {
        /** The number of values in a pose. */
        const val POSE = 3
        const val MAX_HELD = 1 shl 12
        val NOTHING = ByteArray(0)
    }
}

/** The poses of a path, with the names and units of WPILib's `Pose2d`, so that they appear as a path. */
private class FieldPathDecoder(source: ColumnSource) : ArrayDecoder(source, listOf("/translation/x", "/translation/y", "/rotation/value")) {
    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        if (!fits(bytes, from, until)) {
            badCount++
            return
        }
        val count = (until - from) / WIDTH
        for (index in 0 until count) {
            val block = elements.next(index, time)
            if (block == null) {
                longestPath = maxOf(longestPath, count)
                break
            }
            val at = from + index * WIDTH
            block.columns[0].addNumber(numberAt(bytes, at))
            block.columns[1].addNumber(numberAt(bytes, at + Double.SIZE_BYTES))
            block.columns[2].addNumber(numberAt(bytes, at + 2 * Double.SIZE_BYTES) * DEGREE)
        }
        elements.end(count, time)
    }

    override fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = (until - from) % WIDTH == 0

    private fun numberAt(bytes: ByteArray, at: Int) = Double.fromBits(longAt(bytes, at))
}

private const val WIDTH = 3 * Double.SIZE_BYTES
private const val DEGREE = PI / 180
