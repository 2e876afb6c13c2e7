package badlog.formats.revlog

import badlog.core.bag.RecordingParser
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.TopicKind
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.parseLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll

/** A `.revlog` byte by byte; knows nothing of the code that is tested. */
private class TestRevlog {
    var bytes = ByteArray(0)
        private set

    fun record(kind: Int, vararg frames: ByteArray) = apply {
        val payload = frames.fold(ByteArray(0), ByteArray::plus)
        // One byte for the kind, two for the size.
        bytes += byteArrayOf(0b0100, kind.toByte(), payload.size.toByte(), (payload.size shr 8).toByte()) + payload
    }

    fun raw(vararg more: Byte) = apply { bytes += more }
}

private fun words(vararg parts: Number): ByteArray = parts.fold(ByteArray(0)) { bytes, part ->
    bytes + ByteArray(if (part is Int) 4 else 8) { (part.toLong() shr 8 * it).toByte() }
}

private fun can(type: Int, frame: Int, device: Int) = (type shl 24) or (5 shl 16) or (46 shl 10) or (frame shl 6) or device

private fun status(millis: Int, type: Int, frame: Int, device: Int, bits: Long): ByteArray = words(millis, can(type, frame, device)) + ByteArray(8) { (bits shr 8 * it).toByte() }

private fun firmware(type: Int, device: Int, vararg bytes: Byte) = words((type shl 24) or (5 shl 16) or device) + bytes

private fun convert(bytes: ByteArray, piece: Int = maxOf(1, bytes.size)): Pair<Recording, List<Problem>> {
    var wpilog = ByteArray(0)
    val conversion = RevlogConversion { made, size -> wpilog += made.copyOf(size) }
    for (at in bytes.indices step piece) conversion.accept(bytes, at, minOf(bytes.size, at + piece))
    val problems = conversion.finish()
    return parseLog(wpilog) to problems
}

private fun Recording.first(topic: String) = topics.single { it.name == topic }.samples.first()

private fun read(bytes: ByteArray) = RecordingParser(LOG_FORMATS, bytes.size.toLong()).apply { accept(bytes) }.finish()

