package badlog.formats.driverstation

import badlog.formats.column.ColumnSource
import badlog.formats.column.SampleColumn
import badlog.formats.column.Timestamps

/** The columns of the power distribution [name], a PDP or a PDH, in the blocks of a `.dslog`. */
internal class PowerColumns(private val name: String, private val source: ColumnSource) {
    private val isPdp = name == "PDP"
    private val channels = if (isPdp) PDP_CHANNELS else PDH_CHANNELS
    private val timestamps = Timestamps(source.keepsSamples)
    private var columns = emptyList<SampleColumn>()
    private var isMissing = true

    /** Reads the block at [at], or records that there is none if [isThere] is false. */
    fun take(time: Double, bytes: ByteArray, at: Int, isThere: Boolean) {
        if (!isThere) return miss(time)
        if (columns.isEmpty()) columns = source.columns(names())
        isMissing = false
        timestamps.add(time)
        var total = 0.0
        for (channel in 0 until channels) {
            val amps = if (isPdp) ampsOfPdp(bytes, at + 1, channel) else ampsOfPdh(bytes, at + 1, channel)
            total += amps
            columns[channel].addNumber(amps)
        }
        columns[channels].addNumber(total)
        if (isPdp) {
            columns[channels + 1].addNumber(byteAt(bytes, at + VOLTAGE) * 0.05 + 4.0)
            columns[channels + 2].addNumber(byteAt(bytes, at + TEMPERATURE) * 1.03250836957542 - 67.8564500484966)
        }
    }

    /** Records that nothing is known at [time]. */
    fun miss(time: Double) {
        if (isMissing) return
        isMissing = true
        timestamps.add(time)
        for (column in columns) column.addGap()
    }

    /** Passes each column with its unit and its attributes to [add]. */
    fun topics(add: (SampleColumn, String, List<String>, Timestamps) -> Unit) {
        columns.forEachIndexed { i, column ->
            val unit = if (i <= channels) "A" else TAIL[i - channels].second
            add(column, unit, if (i < channels) listOf("hide", "join:$name/Channel Currents") else emptyList(), timestamps)
        }
    }

    private fun names() = List(channels) { "$name/Channel $it" } + TAIL.take(if (isPdp) TAIL.size else 1).map { "$name/${it.first}" }

    // 10 bits per channel, the highest bit first, six channels in 8 bytes.
    private fun ampsOfPdp(bytes: ByteArray, at: Int, channel: Int): Double {
        val bit = channel / 6 * 64 + channel % 6 * 10
        return (shortAt(bytes, at + bit / 8) shr (6 - bit % 8) and TEN_BITS) / 8.0
    }

    // 10 bits per channel, the lowest bit first, three channels in 4 bytes; the last four have a byte each.
    private fun ampsOfPdh(bytes: ByteArray, at: Int, channel: Int): Double {
        if (channel >= WIDE_CHANNELS) return byteAt(bytes, at + NARROW + channel) / 16.0
        val bit = channel / 3 * 32 + channel % 3 * 10
        val byte = at + bit / 8
        return (byteAt(bytes, byte) or (byteAt(bytes, byte + 1) shl 8) shr bit % 8 and TEN_BITS) / 8.0
    }

    private companion object {
        const val PDP_CHANNELS = 16
        const val PDH_CHANNELS = 24
        const val TEN_BITS = 0x3FF
        const val WIDE_CHANNELS = 20

        /**
         * The offset of channel 0 from the byte after the CAN ID, if each channel had one byte. Only the last four channels of a PDH have
         * one byte each.
         */
        const val NARROW = 7
        const val VOLTAGE = 23
        const val TEMPERATURE = 24

        /** The values after the channels; a PDH has only the first. */
        val TAIL = listOf("Total Current" to "A", "Bus Voltage" to "V", "Temperature" to "°C")
    }
}
