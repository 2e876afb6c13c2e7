package badlog.formats.wpilog

import badlog.formats.wpilog.record.RecordLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.long
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class WpilogStreamSpec : FunSpec({
    fun written(write: WpilogStream.() -> Unit): ByteArray {
        var bytes = ByteArray(0)
        WpilogStream { piece, size -> bytes += piece.copyOf(size) }.apply(write).flush()
        return bytes
    }

    fun logOf(bytes: ByteArray) = RecordLog.Reader().run {
        accept(bytes)
        finish()
    }

    test("a record is in the file byte by byte, and its numbers are as short as they can be") {
        val bytes = written { record(start("a", "int64", "", 0), 1_000_000, longs(3)) }
        bytes.copyOf(12).toList() shouldBe "WPILOG".encodeToByteArray().toList() + listOf<Byte>(0, 1, 0, 0, 0, 0)
        bytes.copyOfRange(bytes.size - 14, bytes.size).toList() shouldBe listOf<Byte>(0x20, 1, 8, 0x40, 0x42, 0x0f, 3, 0, 0, 0, 0, 0, 0, 0)
    }

    test("all that is written is read again: names, types, metadata, times and payloads") {
        checkAll(
            Arb.string(1..20),
            Arb.string(0..20),
            Arb.long(0L..(1L shl 52)),
            Arb.byteArray(Arb.int(0..300), Arb.byte()),
        ) { name, metadata, micros, payload ->
            // A parser reads characters that are not whole as others.
            val text = name.encodeToByteArray().decodeToString()
            val about = metadata.encodeToByteArray().decodeToString()
            val entry = logOf(written { record(start(text, "raw", about, 0), micros, payload) }).entries.single()
            entry.name shouldBe text
            entry.metadata shouldBe about
            entry.time(0) shouldBe micros / 1e6
            entry.payload(0).toList() shouldBe payload.toList()
        }
    }

    test("metadata can change, and an entry that was finished starts again under another number") {
        val bytes = written {
            val id = start("a", "double", "{\"unit\":\"V\"}", 0)
            record(id, 1, doubles(1.0))
            changeMetadata(id, "{\"unit\":\"A\"}", 2)
            finish(id, 3)
            record(start("a", "double", "", 4), 5, doubles(2.0))
        }
        val recording = parseLog(bytes)
        recording.problems.shouldBeEmpty()
        recording.topics.single().run {
            unit shouldBe "A"
            samples.toList() shouldBe listOf(1.0, 2.0)
        }
    }

    test("a piece is passed on as soon as it is full") {
        val pieces = ArrayList<Int>()
        val stream = WpilogStream { _, size -> pieces += size }
        val id = stream.start("a", "raw", "", 0)
        repeat(10_000) { stream.record(id, it.toLong(), ByteArray(100)) }
        pieces.shouldNotBeEmpty()
        for (size in pieces) size shouldBeInRange (1 shl 16)..(1 shl 16) + 110
        stream.flush()
        (pieces.last() < 1 shl 16) shouldBe true
        (pieces.sum() in 1_040_000..1_070_000) shouldBe true
    }
})
