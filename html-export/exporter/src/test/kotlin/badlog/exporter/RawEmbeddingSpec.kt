package badlog.exporter

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeMonotonicallyIncreasing
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.util.zip.GZIPInputStream
import kotlin.random.Random

class RawEmbeddingSpec : FunSpec({
    val parsed = ByteArrayOutputStream()
    val progress = ArrayList<Long>()

    // Java's own reader checks the checksum and the length, and that nothing follows.
    fun embedAndInflate(bytes: ByteArray): ByteArray {
        parsed.reset()
        progress.clear()
        val text = ByteArrayOutputStream()
        val out = Base64Stream(text)
        val file = ExportThreads().use { threads ->
            RawEmbedding(threads, out) { piece, from, until -> parsed.write(piece, from, until - from) }
                .embed(ByteArrayInputStream(bytes), progress::add)
        }
        out.finish()
        file.originalBytes shouldBe bytes.size
        file.inflatedBytes shouldBe bytes.size
        return GZIPInputStream(ByteArrayInputStream(decodeLines(text.toString()))).readAllBytes()
    }

    val around = listOf(0, 1, 2, DeflatePiece.SIZE, 2 * DeflatePiece.SIZE, 9 * DeflatePiece.SIZE)
        .flatMap { listOf(it - 1, it, it + 1) }.filter { it >= 0 }.distinct()

    for (size in around) {
        test("$size bytes of text are embedded and parsed unchanged") {
            val text = ByteArray(size) { "12.345,"[it % 7].code.toByte() }
            embedAndInflate(text).contentEquals(text) shouldBe true
            parsed.toByteArray().contentEquals(text) shouldBe true
            progress.shouldBeMonotonicallyIncreasing()
            progress.last() shouldBe size
        }
    }

    test("incompressible noise is embedded unchanged") {
        val noise = Random(1).nextBytes(3 * DeflatePiece.SIZE + 17)
        embedAndInflate(noise).contentEquals(noise) shouldBe true
    }

    test("any bytes are embedded unchanged") {
        checkAll(100, Arb.byteArray(Arb.int(0..5000), Arb.byte())) { bytes -> embedAndInflate(bytes) shouldBe bytes }
    }

    test("a piece is smaller because it uses the previous text as a dictionary") {
        val noise = Random(2).nextBytes(20_000)
        val text = ByteArray(4 * DeflatePiece.SIZE) { noise[it % noise.size] }
        val piece = DeflatePiece()
        val first = DeflatePiece()
        first.fill(ByteArrayInputStream(text), null)
        piece.fill(ByteArrayInputStream(text, DeflatePiece.SIZE, DeflatePiece.SIZE), first)
        first.deflate()
        piece.deflate()
        piece.deflatedSize shouldBeLessThan first.deflatedSize - noise.size / 2
        listOf(first, piece).forEach { it.close() }
    }
})