internal class RevlogFormatSpec : FunSpec({
    // Output -0.5, 12 V, 40 A, 35 °C, the forward limit switch. The bits are where REV's description of STATUS_0 places them.
    val output = (-16221L) and 0xFFFF
    val spark = output or (1638L shl 16) or (1092L shl 28) or (35L shl 40) or (1L shl 48)

    test("the values of a Spark become topics with units, and its firmware a value") {
        val log = TestRevlog().record(1, firmware(2, 3, 26, 1, 0, 4, 0, 0)).record(2, status(1500, 2, 0, 3, spark), status(1520, 2, 0, 3, spark)).bytes
        val (recording, problems) = convert(log)
        problems shouldBe emptyList()
        recording.values.map { it.name to it.text } shouldContainExactly listOf("REV/Spark-3/FIRMWARE" to "26.1.4")
        recording.first("REV/Spark-3/APPLIED_OUTPUT") shouldBe (-0.5 plusOrMinus 1e-4)
        recording.first("REV/Spark-3/VOLTAGE") shouldBe (12.0 plusOrMinus 1e-3)
        recording.first("REV/Spark-3/CURRENT") shouldBe (40.0 plusOrMinus 1e-3)
        recording.topics.single { it.name == "REV/Spark-3/MOTOR_TEMPERATURE" }.run { unit to samples.first() } shouldBe ("°C" to 35.0)
        recording.topics.single { it.name == "REV/Spark-3/HARD_FORWARD_LIMIT_REACHED" }.run {
            kind shouldBe TopicKind.BOOLEAN
            samples.toList() shouldBe listOf(1.0, 1.0)
            times?.toList() shouldBe listOf(1.5, 1.52)
        }
    }

    test("encoders, faults and servo hubs are read as REV describes them") {
        val velocity = (1234.5f.toRawBits().toLong() and 0xFFFFFFFF) or ((-2.25f).toRawBits().toLong() shl 32)
        val (recording) = convert(
            TestRevlog().record(
                2,
                status(0, 2, 2, 1, velocity),
                status(0, 2, 1, 1, (1L shl 3) or (1L shl 17) or (1L shl 48)),
                status(0, 12, 4, 9, 500L shl 50),
                status(0, 12, 2, 9, 1500L shl 16 or (1L shl 49)),
                status(0, 7, 2, 4, velocity),
                status(0, 7, 4, 4, velocity),
            ).bytes,
        )
        recording.first("REV/Spark-1/PRIMARY_ENCODER_VELOCITY") shouldBe 1234.5
        recording.first("REV/Spark-1/PRIMARY_ENCODER_POSITION") shouldBe -2.25
        recording.first("REV/Spark-1/FAULT/CAN_FAULT") shouldBe 1.0
        recording.first("REV/Spark-1/WARNING/OVERCURRENT_WARNING") shouldBe 1.0
        recording.first("REV/Spark-1/FAULT/DRV_FAULT") shouldBe 0.0
        recording.first("REV/Spark-1/IS_FOLLOWER") shouldBe 1.0
        recording.first("REV/ServoHub-9/CHANNEL_5_CURRENT") shouldBe (5.0 plusOrMinus 1e-9)
        recording.first("REV/ServoHub-9/CHANNEL_1_PULSE_WIDTH") shouldBe 1500.0
        recording.first("REV/ServoHub-9/CHANNEL_1_ENABLED") shouldBe 1.0
        recording.first("REV/Encoder-4/ANGLE") shouldBe -2.25
        recording.first("REV/Encoder-4/VELOCITY") shouldBe -2.25
    }

    test("frames of other kinds and of unknown devices are left out") {
        val other = words(0, can(2, 0, 3) and (0x3F shl 10).inv() or (5 shl 10), 0, 0)
        val (recording, problems) = convert(TestRevlog().record(2, other, status(0, 2, 15, 3, 0), status(0, 30, 0, 3, 0)).bytes)
        problems shouldBe emptyList()
        recording.topics shouldBe emptyList()
    }

    test("after damaged bytes the next record is found, and the problem reports the place") {
        val whole = TestRevlog().record(2, status(10, 2, 0, 3, spark)).raw(9, 9, 9, 9, 9).record(2, status(20, 2, 0, 3, spark)).bytes
        val (recording, problems) = convert(whole)
        recording.topics.first().times?.toList() shouldBe listOf(0.01, 0.02)
        problems.single().run { kind to loss.bytes } shouldBe (ProblemKind.RECORDS_SKIPPED to 5L)
    }

    test("of a file that was cut, all whole records are read") {
        val whole = TestRevlog().record(2, status(10, 2, 0, 3, spark)).record(2, status(20, 2, 0, 3, spark)).bytes
        val (recording, problems) = convert(whole.copyOf(whole.size - 3))
        recording.topics.first().times?.toList() shouldBe listOf(0.01)
        problems.single().run { kind to loss.bytes } shouldBe (ProblemKind.RECORD_CUT to 17L)
    }

    test("any bytes, in pieces of any size, give the same result, and a WPILOG without faults") {
        val log = TestRevlog().record(2, status(10, 2, 0, 3, spark)).record(1, firmware(2, 3, 26, 1, 0, 4, 0, 0)).record(2, status(20, 2, 0, 3, spark)).bytes
        checkAll(Arb.byteArray(Arb.int(0..8), Arb.byte()), Arb.int(0..log.size), Arb.int(1..40)) { damage, at, piece ->
            val bytes = log.copyOf(at) + damage + log.copyOfRange(minOf(log.size, at + damage.size / 2), log.size)
            val (recording, problems) = convert(bytes)
            val (again, problemsAgain) = convert(bytes, piece)
            again.topics.map { it.name to it.samples.toList() } shouldBe recording.topics.map { it.name to it.samples.toList() }
            problemsAgain shouldBe problems
            (recording.problems.map { it.kind } - ProblemKind.NO_ROWS) shouldBe emptyList()
        }
    }

    test("a REV log is recognized by its content, and no text, bag, WPILOG or Driver Station log is taken for one") {
        val log = TestRevlog().record(2, status(10, 2, 0, 3, spark)).bytes
        val whole = read(log + log.copyOf(7))
        whole.format shouldBe RevlogFormat
        whole.topics.any { it.name == "REV/Spark-3/CURRENT" } shouldBe true
        whole.problems.map { it.kind } shouldContainExactly listOf(ProblemKind.RECORD_CUT)
        for (other in listOf("{\"topics\":[]}", "Time,A\n0,1\n", "WPILOG\u0000\u0001", "\u0000\u0000\u0000\u0004\u0000\u0000\u0000\u0000", "", "\u0000")) {
            RevlogFormat.matches(other.encodeToByteArray(), other.length) shouldBe false
        }
    }
})
