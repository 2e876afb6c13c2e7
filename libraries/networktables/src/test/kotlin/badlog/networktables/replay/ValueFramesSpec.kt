package badlog.networktables.replay

import badlog.core.analysis.Series
import badlog.networktables.TopicType
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import org.msgpack.core.MessageInsufficientBufferException
import org.msgpack.core.MessagePackException
import java.nio.ByteBuffer
import java.util.HexFormat

private val HEX = HexFormat.of()

private fun ByteBuffer.hex() = HEX.formatHex(array())

private fun bytes(hex: String) = ByteBuffer.wrap(HEX.parseHex(hex.replace(" ", "")))

private fun frame(type: TopicType, value: Double, vararg texts: String, micros: Long = 120_000_000): String {
    val signal = ReplayedTopic("/A", type, "", Series(doubleArrayOf(0.0), doubleArrayOf(value)), texts.map { it.encodeToByteArray() })
    return ValueFrames(listOf(signal)).of(listOf(Update(0, 0, micros))).single().hex()
}

class ValueFramesSpec : FunSpec({
    test("values are arrays of number, time, type and value") {
        frame(TopicType.DOUBLE, 0.1234) shouldBe "9400ce07270e0001cb3fbf972474538ef3"
        frame(TopicType.BOOLEAN, 1.0, micros = 1) shouldBe "94000100c3"
        frame(TopicType.BOOLEAN, 0.0, micros = 1) shouldBe "94000100c2"
        frame(TopicType.STRING, 1.0, "no", "é", micros = 1) shouldBe "94000104a2c3a9"
    }

    test("logged values are sent unchanged, with NetworkTables types") {
        fun frame(type: String, vararg bytes: Int): String {
            val payload = ByteArray(bytes.size) { bytes[it].toByte() }
            val topic = LoggedTopic("A", type, "", doubleArrayOf(0.0)) { payload }
            val signal = signalsOf(viewOf("A\n1\n"), "", listOf(topic)).first()
            return signal.typeName + " " + ValueFrames(listOf(signal)).of(listOf(Update(0, 0, 1))).single().hex().removePrefix("940001")
        }
        frame("boolean", 1) shouldBe "boolean 00c3"
        frame("int64", 1, 0, 0, 0, 0, 0, 32, 0) shouldBe "int 02cf0020000000000001"
        frame("float", 0, 0, 0x80, 0x3f) shouldBe "float 03ca3f800000"
        frame("double", 0, 0, 0, 0, 0, 0, 0xf0, 0x3f) shouldBe "double 01cb3ff0000000000000"
        frame("string", 0x61, 0x62) shouldBe "string 04a26162"
        frame("json", 0x7b, 0x7d) shouldBe "json 04a27b7d"
        frame("raw", 1, 2, 3) shouldBe "raw 05c403010203"
        frame("struct:Pose2d", 1, 2) shouldBe "struct:Pose2d 05c4020102"
        frame("structschema", 0x78) shouldBe "structschema 05c40178"
        frame("boolean[]", 1, 0) shouldBe "boolean[] 1092c3c2"
        frame("double[]") shouldBe "double[] 1190"
        frame("int64[]", 5, 0, 0, 0, 0, 0, 0, 0) shouldBe "int[] 129105"
        frame("float[]", 0, 0, 0x80, 0x3f) shouldBe "float[] 1391ca3f800000"
        frame("string[]", 2, 0, 0, 0, 1, 0, 0, 0, 0x61, 0, 0, 0, 0) shouldBe "string[] 1492a161a0"
    }

    test("many values are sent in order, in frames about as long as a packet") {
        val signal = ReplayedTopic("/A", TopicType.DOUBLE, "", Series(DoubleArray(1000), DoubleArray(1000) { it.toDouble() }))
        val frames = ValueFrames(listOf(signal)).of(List(1000) { Update(0, it, it.toLong()) })
        frames.all { it.remaining() in 10..1300 } shouldBe true
        frames.sumOf { it.remaining() } shouldBe 1000 * 12 + (0 until 1000).sumOf {
            if (it < 128) {
                1
            } else if (it < 256) {
                2
            } else {
                3L
            }
        }
    }

    test("a request for the time is answered with its own time and the server's") {
        answerTime(bytes("94 ff 00 02 d2 00 01 02 03"), 5)!!.hex() shouldBe "94ff0502ce00010203".replace("ce00010203", "ce00010203")
        answerTime(bytes("94 ff 00 01 cb 3fbf972474538ef3"), 5)!!.hex() shouldBe "94ff0501cb3fbf972474538ef3"
        answerTime(bytes("94 ff 00 02 cf ffffffffffffffff"), 5)!!.hex() shouldBe "94ff0502cfffffffffffffffff"
    }

    test("values of a client are ignored") {
        answerTime(bytes("94 01 00 10 93 c2 c3 c2"), 5) shouldBe null
        answerTime(bytes("94 01 00 04 a1 41  94 ff 00 02 01"), 5)!!.hex() shouldBe "94ff050201"
        answerTime(bytes(""), 5) shouldBe null
    }

    test("a frame that is not one of NT4 is refused") {
        shouldThrow<MessagePackException> { answerTime(bytes("93 ff 00 02"), 5) }
        shouldThrow<MessageInsufficientBufferException> { answerTime(bytes("94 ff 00"), 5) }
        shouldThrow<MessagePackException> { answerTime(bytes("c1"), 5) }
    }

    test("any bytes are answered, ignored or refused, without another exception") {
        checkAll(Arb.byteArray(Arb.int(0..40), Arb.byte())) { random ->
            for (start in listOf("", "94", "94ff0002")) {
                try {
                    answerTime(ByteBuffer.wrap(HEX.parseHex(start) + random), 5)
                } catch (_: MessagePackException) {
                    // SocketServer expects this exception.
                }
            }
        }
        // Arrays within arrays, ten thousand deep.
        shouldThrow<MessagePackException> { answerTime(bytes("94 ff 00 02" + "91".repeat(10_000)), 5) }
    }
})
