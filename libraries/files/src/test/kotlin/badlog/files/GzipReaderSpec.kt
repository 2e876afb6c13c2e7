package badlog.files

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.booleans.shouldBeFalse
import io.kotest.matchers.booleans.shouldBeTrue
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith
import io.kotest.property.PropertyTesting
import java.io.ByteArrayOutputStream
import java.util.zip.GZIPOutputStream
import kotlin.random.Random

@Tags("InCheck")
class GzipReaderSpec : FunSpec({
    class Inflated(val bytes: ByteArray, val isCut: Boolean) {
        val text get() = bytes.decodeToString()
    }

    fun read(gzip: ByteArray, piece: Int = gzip.size.coerceAtLeast(1)): Inflated {
        val out = ByteArrayOutputStream()
        return GzipReader { bytes, size -> out.write(bytes, 0, size) }.use { reader ->
            for (from in gzip.indices step piece) reader.accept(gzip, from, minOf(gzip.size, from + piece))
            reader.inflatedBytes shouldBe out.size()
            Inflated(out.toByteArray(), reader.isCut)
        }
    }

    val rows = (0 until 20_000).joinToString("\n") { "$it,${it * 31 % 977}" }
    val whole = gzip(rows.encodeToByteArray())

    test("a whole file, however it is cut into pieces") {
        for (piece in listOf(1, 2, 3, 7, 1000, whole.size)) {
            read(whole, piece).run {
                text shouldBe rows
                isCut.shouldBeFalse()
            }
        }
    }

    test("an empty text") {
        read(gzip(ByteArray(0))).run {
            bytes.size shouldBe 0
            isCut.shouldBeFalse()
        }
    }

    test("a missing or partial trailer is not a loss") {
        for (missing in 1..8) {
            read(whole.copyOf(whole.size - missing)).run {
                text shouldBe rows
                isCut.shouldBeFalse()
            }
        }
    }

    test("a stream that was flushed but never closed is not a loss") {
        val out = ByteArrayOutputStream()
        GZIPOutputStream(out, true).apply {
            write(rows.encodeToByteArray())
            flush()
        }
        for (piece in listOf(1, 3, out.size())) {
            read(out.toByteArray(), piece).run {
                text shouldBe rows
                isCut.shouldBeFalse()
            }
        }
    }

    test("a file cut anywhere yields its beginning, and counts as cut") {
        var last = 0
        for (size in 1..whole.size - 9 step 11) {
            read(whole.copyOf(size)).run {
                isCut.shouldBeTrue()
                rows shouldStartWith text
                last = bytes.size
            }
        }
        last shouldBeGreaterThan rows.length - 1000
    }

    test("several members follow each other, with remains at the end") {
        val two = gzip("one,".encodeToByteArray()) + gzip("two".encodeToByteArray())
        for (remains in listOf(ByteArray(0), ByteArray(4096), "remains".encodeToByteArray(), byteArrayOf(0x1F))) {
            for (piece in listOf(1, 5, 10_000)) {
                read(two + remains, piece).run {
                    text shouldBe "one,two"
                    isCut.shouldBeFalse()
                }
            }
        }
    }

    test("every field of a header is skipped") {
        val body = whole.copyOfRange(10, whole.size)
        val extra = byteArrayOf(3, 0, 9, 9, 9)
        val name = "log.bag\u0000".encodeToByteArray()
        for (flags in 0 until 32) {
            var header = byteArrayOf(0x1F, 0x8B.toByte(), 8, flags.toByte(), 1, 2, 3, 4, 0, 3)
            if (flags and 4 != 0) header += extra
            if (flags and 8 != 0) header += name
            if (flags and 16 != 0) header += name
            if (flags and 2 != 0) header += byteArrayOf(7, 7)
            read(header + body, piece = 3).text shouldBe rows
        }
    }

    test("an empty extra field") {
        val header = byteArrayOf(0x1F, 0x8B.toByte(), 8, 4, 0, 0, 0, 0, 0, 3, 0, 0)
        read(header + whole.copyOfRange(10, whole.size)).text shouldBe rows
    }

    test("a file damaged inside yields the data before the damage") {
        val random = Random(3)
        repeat(PropertyTesting.defaultIterationCount) {
            val damaged = whole.copyOf()
            val at = random.nextInt(20, whole.size - 8)
            for (i in at until minOf(at + 4, whole.size)) damaged[i] = random.nextInt().toByte()
            read(damaged, random.nextInt(1, whole.size))
        }
        val damaged = whole.copyOf()
        damaged.fill(-1, whole.size / 2, whole.size)
        read(damaged).run {
            isCut.shouldBeTrue()
            bytes.size shouldBeGreaterThan rows.length / 3
        }
    }

    test("a file of only the signature, or of another method than deflate, counts as cut") {
        read(byteArrayOf(0x1F, 0x8B.toByte())).isCut.shouldBeTrue()
        read(byteArrayOf(0x1F, 0x8B.toByte(), 7, 0, 0, 0, 0, 0, 0, 0, 0, 0)).isCut.shouldBeTrue()
    }
})
