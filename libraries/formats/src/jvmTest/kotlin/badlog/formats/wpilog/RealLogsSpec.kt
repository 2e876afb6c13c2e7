package badlog.formats.wpilog

import badlog.core.analysis.LogView
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.formats.column.ColumnSource
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import java.io.File
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Logs of a season's robot. They are not part of the project, so the test runs where `BADLOG_REAL_LOGS` names their folder. */
internal val REAL_LOGS: List<File> =
    File(System.getenv("BADLOG_REAL_LOGS").orEmpty()).listFiles { file -> file.name.endsWith(".wpilog") }.orEmpty().sorted()

/** The result of a slow and simple reader. It has the sizes of its payloads for each name, and the number from before 0. */
private class SimpleReading(bytes: ByteArray) {
    val payloads = LinkedHashMap<String, MutableList<Int>>()
    val types = HashMap<String, String>()
    var records = 0
    var early = 0

    init {
        val log = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        log.position(12 + log.getInt(8))
        val names = HashMap<Long, String>()
        while (log.hasRemaining()) {
            val head = log.get().toInt()
            fun number(width: Int) = (0 until width).fold(0L) { sum, i -> sum or ((log.get().toLong() and 0xFF) shl 8 * i) }
            val id = number((head and 3) + 1)
            val size = number((head shr 2 and 3) + 1).toInt()
            val time = number((head shr 4 and 7) + 1)
            val end = log.position() + size
            records++
            if (id == 0L && log.get() == 0.toByte()) {
                val begun = number(4)
                val texts = List(3) { ByteArray(log.getInt()).also(log::get).decodeToString() }
                names[begun] = texts[0]
                types[texts[0]] = texts[1]
                payloads.getOrPut(texts[0]) { ArrayList() }
            } else if (id != 0L) {
                if (time < 0) early++
                payloads.getValue(names.getValue(id)) += size
            }
            log.position(end)
        }
    }
}

private val WIDTHS = mapOf("boolean[]" to 1, "float[]" to 4, "int64[]" to 8, "double[]" to 8)

class RealLogsSpec : FunSpec({
    test("real logs open with every record accounted for").config(
        enabledOrReasonIf = {
            if (REAL_LOGS.isNotEmpty()) Enabled.enabled else Enabled.disabled("the logs are not on this machine")
        },
    ) {
        for (file in REAL_LOGS) {
            val bytes = file.readBytes()
            val simple = SimpleReading(bytes)
            val parser = WpilogParser()
            parser.accept(bytes)
            val recording = parser.finish()
            parser.rowCount shouldBe simple.records
            recording.problems.filter { it.kind == ProblemKind.EARLY_TIMES }.sumOf { it.count } shouldBe simple.early
            recording.isSalvaged shouldBe false
            for ((name, sizes) in simple.payloads) {
                val type = simple.types.getValue(name)
                val topics = recording.topics.filter { topic ->
                    topic.type == type && (topic.name == name || topic.name.startsWith("$name[") || topic.name.startsWith("$name/"))
                }
                val width = WIDTHS[type]
                when {
                    width != null -> topics.sumOf { it.size - it.counts.empty } shouldBe sizes.sumOf { it / width }
                    type == "string[]" -> topics.size shouldBeGreaterThan 0
                    else -> for (topic in topics) topic.size shouldBe sizes.size
                }
            }
            val view = LogView.of(recording)
            view.xAxis.range.shouldNotBeNull().endInclusive shouldBeLessThan 3600.0
            view.folders.sumOf { it.graphs.size + it.eventLogs.size } shouldBeGreaterThan 100
        }
    }

    test("a hole of 4 KiB in a real log costs only the records in it").config(
        enabledOrReasonIf = {
            if (REAL_LOGS.isNotEmpty()) Enabled.enabled else Enabled.disabled("the logs are not on this machine")
        },
    ) {
        for (file in REAL_LOGS) {
            val bytes = file.readBytes()
            val whole = positionsIn(bytes)
            for (from in 12 until bytes.size - 5000 step 1500) {
                val found = positionsIn(bytes.copyOf().also { it.fill(0, from, from + 4096) })
                val begun = whole.filter { (at, id) -> id == 0 && at !in found }.size
                val lost = whole.filter { (at, id) -> (at < from - 250 || at >= from + 4096 + 75) && at !in found && id != 0 }
                // Entries that began in the hole have no names any more.
                lost.values.distinct().size shouldBeLessThanOrEqual begun
                (found.keys - whole.keys).shouldBeEmpty()
            }
        }
    }
})

/** The start of each record that is read, and the number of its entry. */
private fun positionsIn(bytes: ByteArray): Map<Long, Int> {
    val positions = LinkedHashMap<Long, Int>()
    val entries = WpilogEntries(ColumnSource(keepsSamples = false), ProblemList())
    val sink = object : RecordSink by entries {
        override fun record(head: RecordHead, position: Long, bytes: ByteArray, from: Int, until: Int) {
            if (entries.read(head, bytes, until)) positions[position] = head.id
        }
    }
    RecordSplitter(sink).apply { accept(bytes, 0, bytes.size) }.finish()
    return positions
}
