package badlog.formats.wpilog

import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll

/** Messages written byte by byte by the encoding, independently of the code under test. */
private fun varint(number: Long): ByteArray = if (number ushr 7 == 0L) {
    byteArrayOf(number.toByte())
} else {
    byteArrayOf((number and 0x7F or 0x80).toByte()) + varint(number ushr 7)
}

private fun tag(number: Int, wire: Int) = varint((number shl 3 or wire).toLong())
private fun whole(number: Int, value: Long) = tag(number, 0) + varint(value)
private fun sized(number: Int, bytes: ByteArray) = tag(number, 2) + varint(bytes.size.toLong()) + bytes
private fun words(number: Int, text: String) = sized(number, text.encodeToByteArray())

private fun field(name: String, number: Int, type: Int, typeName: String = "", isList: Boolean = false, isOptional: Boolean = false) = sized(
    2,
    words(1, name) + whole(3, number.toLong()) + whole(4, if (isList) 3 else 1) + whole(5, type.toLong()) +
        (if (typeName.isEmpty()) ByteArray(0) else words(6, ".$typeName")) + if (isOptional) whole(17, 1) else ByteArray(0),
)

private fun message(name: String, vararg parts: ByteArray) = words(1, name) + parts.fold(ByteArray(0), ByteArray::plus)

private const val DOUBLE = 1
private const val FLOAT = 2
private const val INT64 = 3
private const val UINT64 = 4
private const val INT32 = 5
private const val FIXED64 = 6
private const val FIXED32 = 7
private const val BOOL = 8
private const val STRING = 9
private const val MESSAGE = 11
private const val BYTES = 12
private const val UINT32 = 13
private const val ENUM = 14
private const val SFIXED32 = 15
private const val SFIXED64 = 16
private const val SINT32 = 17
private const val SINT64 = 18

/** The recording of a log in which entry `p` of message a.M, with [fields], has these payloads, 1 ms apart. */
private fun read(fields: ByteArray, vararg payloads: ByteArray, others: ByteArray = ByteArray(0)): Recording {
    val file = words(1, "a.proto") + words(2, "a") + sized(4, message("M", fields)) + others
    val log = TestLog().start(1, "p", "proto:a.M").start(2, "/.schema/proto:a.proto", "proto:FileDescriptorProto").record(2, 0, file)
    payloads.forEachIndexed { i, payload -> log.record(1, 1000L * (i + 1), payload) }
    return parseLog(log.bytes)
}

private fun Recording.topic(name: String): Topic = topics.single { it.name == name }

private fun Topic.textList() = List(texts.size) { texts[it] }

private val Recording.parts: List<Topic> get() = topics.filter { it.name.startsWith("p") }

/** Each topic of entry `p`, with its first sample. */
private fun values(recording: Recording): Map<String, Any> = recording.parts.associate { it.name to if (it.texts.size > 0) it.texts[0] else it.samples.firstOrNull() ?: "nothing" }

