package badlog.exporter

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import java.io.ByteArrayOutputStream
import java.util.Base64
import java.util.zip.CRC32

class Base64StreamSpec : FunSpec({
    test("each line has the checksum of its own bytes, regardless of how they are split into pieces") {
        checkAll(Arb.list(Arb.list(Arb.byteArray(Arb.int(0, 9), Arb.byte()), 0..5), 1..5)) { lines ->
            val stream = Base64Stream(ByteArrayOutputStream())
            lines.forEachIndexed { i, pieces ->
                pieces.forEach(stream::write)
                if (i < lines.lastIndex) stream.endLine() else stream.finish()
            }
            stream.lineSums shouldBe lines.map { pieces -> CRC32().apply { pieces.forEach(::update) }.value.toInt() }
        }
    }

    fun encode(pieces: List<ByteArray>): String {
        val out = ByteArrayOutputStream()
        val base64 = Base64Stream(out)
        pieces.forEach { base64.write(it) }
        base64.finish()
        return out.toString()
    }

    test("no bytes are encoded as an empty text") {
        encode(emptyList()) shouldBe ""
    }

    test("any pieces are encoded as one text with padding only at its end") {
        checkAll(Arb.list(Arb.byteArray(Arb.int(0..7), Arb.byte()), 0..20)) { pieces ->
            encode(pieces) shouldBe Base64.getEncoder().encodeToString(pieces.fold(ByteArray(0), ByteArray::plus))
        }
    }

    test("pieces larger than the buffer are encoded, at every remainder of three") {
        for (size in 49_150..49_156) {
            val piece = ByteArray(size) { it.toByte() }
            encode(listOf(piece, piece)) shouldBe Base64.getEncoder().encodeToString(piece + piece)
        }
    }

    test("a part of an array is encoded") {
        val out = ByteArrayOutputStream()
        Base64Stream(out).apply {
            write("0123456789".encodeToByteArray(), 2, 5)
            finish()
        }
        out.toString() shouldBe Base64.getEncoder().encodeToString("234".encodeToByteArray())
    }
})
