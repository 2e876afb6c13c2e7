package badlog.formats.wpilog

import badlog.core.recording.Recording

/** Writes a WPILOG for tests, byte by byte by the format, independently of the code under test. */
internal class TestLog(extraHeader: String = "") {
    private val out = ArrayList<Byte>()

    val bytes: ByteArray get() = out.toByteArray()

    init {
        out += "WPILOG".encodeToByteArray().asList()
        out += listOf<Byte>(0, 1)
        out += text(extraHeader).asList()
    }

    fun start(id: Int, name: String, type: String, metadata: String = "", at: Long = 0): TestLog = record(0, at, byteArrayOf(0) + number(id.toLong(), 4) + text(name) + text(type) + text(metadata))

    fun finish(id: Int, at: Long = 0): TestLog = record(0, at, byteArrayOf(1) + number(id.toLong(), 4))

    fun metadata(id: Int, metadata: String, at: Long = 0): TestLog = record(0, at, byteArrayOf(2) + number(id.toLong(), 4) + text(metadata))

    fun record(id: Int, micros: Long, payload: ByteArray): TestLog {
        val idSize = sizeOf(id.toUInt().toLong(), 4)
        val sizeSize = sizeOf(payload.size.toLong(), 4)
        val timeSize = sizeOf(micros, 8)
        out += (idSize - 1 or (sizeSize - 1 shl 2) or (timeSize - 1 shl 4)).toByte()
        out += number(id.toLong(), idSize).asList()
        out += number(payload.size.toLong(), sizeSize).asList()
        out += number(micros, timeSize).asList()
        out += payload.asList()
        return this
    }

    fun double(id: Int, micros: Long, value: Double): TestLog = record(id, micros, doubles(value))

    fun string(id: Int, micros: Long, value: String): TestLog = record(id, micros, value.encodeToByteArray())

    fun raw(vararg bytes: Int): TestLog {
        for (byte in bytes) out += byte.toByte()
        return this
    }

    private fun sizeOf(value: Long, most: Int) = (1..most).first { it == 8 || value ushr 8 * it == 0L }
}

internal fun number(value: Long, width: Int): ByteArray = ByteArray(width) { (value ushr 8 * it).toByte() }

internal fun doubles(vararg values: Double): ByteArray = values.fold(ByteArray(0)) { bytes, value -> bytes + number(value.toRawBits(), 8) }

internal fun floats(vararg values: Float): ByteArray = values.fold(ByteArray(0)) { bytes, value -> bytes + number(value.toRawBits().toLong(), 4) }

internal fun longs(vararg values: Long): ByteArray = values.fold(ByteArray(0)) { bytes, value -> bytes + number(value, 8) }

/** Returns a text with its length before it. */
internal fun text(text: String): ByteArray = text.encodeToByteArray().let { number(it.size.toLong(), 4) + it }

/** Reads [bytes] as one file that arrives in pieces of [piece] bytes. */
internal fun parseLog(bytes: ByteArray, piece: Int = maxOf(1, bytes.size), keepSamples: Boolean = true): Recording {
    val parser = WpilogParser(keepSamples)
    for (at in bytes.indices step piece) parser.accept(bytes, at, minOf(at + piece, bytes.size))
    return parser.finish()
}

/** The whole content of a recording, as text. */
internal fun describeLog(recording: Recording): String = buildString {
    appendLine("${recording.format.id} ${recording.sampleCount}")
    for (value in recording.values) appendLine("value ${value.name}=${value.text}")
    for (topic in recording.topics) {
        val texts = List(topic.texts.size) { "${topic.texts.rows[it]}:${topic.texts[it]}" }
        appendLine("topic ${topic.name} ${topic.unit} ${topic.attributes} ${topic.kind} ${topic.counts} ${topic.type}")
        appendLine("  ${topic.metadata} ${topic.times?.toList()} ${topic.samples.toList()} $texts")
    }
    for (problem in recording.problems) appendLine(problem)
}

/** A log with a bit of everything. */
internal val VARIED_LOG: TestLog
    get() = TestLog("{\"from\":\"a test\"}")
        .start(1, "/Arm/Angle", "double", "{\"unit\":\"deg\"}", 10)
        .start(2, "DS:enabled", "boolean")
        .start(3, "messages", "string")
        .start(4, "/Pose", "struct:Pose2d")
        .start(5, "axes", "float[]")
        .start(6, "names", "string[]")
        .start(7, "/.schema/struct:Pose2d", "structschema")
        .start(8, "/.schema/struct:Rotation2d", "structschema")
        .start(9, "photo", "raw")
        .start(10, "systemTime", "int64", "{\"source\":\"DataLogManager\"}")
        .double(1, 20_000, 1.5)
        .record(2, 20_000, byteArrayOf(0))
        .record(4, 30_000, doubles(1.0, 2.0, 0.5))
        .string(7, 30_000, "double x;double y;Rotation2d rotation")
        .string(8, 30_000, "double value")
        .record(5, 40_000, floats(0.5f, -0.5f))
        .record(5, 60_000, floats(0.25f))
        .record(6, 40_000, number(2, 4) + text("a") + text("Ω"))
        .record(4, 50_000, doubles(1.5, 2.5, 0.75))
        .string(3, 50_000, "ready, \"steady\"\ngo")
        .double(1, 70_000, Double.NaN)
        .double(1, 65_000, 3.0)
        .double(1, -5_000_000, 3.0)
        .record(9, 70_000, byteArrayOf(1, 2, 3))
        .record(10, 80_000, longs(1_700_000_000_000_000))
        .record(2, 1_000_000, byteArrayOf(1))
        .finish(1, 1_100_000)
        .metadata(2, "{\"x\":1}", 1_100_000)
        .record(77, 1_200_000, byteArrayOf(1))
        .double(3, 1_300_000, 1.0)