class ProtoSpec : FunSpec({
    test("each field of a message is a topic, whatever its type is") {
        val fields = field("a", 1, DOUBLE) + field("b", 2, FLOAT) + field("c", 3, INT64) + field("d", 4, UINT64) + field("e", 5, INT32) +
            field("f", 6, FIXED64) + field("g", 7, FIXED32) + field("h", 8, BOOL) + field("i", 9, STRING) + field("j", 10, BYTES) +
            field("k", 11, UINT32) + field("l", 12, SFIXED32) + field("m", 13, SFIXED64) + field("n", 14, SINT32) + field("o", 300, SINT64)
        val payload = tag(1, 1) + doubles(1.5) + tag(2, 5) + floats(0.5f) + whole(3, -3) + whole(4, 7) + whole(5, -5) + tag(6, 1) + number(6, 8) +
            tag(7, 5) + number(-1, 4) + whole(8, 1) + words(9, "abc") + sized(10, ByteArray(3)) + whole(11, 4294967295) + tag(12, 5) +
            number(-2, 4) + tag(13, 1) + number(-4, 8) + whole(14, 5) + whole(300, 4)
        values(read(fields, payload)) shouldBe mapOf(
            "p/a" to 1.5, "p/b" to 0.5, "p/c" to -3.0, "p/d" to 7.0, "p/e" to -5.0, "p/f" to 6.0, "p/g" to 4294967295.0, "p/h" to 1.0,
            "p/i" to "abc", "p/j" to 3.0, "p/k" to 4294967295.0, "p/l" to -2.0, "p/m" to -4.0, "p/n" to -3.0, "p/o" to 2.0,
        )
    }

    test("a field that a message leaves out has its default, unless it may be missing") {
        val inner = sized(4, message("Inner", field("x", 1, DOUBLE)))
        val fields = field("n", 1, INT32) + field("s", 2, STRING) + field("maybe", 3, INT32, isOptional = true) + field("in", 4, MESSAGE, "a.Inner")
        val recording = read(fields, ByteArray(0), whole(1, 5) + whole(3, 0) + sized(4, ByteArray(0)), others = inner)
        recording.topic("p/n").samples.toList() shouldBe listOf(0.0, 5.0)
        recording.topic("p/s").textList() shouldBe listOf("", "")
        recording.topic("p/maybe").run { samples.map { it.isNaN() } to counts.empty } shouldBe (listOf(true, false) to 1)
        recording.topic("p/in/x").samples.map { it.isNaN() } shouldBe listOf(true, false)
    }

    test("messages in messages, enumerations and lists are taken apart, lists in lists too") {
        val point = message("Point", field("x", 1, DOUBLE), field("axes", 2, SINT32, isList = true), field("mode", 3, ENUM, "a.Mode"))
        val mode = words(1, "Mode") + sized(2, words(1, "OFF") + whole(2, 0)) + sized(2, words(1, "ON") + whole(2, 1))
        val fields = field("in", 1, MESSAGE, "a.Point") + field("list", 2, MESSAGE, "a.Point", isList = true) + field("names", 3, STRING, isList = true)
        val one = tag(1, 1) + doubles(1.0) + sized(2, varint(1) + varint(4)) + whole(3, 1)
        val two = whole(2, 3) + whole(3, 9)
        val payload = sized(1, one) + sized(2, one) + sized(2, two) + words(3, "a") + words(3, "b")
        values(read(fields, payload, others = sized(4, point) + sized(5, mode))) shouldBe mapOf(
            "p/in/x" to 1.0, "p/in/mode" to "ON", "p/in/axes[0]" to -1.0, "p/in/axes[1]" to 2.0,
            "p/list[0]/x" to 1.0, "p/list[0]/mode" to "ON", "p/list[0]/axes[0]" to -1.0, "p/list[0]/axes[1]" to 2.0,
            "p/list[1]/x" to 0.0, "p/list[1]/mode" to "9", "p/list[1]/axes[0]" to -2.0, "p/names[0]" to "a", "p/names[1]" to "b",
        )
    }

    test("an element of a list that disappears has one gap, and so have the lists in it") {
        val point = message("Point", field("v", 1, INT32, isList = true))
        val fields = field("list", 1, MESSAGE, "a.Point", isList = true)
        val element = sized(1, sized(1, varint(4)))
        val recording = read(fields, element, ByteArray(0), ByteArray(0), element, others = sized(4, point))
        recording.topic("p/list[0]/v[0]").run { samples.map { if (it.isNaN()) null else it } to times?.toList() } shouldBe
            (listOf(4.0, null, 4.0) to listOf(0.001, 0.002, 0.004))
    }

    test("of a field that occurs twice the last value counts, a message in two pieces is merged, and unknown fields are skipped") {
        val point = message("Point", field("x", 1, INT32), field("y", 2, INT32))
        val fields = field("n", 1, INT32) + field("in", 2, MESSAGE, "a.Point")
        val payload = whole(1, 1) + sized(2, whole(1, 7)) + words(99, "later") + sized(2, whole(2, 8)) + whole(1, 2)
        values(read(fields, payload, others = sized(4, point))) shouldBe mapOf("p/n" to 2.0, "p/in/x" to 7.0, "p/in/y" to 8.0)
    }

    test("a field of a message's own type is not taken apart") {
        val fields = field("n", 1, INT32) + field("child", 2, MESSAGE, "a.M")
        values(read(fields, whole(1, 3) + sized(2, whole(1, 4)))) shouldBe mapOf("p/n" to 3.0)
    }

    test("a message that would double its size with every level is shown by its size") {
        val levels = (1..40).map { sized(4, message("L$it", field("a", 1, MESSAGE, "a.L${it + 1}"), field("b", 2, MESSAGE, "a.L${it + 1}", isList = true))) }
        val recording = read(field("top", 1, MESSAGE, "a.L1"), ByteArray(4) { 8 }, others = levels.fold(ByteArray(0), ByteArray::plus))
        recording.topic("p").unit shouldBe "B"
    }

    for (isList in listOf(false, true)) {
        val kind = if (isList) "lists" else "messages"

        // The descriptor's bytes are flat, so it may name more levels than the stack has room for.
        test("a type whose $kind are nested 9,000 deep is shown by its size, with a note, and the rest of the log is read") {
            val levels = (1..9_000).map { sized(4, message("L$it", field("a", 1, MESSAGE, "a.L${it + 1}", isList))) }
            val last = sized(4, message("L9001", field("x", 1, DOUBLE)))
            val others = ByteArray(levels.sumOf { it.size } + last.size)
            (levels + last).fold(0) { at, level -> level.copyInto(others, at).let { at + level.size } }
            val recording = read(field("top", 1, MESSAGE, "a.L1"), ByteArray(4) { 8 }, others = others)
            recording.topic("p").run { unit to samples.toList() } shouldBe ("B" to listOf(4.0))
            recording.problems.map { it.kind to it.topic } shouldContainExactly listOf(ProblemKind.NOT_DECODED to "p")
        }
    }

    test("messages are taken apart up to 100 levels deep") {
        fun levels(count: Int): Recording {
            val inner = (1..count - 2).map { sized(4, message("L$it", field("a", 1, MESSAGE, "a.L${it + 1}"))) }
            val last = sized(4, message("L${count - 1}", field("x", 1, INT32)))
            val payload = (2..count).fold(whole(1, 7)) { part, _ -> sized(1, part) }
            return read(field("a", 1, MESSAGE, "a.L1"), payload, others = (inner + last).reduce(ByteArray::plus))
        }
        values(levels(100)) shouldBe mapOf("p" + "/a".repeat(99) + "/x" to 7.0)
        levels(101).topic("p").unit shouldBe "B"
    }

    test("a payload that is not a message of its type is dropped and counted") {
        val recording = read(field("n", 1, INT32), whole(1, 3), words(1, "text"), byteArrayOf(8), byteArrayOf(3), whole(1, 4))
        recording.topic("p/n").samples.toList() shouldBe listOf(3.0, 4.0)
        recording.problems.single { it.kind == ProblemKind.BAD_RECORD }.count shouldBe 3
    }

    test("records wait for their descriptor, and a descriptor of another package is not enough") {
        val file = words(1, "b.proto") + words(2, "b") + sized(4, message("M", field("n", 1, INT32)))
        val log = TestLog().start(1, "p", "proto:b.M").start(2, "NT:/.schema/proto:b.proto", "proto:FileDescriptorProto").start(3, "q", "proto:c.M")
        val recording = parseLog(log.record(1, 10, whole(1, 3)).record(2, 20, file).record(1, 30, whole(1, 4)).record(3, 40, whole(1, 4)).bytes)
        recording.topic("p/n").samples.toList() shouldBe listOf(3.0, 4.0)
        recording.topic("q").run { unit to samples.toList() } shouldBe ("B" to listOf(2.0))
        recording.problems.map { it.kind } shouldContainExactly listOf(ProblemKind.NOT_DECODED)
    }

    test("the Driver Station's console of 2027 is events, and its line numbers are numbers") {
        val file = words(2, "mrc.proto") +
            sized(4, message("ProtobufConsoleLineTimestamp", field("ConsoleLine", 1, STRING), field("SequenceNumber", 3, INT32)))
        val log = TestLog().start(1, "DS:/Dscomm/Console/ConsoleLine", "proto:mrc.proto.ProtobufConsoleLineTimestamp")
            .start(2, "DS:/.schema/proto:MrcComm.proto", "proto:FileDescriptorProto").record(2, 0, file)
        repeat(6) { log.record(1, 1000L * it, words(1, "same") + whole(3, it.toLong())) }
        val recording = parseLog(log.bytes)
        recording.topic("DS:/Dscomm/Console/ConsoleLine/ConsoleLine").attributes shouldContain "log"
        recording.topic("DS:/Dscomm/Console/ConsoleLine/SequenceNumber").run { kind to attributes } shouldBe (TopicKind.NUMERIC to emptyList())
    }

    test("any bytes of descriptors and messages are read without an exception, and every topic has as many samples as times") {
        val fields = field("n", 1, INT32) + field("l", 2, MESSAGE, "a.P", isList = true) + field("s", 3, STRING, isList = true)
        val point = sized(4, message("P", field("x", 1, DOUBLE), field("v", 2, INT32, isList = true)))
        checkAll(Arb.byteArray(Arb.int(0..40), Arb.byte()), Arb.byteArray(Arb.int(0..40), Arb.byte())) { one, other ->
            val recordings = listOf(
                read(fields, one, sized(2, other), sized(2, one) + whole(1, 1), others = point),
                read(one, other, others = other),
            )
            for (topic in recordings.flatMap { it.parts }) {
                topic.size shouldBe topic.times?.size
                if (topic.texts.size == 0 && topic.kind != TopicKind.EMPTY) topic.samples.size shouldBe topic.size
            }
        }
    }
})
