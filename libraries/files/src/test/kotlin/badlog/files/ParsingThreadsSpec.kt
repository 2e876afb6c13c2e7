package badlog.files

import badlog.core.bag.BagParser
import badlog.core.bag.describeFully
import badlog.core.bag.randomBag
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.VARIED_LOG
import badlog.formats.wpilog.describeLog
import badlog.formats.wpilog.parseLog
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.random.Random

@Tags("InCheck")
class ParsingThreadsSpec : FunSpec({
    test("a bag reads the same on all cores as on one, whole or damaged, wherever its pieces end") {
        val random = Random(7)
        repeat(PropertyTesting.defaultIterationCount) {
            val bytes = randomBag(random)
            for (keepSamples in listOf(true, false)) {
                val expected = BagParser(0, keepSamples).apply { accept(bytes) }.finish()
                for (pieceSize in listOf(20, 100, 400)) {
                    val recording = ParsingThreads(LOG_FORMATS, bytes.size.toLong(), ReadOptions(keepSamples, cores = 2), pieceSize = pieceSize).use {
                        it.accept(bytes, bytes.size)
                        it.finish()
                    }
                    describeFully(recording) shouldBe describeFully(expected)
                }
            }
        }
    }

    test("many rows read the same on all cores, however many are expected") {
        val rows = (0 until 40_000).joinToString("") { "${it * 0.02},${it % 7},${if (it % 900 == 0) "said $it" else ""}\n" }
        val bytes = "{\"topics\":[{\"name\":\"Time\"},{\"name\":\"b\"},{\"name\":\"c\"}]}\nTime,b,c\n$rows".encodeToByteArray()
        val expected = describeFully(BagParser().apply { accept(bytes) }.finish())
        for (expectedBytes in listOf(0L, 1000L, bytes.size.toLong(), bytes.size * 3L)) {
            val recording = ParsingThreads(LOG_FORMATS, expectedBytes, ReadOptions(cores = 2), pieceSize = 1 shl 14).use {
                it.accept(bytes, bytes.size)
                it.finish()
            }
            describeFully(recording) shouldBe expected
        }
    }

    test("a log of records is read by its own parser") {
        val recording = ParsingThreads(LOG_FORMATS, 0, ReadOptions(cores = 2), pieceSize = 64).use {
            it.accept(VARIED_LOG.bytes, VARIED_LOG.bytes.size)
            it.finish()
        }
        describeLog(recording) shouldBe describeLog(parseLog(VARIED_LOG.bytes))
    }
})
