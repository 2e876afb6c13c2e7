package badlog.core.bag

import badlog.core.recording.NumberSink
import badlog.core.recording.NumberSinks
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.booleans.shouldBeFalse
import io.kotest.matchers.booleans.shouldBeTrue
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.random.Random

// Only the rows of a CSV file show what its titles mean.
private const val HEADER = "{\"topics\":[{\"name\":\"first\"},{\"name\":\"second\"}]}\nfirst,second\n"

class RowBatchSpec : FunSpec({
    test("rows read in batches make the same recording as rows read one after another, wherever the batches end") {
        val random = Random(5810)
        var taken = 0
        repeat(2 * PropertyTesting.defaultIterationCount) {
            val bytes = randomBag(random)
            for (size in listOf(1, 7, 40, 200)) {
                val batches = Batches(bytes, size, keepSamples = true)
                val recording = batches.read()
                describeFully(recording) shouldBe describeFully(parse(bytes))
                taken += batches.taken
            }
        }
        taken shouldBeGreaterThan 50 * PropertyTesting.defaultIterationCount
    }

    test("batches without samples make the same recording as rows read one after another") {
        val random = Random(2016)
        repeat(PropertyTesting.defaultIterationCount) {
            val bytes = randomBag(random)
            val parser = BagParser(keepSamples = false)
            parser.accept(bytes)
            describeFully(Batches(bytes, 30, keepSamples = false).read()) shouldBe describeFully(parser.finish())
        }
    }

    test("a batch is refused in the middle of a row, and after a hole") {
        val batch = checkNotNull(RowBatchParser(booleanArrayOf(true, true)).parse("1,2\n".encodeToByteArray(), 0, 4))
        batch.rowCount shouldBe 1
        for (before in listOf("first,se", "first,second\n1,\"open", "first,second\n1,2\n\u0000", "first,second\n1,2\n\u0000\u00003")) {
            val parser = BagParser()
            parser.accept(before.encodeToByteArray())
            parser.accept(batch).shouldBeFalse()
        }
        val parser = BagParser()
        parser.accept(HEADER.encodeToByteArray())
        parser.accept(batch).shouldBeTrue()
    }

    test("a batch is refused if it lacks needed numbers, or has numbers that are not kept") {
        val bytes = "1,2\n".encodeToByteArray()
        val (whole, counted) = listOf(true, false).map {
            checkNotNull(RowBatchParser(booleanArrayOf(true, true), it).parse(bytes, 0, bytes.size))
        }
        val numbers = ArrayList<Double>()
        val sinks = NumberSinks { name, _ -> if (name == "second") NumberSink { _, number -> numbers += number } else null }
        for (keepSamples in listOf(true, false)) {
            val parser = BagParser(0, keepSamples, sinks)
            parser.accept(HEADER.encodeToByteArray())
            parser.accept(counted).shouldBeFalse()
            parser.accept(whole) shouldBe keepSamples
            if (!keepSamples) parser.accept(bytes)
            parser.finish().rowCount shouldBe 1
        }
        numbers shouldBe listOf(2.0, 2.0)
    }

    test("irregular bytes make no batch") {
        val parser = RowBatchParser(booleanArrayOf(true, false))
        for (odd in listOf("1\n", "1,2,3\n", "1,2", "1,\"2\n", "\n", "1,2\n\u0000", "1,\u0000\n", "\u0000", "1,a\"b\"\"\n1,2\r")) {
            withClue(odd) { parser.parse(odd.encodeToByteArray(), 0, odd.length).shouldBeNull() }
        }
        parser.parse(byteArrayOf('1'.code.toByte(), ','.code.toByte(), -3, '\n'.code.toByte()), 0, 4).shouldBeNull()
    }

    test("a problem of a column is reported once, with its first line, even if the later rows come in batches") {
        val bytes = "a,b\n\"1,5\",oh\n\"2,5\",2\n\"3,5\",3\n4,no\n5,5\n6,6\n7,7\n8,8\n".encodeToByteArray()
        val recording = Batches(bytes, 12, keepSamples = true).read()
        recording.problems.first { it.kind == ProblemKind.DECIMAL_COMMA }.run {
            line shouldBe 2
            count shouldBe 3
        }
    }
})

/** Reads [bytes] in pieces of about [size] bytes that end in a newline. Counts those that were [taken] as batches. */
private class Batches(private val bytes: ByteArray, private val size: Int, private val keepSamples: Boolean) {
    var taken = 0

    fun read(): Recording {
        val parser = BagParser(keepSamples = keepSamples)
        var rows: RowBatchParser? = null
        var at = 0
        while (at < bytes.size) {
            var end = minOf(at + size, bytes.size)
            while (end < bytes.size && bytes[end - 1] != '\n'.code.toByte()) end++
            rows = rows ?: parser.readsDecimalComma?.let { RowBatchParser(it, keepSamples) }
            val batch = rows?.parse(bytes, at, end)
            if (batch != null && parser.accept(batch)) taken++ else parser.accept(bytes, at, end)
            at = end
        }
        return parser.finish()
    }
}
