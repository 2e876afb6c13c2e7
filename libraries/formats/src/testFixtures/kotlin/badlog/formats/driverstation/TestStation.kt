package badlog.formats.driverstation

import badlog.core.recording.Recording

/** 2026-03-07 15:04:05.5 UTC, in s since 1904. */
internal const val STATION_START = 3_855_740_645L

/** The state of the robot and of the Driver Station in a record: the bits that are low. */
internal object Status {
    const val BOTH_DISABLED = 0xF6
    const val BOTH_AUTO = 0xED
    const val BOTH_TELEOP = 0xDB
    const val ONLY_DS_TELEOP = 0xDF
    const val BROWNOUT_IN_TELEOP = 0x5B
}

/** Writes a `.dslog` for tests, byte by byte by the format, independently of the code under test. */
internal class TestDslog(private val version: Int = 4, start: Long = STATION_START) {
    private val out = ArrayList<Byte>()

    val bytes: ByteArray get() = out.toByteArray()

    init {
        out += header(version, start).asList()
    }

    fun record(
        status: Int = Status.BOTH_DISABLED,
        volts: Double = 12.5,
        trip: Int = 12,
        loss: Int = 0,
        cpu: Int = 80,
        can: Int = 60,
        power: ByteArray = if (version == 3) pdp() else ByteArray(0),
    ): TestDslog {
        val raw = if (volts.isNaN()) 0xFFFF else (volts * 256).toInt()
        out += byteArrayOf(trip.toByte(), loss.toByte()).asList() + big(raw.toLong(), 2).asList()
        out += byteArrayOf(cpu.toByte(), status.toByte(), can.toByte(), 0, 0, 0).asList()
        if (version > 3) out += big(power.size.toLong(), 4).asList()
        out += power.asList()
        return this
    }

    fun records(count: Int, status: Int = Status.BOTH_DISABLED, power: (Int) -> ByteArray = { if (version == 3) pdp() else ByteArray(0) }): TestDslog {
        repeat(count) { record(status, volts = 12.0 + it % 8 / 256.0, power = power(it)) }
        return this
    }
}

/** Writes a `.dsevents`. */
internal class TestDsevents(private val start: Long = STATION_START, version: Int = 4) {
    private val out = ArrayList<Byte>()

    val bytes: ByteArray get() = out.toByteArray()

    init {
        out += header(version, start).asList()
    }

    /** Returns an entry [millis] after the start of the file. */
    fun entry(millis: Long, text: String): TestDsevents = entry(millis, text.encodeToByteArray())

    fun entry(millis: Long, text: ByteArray): TestDsevents {
        val all = millis + 500
        out += big(start + all.floorDiv(1000L), 8).asList()
        out += (big(all.mod(1000L) * 4_294_967L, 4) + ByteArray(4)).asList() + big(text.size.toLong(), 4).asList()
        out += text.asList()
        return this
    }
}

private fun header(version: Int, start: Long) = big(version.toLong(), 4) + big(start, 8) + big(0x80000000L, 4) + ByteArray(4)

internal fun big(value: Long, width: Int): ByteArray = ByteArray(width) { (value ushr 8 * (width - 1 - it)).toByte() }

/** Returns the block of a PDP with `raw(i)` eighths of an ampere in channel `i`, bit by bit. */
internal fun pdp(voltage: Int = 164, temperature: Int = 88, raw: (Int) -> Int = { it }): ByteArray {
    val block = ByteArray(25)
    for (channel in 0 until 16) {
        for (bit in 0 until 10) {
            val at = channel / 6 * 64 + channel % 6 * 10 + bit
            if (raw(channel) shr (9 - bit) and 1 == 1) block[1 + at / 8] = (block[1 + at / 8].toInt() or (0x80 shr at % 8)).toByte()
        }
    }
    block[22] = -1
    block[23] = voltage.toByte()
    block[24] = temperature.toByte()
    return block
}

/** Returns the block of a PDH with `raw(i)` in channel `i`: eighths of an ampere, sixteenths from channel 20 on. */
internal fun pdh(raw: (Int) -> Int = { it }): ByteArray {
    val block = ByteArray(33)
    block[0] = 1
    for (channel in 0 until 20) {
        for (bit in 0 until 10) {
            val at = channel / 3 * 32 + channel % 3 * 10 + bit
            if (raw(channel) shr bit and 1 == 1) block[1 + at / 8] = (block[1 + at / 8].toInt() or (1 shl at % 8)).toByte()
        }
    }
    for (channel in 20 until 24) block[8 + channel] = raw(channel).toByte()
    return block
}

/** Reads [bytes] as one file that arrives in pieces of [piece] bytes. */
internal fun parseStation(bytes: ByteArray, piece: Int = maxOf(1, bytes.size), keepSamples: Boolean = true): Recording {
    val parser = DriverStationParser(keepSamples)
    for (at in bytes.indices step piece) parser.accept(bytes, at, minOf(at + piece, bytes.size))
    return parser.finish()
}

/** A short match: disabled, autonomous, teleop with a brownout and a loss of the link. It has a PDP from the second on. */
internal val STATION_LOG: TestDslog
    get() = TestDslog()
        .record(Status.BOTH_DISABLED or 7, volts = Double.NaN, trip = 255, loss = 26, cpu = 0, can = 0)
        .records(20) { pdp() }
        .records(30, Status.BOTH_AUTO) { pdp { channel -> 8 * channel + it } }
        .records(20, Status.BOTH_DISABLED) { pdp() }
        .records(40, Status.BOTH_TELEOP) { pdp { channel -> 16 * channel + it } }
        .record(Status.BROWNOUT_IN_TELEOP, volts = 6.5, loss = -2, power = pdp { 1023 })
        .records(3, Status.ONLY_DS_TELEOP) { pdp() }
        .record(Status.ONLY_DS_TELEOP, volts = Double.NaN, trip = 255, loss = 25)
        .records(10, Status.BOTH_TELEOP) { pdp() }

/** The messages of that match. */
internal val STATION_EVENTS: TestDsevents
    get() = TestDsevents()
        .entry(100, "FMS Connected:   Qualification - 42:1, Field Time: 26/3/7 10:4:5\n FMS Event Name: MILLC ")
        .entry(
            400,
            "<TagVersion>1 <time> 05.250 <message> ready <TagVersion>1 <time> 05.249 <message>  <TagVersion>1 <time> 05.248 <message> \tfirst ",
        )
        .entry(
            900,
            "Info Joystick 0: (Xbox)6 axes. Warning Rail Faults: 5V - 1. <TagVersion>1 <time> 05.900 <count> 1 <flags> 1 <Code> -200 " +
                "<details> CTR: No response <location> Talon FX 63 <stack> \tat one\n\tat two\n",
        )
        .entry(1100, "Info roboRIO: Disk Free 84 MB, Memory Free 58 MB. DS Laptop: CPU 89% Batt 100%. ")
        .entry(2200, "<TagVersion>1 <time> 07.1 <count> 1 <flags> 0 <Code> 1 <details> Loop time of 0.02s overrun\n <location>  <stack> ")
