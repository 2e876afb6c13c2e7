package badlog.formats.driverstation

import badlog.formats.column.ColumnSource
import badlog.formats.column.SampleColumn
import badlog.formats.column.Timestamps
import badlog.formats.driverstation.Frames.Companion.MORE
import badlog.formats.driverstation.Frames.Companion.NONE

/** The records of a `.dslog` of [version] 3 or 4: one every 20 ms, without a time. */
internal class StationRecords(private val version: Int, source: ColumnSource) : Frames {
    private val timestamps = Timestamps(source.keepsSamples)
    private val columns = source.columns(RECORD_TOPICS.map { it.first })
    private val pdp = PowerColumns("PDP", source)
    private val pdh = PowerColumns("PDH", source)
    private var index = 0
    private var lastSize = if (version == 3) SIZE_3 else HEAD
    private var next = 0

    /** The number of records that were dropped because they are impossible. */
    var badCount = 0
        private set

    override fun sizeAt(bytes: ByteArray, at: Int, until: Int, isEnd: Boolean): Int {
        if (version == 3) return if (until - at < SIZE_3) MORE else SIZE_3
        if (until - at < HEAD) return MORE
        if (!isPossible(bytes, at)) return NONE
        val power = wordAt(bytes, at + POWER_SIZE)
        val end = at + HEAD + power
        return when {
            end > until -> MORE

            isKnown(power) -> HEAD + power

            // The bytes after an unknown block show whether it is one.
            until - end < HEAD -> if (isEnd) HEAD + power else MORE

            isPossible(bytes, end) -> HEAD + power

            else -> NONE
        }
    }

    override fun isSure(bytes: ByteArray, at: Int): Boolean {
        val status = bytes[at + STATUS].toInt().inv()
        val power = wordAt(bytes, at + POWER_SIZE)
        return (isKnown(power) || HEAD + power == lastSize) && isOneMode(status) && isOneMode(status shr DS_MODE)
    }

    // All modes at once mean a hole of zeros.
    private fun isPossible(bytes: ByteArray, at: Int) = bytes[at + STATUS].toInt() != 0 && wordAt(bytes, at + POWER_SIZE) in 0..MAX_POWER

    private fun isKnown(power: Int) = power == 0 || power == PDP_SIZE || power == PDH_SIZE

    private fun isOneMode(status: Int) = (status and MODES).countOneBits() < 2

    override fun take(bytes: ByteArray, at: Int, size: Int) {
        lastSize = size
        val time = index++ * SECONDS
        timestamps.add(time)
        next = 0
        val status = bytes[at + STATUS].toInt().inv()
        if (status and 0xFF == 0xFF) {
            badCount++
            return miss(time)
        }
        val trip = byteAt(bytes, at)
        val volts = shortAt(bytes, at + 2)
        val isMeasured = volts <= MAX_VOLTS
        number(if (isMeasured) volts / 256.0 else Double.NaN)
        number(if (isMeasured) byteAt(bytes, at + 4) / 2.0 else Double.NaN)
        number(if (isMeasured) byteAt(bytes, at + 6) / 2.0 else Double.NaN)
        number(if (trip == NO_TRIP) Double.NaN else trip / 2.0)
        // A few percent below 0 mean 0.
        number((bytes[at + 1] * 4.0).coerceIn(0.0, 100.0))
        val hasLink = isMeasured && trip != NO_TRIP
        truth(hasLink)
        truth(status and DS_DISABLED == 0 && status and DS_ENABLED != 0)
        text(modeOf(status shr DS_MODE) ?: OTHER)
        text(modeOf(status) ?: if (hasLink) NO_CODE else NO_LINK)
        truth(status and BROWNOUT != 0)
        truth(status and WATCHDOG != 0)
        val power = if (version == 3) HEAD_3 else HEAD
        pdp.take(time, bytes, at + power, size - power == PDP_SIZE)
        pdh.take(time, bytes, at + power, size - power == PDH_SIZE)
    }

    override fun skip(bytes: Int): Int {
        val count = (bytes + lastSize / 2) / lastSize
        if (count > 0) {
            val time = index * SECONDS
            timestamps.add(time)
            miss(time)
            index += count
        }
        return count
    }

    private fun miss(time: Double) {
        for (column in columns) column.addGap()
        pdp.miss(time)
        pdh.miss(time)
    }

    private fun number(number: Double) = columns[next++].run { if (number.isNaN()) addGap() else addNumber(number) }

    private fun truth(isTrue: Boolean) = columns[next++].addTruth(isTrue)

    private fun text(text: ByteArray) = columns[next++].addText(text, 0, text.size)

    private fun modeOf(status: Int): ByteArray? = when {
        status and 1 != 0 -> DISABLED
        status and 2 != 0 -> AUTONOMOUS
        status and 4 != 0 -> TELEOP
        else -> null
    }

    /** Passes each column with its unit and its attributes to [add]. */
    fun topics(add: (SampleColumn, String, List<String>, Timestamps) -> Unit) {
        columns.forEachIndexed { i, column -> add(column, RECORD_TOPICS[i].second, emptyList(), timestamps) }
        pdp.topics(add)
        pdh.topics(add)
    }

    private companion object {
        const val SECONDS = 0.02
        const val HEAD_3 = 10
        const val HEAD = 14
        const val SIZE_3 = 35
        const val STATUS = 5
        const val POWER_SIZE = 10
        const val PDP_SIZE = 25
        const val PDH_SIZE = 33
        const val MAX_POWER = 4096
        const val NO_TRIP = 255

        /** 20 V: no robot's battery has more. If the robot does not answer, the Driver Station writes 255.996 V or another large value. */
        const val MAX_VOLTS = 20 * 256

        // The bits of the status, which are inverted.
        const val MODES = 7
        const val DS_MODE = 3
        const val DS_DISABLED = 0x08
        const val DS_ENABLED = 0x30
        const val WATCHDOG = 0x40
        const val BROWNOUT = 0x80

        /** The names and units, in the order in which [take] fills them. */
        val RECORD_TOPICS = listOf(
            "Battery Voltage" to "V",
            "CPU Utilization" to "%",
            "CAN Utilization" to "%",
            "Trip Time" to "ms",
            "Packet Loss" to "%",
            "Comms Connected" to "",
            "Enabled" to "",
            "DS Mode" to "",
            "Robot Mode" to "",
            "Brownout" to "",
            "Watchdog" to "",
        ).map { (name, unit) -> "$FOLDER$name" to unit }

        val DISABLED = "Disabled".encodeToByteArray()
        val AUTONOMOUS = "Autonomous".encodeToByteArray()
        val TELEOP = "Teleop".encodeToByteArray()
        val OTHER = "Other".encodeToByteArray()
        val NO_CODE = "No Robot Code".encodeToByteArray()
        val NO_LINK = "No Robot Communication".encodeToByteArray()
    }
}

/** The folder of the topics that every Driver Station has. */
internal const val FOLDER = "Driver Station/"
