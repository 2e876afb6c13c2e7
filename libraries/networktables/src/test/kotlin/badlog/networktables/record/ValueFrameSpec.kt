package badlog.networktables.record

import badlog.networktables.TopicType
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import org.msgpack.core.MessageBufferPacker

/** Collects the content of a frame; every topic has [type]. */
private class FrameContent(private val type: TopicType?) : ValueSink {
    val values = ArrayList<Triple<Long, Long, List<Byte>>>()
    val times = ArrayList<Pair<Long, Long>>()
    val ignored = ArrayList<String>()

    override fun typeOf(id: Long) = type

    override fun value(id: Long, micros: Long, payload: ByteArray) {
        values += Triple(id, micros, payload.toList())
    }

    override fun time(serverMicros: Long, sentMicros: Long) {
        times += serverMicros to sentMicros
    }

    override fun ignored(what: String) {
        ignored += what
    }
}

private fun found(type: TopicType?, vararg frames: ByteArray) = FrameContent(type).also { readValues(frames.fold(ByteArray(0), ByteArray::plus), it) }

private fun payloadOf(type: TopicType, pack: MessageBufferPacker.() -> Unit): List<Int>? = found(type, frameOf(7, type.code, 9, pack)).values.singleOrNull()?.third?.map { it.toInt() }

class ValueFrameSpec : FunSpec({
    test("values of every type become values of a WPILOG") {
        payloadOf(TopicType.BOOLEAN) { packBoolean(true) } shouldBe listOf(1)
        payloadOf(TopicType.DOUBLE) { packDouble(1.0) } shouldBe listOf(0, 0, 0, 0, 0, 0, -16, 63)
        payloadOf(TopicType.DOUBLE) { packInt(1) } shouldBe listOf(0, 0, 0, 0, 0, 0, -16, 63)
        payloadOf(TopicType.FLOAT) { packFloat(1f) } shouldBe listOf(0, 0, -128, 63)
        payloadOf(TopicType.INT) { packLong(-2) } shouldBe listOf(-2, -1, -1, -1, -1, -1, -1, -1)
        payloadOf(TopicType.STRING) { packString("aß") } shouldBe listOf(97, -61, -97)
        payloadOf(TopicType.RAW) { packBinaryHeader(2).writePayload(byteArrayOf(1, 2)) } shouldBe listOf(1, 2)
        payloadOf(TopicType.BOOLEANS) { packArrayHeader(2).packBoolean(true).packBoolean(false) } shouldBe listOf(1, 0)
        payloadOf(TopicType.INTS) { packArrayHeader(1).packInt(3) } shouldBe listOf(3, 0, 0, 0, 0, 0, 0, 0)
        payloadOf(TopicType.FLOATS) { packArrayHeader(1).packFloat(1f) } shouldBe listOf(0, 0, -128, 63)
        payloadOf(TopicType.DOUBLES) { packArrayHeader(1).packDouble(1.0) } shouldBe listOf(0, 0, 0, 0, 0, 0, -16, 63)
        payloadOf(TopicType.STRINGS) { packArrayHeader(2).packString("a").packString("") } shouldBe
            listOf(2, 0, 0, 0, 1, 0, 0, 0, 97, 0, 0, 0, 0)
    }

    test("numbers, ids and times are exact to the last bit") {
        checkAll(Arb.int(0..Int.MAX_VALUE), Arb.long(), Arb.double()) { id, micros, number ->
            val found = found(TopicType.DOUBLE, frameOf(id, 1, micros) { packDouble(number) })
            val bits = number.toRawBits()
            found.values shouldBe listOf(Triple(id.toLong(), micros, List(8) { (bits ushr 8 * it).toByte() }))
        }
    }

    test("the server's time is not a value, and values of topics that are not recorded are skipped") {
        val time = frameOf(-1, 2, 77) { packLong(5) }
        val odd = frameOf(-1, 1, 77) { packString("x") }
        val value = frameOf(3, 1, 9) { packDouble(1.0) }
        found(TopicType.DOUBLE, time, odd, value).run {
            times shouldBe listOf(77L to 5L)
            values.size shouldBe 1
        }
        found(null, value, time, value).run {
            times.size shouldBe 1
            values.size shouldBe 0
            ignored.size shouldBe 0
        }
    }

    test("a value with another type than its topic is left out, and the next one is read") {
        val wrong = frameOf(3, 4, 9) { packString("x") }
        val right = frameOf(3, 1, 9) { packDouble(1.0) }
        found(TopicType.DOUBLE, wrong, right).run {
            values.size shouldBe 1
            ignored shouldBe listOf("a value of another type than its topic")
        }
        for (type in TopicType.entries) {
            found(type, frameOf(3, type.code, 9) { packMapHeader(1).packNil().packNil() }).run {
                values.size shouldBe 0
                ignored.size shouldBe 1
            }
        }
    }

    test("the announced size of an array or text allocates no memory") {
        for (type in listOf(TopicType.DOUBLES, TopicType.STRINGS, TopicType.BOOLEANS, TopicType.INTS)) {
            payloadOf(type) { packArrayHeader(Int.MAX_VALUE) } shouldBe null
        }
        payloadOf(TopicType.STRING) { packRawStringHeader(Int.MAX_VALUE) } shouldBe null
        payloadOf(TopicType.RAW) { packBinaryHeader(Int.MAX_VALUE) } shouldBe null
        payloadOf(TopicType.STRINGS) { packArrayHeader(1).packRawStringHeader(Int.MAX_VALUE) } shouldBe null
        // Eight times as long in a WPILOG, and too long for a reader.
        payloadOf(TopicType.INTS) { packArrayHeader(3_000_000).apply { repeat(3_000_000) { packInt(1) } } } shouldBe null
    }

    test("any bytes are read without an exception, and ignored values are reported") {
        checkAll(Arb.byteArray(Arb.int(0..200), Arb.byte()), Arb.enum<TopicType>()) { bytes, type ->
            found(type, bytes)
            countValues(bytes)
        }
        // So that more of each frame is valid.
        checkAll(Arb.byteArray(Arb.int(0..60), Arb.byte()), Arb.enum<TopicType>()) { bytes, type ->
            val broken = found(type, frameOf(1, type.code, 2) {}, bytes)
            (broken.values.size + broken.ignored.size >= 1) shouldBe true
        }
    }

    test("dropped frames are counted by their values") {
        val value = frameOf(3, 1, 9) { packDouble(1.0) }
        countValues(ByteArray(0)) shouldBe 0
        countValues(value + value + value) shouldBe 3
        countValues(value + value.copyOf(value.size - 1)) shouldBe 1
        val inbox = Inbox(1000)
        FakeLinks().use { links ->
            repeat(100) { inbox.add(Incoming.Values(links.link, value + value, 0)) }
            inbox.dropped shouldBe 2 * (100 - generateSequence { inbox.next(0) }.count())
            inbox.add(Incoming.Values(links.link, value, 0)) shouldBe true
        }
    }
})

/** A link that is not connected. */
private class FakeLinks : AutoCloseable {
    private val inbox = Inbox(1)
    val link = Link(Source(RecordedServer("robot", "NT:") { null }, true), ServerAddress("127.0.0.1", 1), inbox) { 0 }

    override fun close() = link.close("the test ended")
}
