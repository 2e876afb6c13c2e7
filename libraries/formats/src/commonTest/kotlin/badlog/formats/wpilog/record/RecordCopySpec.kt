package badlog.formats.wpilog.record

import badlog.core.analysis.Span
import badlog.formats.wpilog.TestLog
import badlog.formats.wpilog.VARIED_LOG
import badlog.formats.wpilog.describeLog
import badlog.formats.wpilog.doubles
import badlog.formats.wpilog.longs
import badlog.formats.wpilog.parseLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.random.Random

internal fun recordsOf(bytes: ByteArray, piece: Int = maxOf(1, bytes.size)): RecordLog = RecordLog.Reader().run {
    for (at in bytes.indices step piece) accept(bytes, at, minOf(at + piece, bytes.size))
    finish()
}

internal fun written(write: (sink: (ByteArray, Int) -> Unit) -> Unit): ByteArray {
    var all = ByteArray(0)
    write { bytes, size -> all += bytes.copyOf(size) }
    return all
}

private fun copyOf(bytes: ByteArray, copy: RecordCopy.() -> Unit): ByteArray = written { RecordCopy(recordsOf(bytes), sink = it).copy() }

/** A log of more than numbers. */
private fun typed() = TestLog("{\"from\":\"a robot\"}")
    .start(1, "/.schema/struct:Pose2d", "structschema")
    .start(2, "/Pose", "struct:Pose2d", "{\"a\":1}", 900_000)
    .start(3, "Ticks", "int64")
    .start(4, "Photo", "raw")
    .start(5, "Said", "string", "{\"attrs\":[\"log\"]}")

private const val BIG = 9_007_199_254_740_993

class RecordCopySpec : FunSpec({
    test("all records are copied byte by byte, except those that no reader uses") {
        fun log(isDamaged: Boolean) = typed()
            .string(1, 1_000_000, "double x;double y").record(2, 1_000_000, doubles(1.0, 2.0)).record(3, 1_500_000, longs(BIG))
            .apply { if (isDamaged) record(77, 1_500_000, byteArrayOf(1)).record(3, 1_600_000, byteArrayOf(1)).record(2, 1_600_000, doubles(1.0)) }
            .record(4, 1_700_000, byteArrayOf(9, 8)).finish(4, 1_800_000).start(4, "Other", "double", at = 1_900_000).double(4, 2_000_000, 1.0)
            .metadata(3, "{\"unit\":\"1\"}", 2_100_000)
            .apply { if (isDamaged) double(4, 1L shl 60, 3.0) }
            .double(4, -20, 5.0)
        for (piece in listOf(1, 7, 10_000)) {
            val whole = log(isDamaged = false).bytes
            written { RecordCopy(recordsOf(whole, piece), sink = it).all() }.toList() shouldBe whole.toList()
            written { RecordCopy(recordsOf(log(isDamaged = true).bytes, piece), sink = it).all() }.toList() shouldBe whole.toList()
        }
    }

    test("a part has the records of its span unchanged, and the values that held at its start") {
        val log = typed().string(1, 1_000_000, "double x;double y").record(2, 1_000_000, doubles(1.0, 2.0)).record(3, 1_500_000, longs(BIG))
            .string(5, 1_700_000, "ready").record(4, 1_800_000, byteArrayOf(9, 8)).record(2, 3_000_000, doubles(3.0, 4.0))
            .string(5, 3_100_000, "go").record(3, 3_200_000, longs(BIG + 2)).record(2, 5_000_000, doubles(5.0, 6.0)).finish(2, 5_100_000)
        val expected = typed().string(1, 2_000_000, "double x;double y").record(2, 2_000_000, doubles(1.0, 2.0)).record(3, 2_000_000, longs(BIG))
            .record(4, 2_000_000, byteArrayOf(9, 8)).record(2, 3_000_000, doubles(3.0, 4.0)).string(5, 3_100_000, "go")
            .record(3, 3_200_000, longs(BIG + 2)).finish(2, 5_100_000)
        val part = copyOf(log.bytes) { spans(listOf(Span(2.0, 4.0)), { it.name == "Said" }) }
        part.toList() shouldBe expected.bytes.toList()
        parseLog(part).topics.first { it.name == "/Pose/x" }.samples.toList() shouldContainExactly listOf(1.0, 3.0)
    }

    test("a value that held belongs to its own entry, even if another one has its number by then") {
        val log = TestLog().start(1, "A", "double").double(1, 1_000_000, 1.0).finish(1, 1_100_000).start(1, "B", "double").double(1, 3_000_000, 2.0)
        val part = parseLog(copyOf(log.bytes) { spans(listOf(Span(2.0, 4.0)), { false }) })
        part.topics.map { topic -> topic.times?.toList().orEmpty().zip(topic.samples.toList()) } shouldContainExactly
            listOf(listOf(2.0 to 1.0), listOf(3.0 to 2.0))
    }

    test("a part has the match of the whole log, and the time at which the part itself begins") {
        val log = TestLog().start(1, "systemTime", "int64").start(2, "NT:/FMSInfo/MatchNumber", "int64").start(3, "A", "double")
            .record(1, 1_000_000, longs(1_700_000_000_000_000)).record(2, 1_000_000, longs(42)).double(3, 1_000_000, 1.0).double(3, 61_000_000, 2.0)
        val part = parseLog(copyOf(log.bytes) { spans(listOf(Span(61.0, 62.0)), { false }) })
        parseLog(log.bytes).values.map { "${it.name} ${it.text}" } shouldContainExactly
            listOf("Match Number 42", "Start Time 2023-11-14 22:13:20 UTC")
        part.values.map { "${it.name} ${it.text}" }.toSet() shouldBe setOf("Match Number 42", "Start Time 2023-11-14 22:14:20 UTC")
    }

    test("at any time of a part, each entry has the same value as in the whole log") {
        val random = Random(4)
        repeat(PropertyTesting.defaultIterationCount) {
            val log = TestLog()
            for (id in 1..3) log.start(id, "t$id", "int64")
            // Times go back occasionally, and some are from before the clock began.
            repeat(20) { step ->
                val micros = if (random.nextInt(12) == 0) -5L * step else step * 500_000L - random.nextInt(2) * 700_000L
                log.record(1 + random.nextInt(3), micros, longs(step.toLong()))
            }
            val whole = recordsOf(log.bytes)
            val spans = listOf(Span(random.nextInt(12) * 0.25 + 0.125, 3.25), Span(4.0, 4.0 + random.nextInt(10) * 0.25))
            val part = recordsOf(written { RecordCopy(whole, sink = it).spans(spans, { false }) })
            fun heldAt(entry: RecordEntry, time: Double) = (0 until entry.size)
                .lastOrNull { entry.time(it) <= time }?.let { entry.payload(it).toList() }
            for ((entry, kept) in whole.entries.zip(part.entries)) {
                for (span in spans) {
                    var time = span.from
                    while (time <= span.to) {
                        heldAt(kept, time) shouldBe heldAt(entry, time)
                        time += 0.125
                    }
                }
                List(kept.size, kept::time).all { time -> spans.any { time in it } } shouldBe true
            }
        }
    }

    test("changes are the records that differ from the previous one, and all events") {
        val log = typed().record(2, 1_000_000, doubles(1.0, 2.0)).string(5, 1_000_000, "ready").record(2, 2_000_000, doubles(1.0, 2.0))
            .string(5, 2_000_000, "ready").record(4, 2_000_000, byteArrayOf(1)).record(2, 3_000_000, doubles(1.0, 2.5)).record(2, 4_000_000, doubles(1.0, 2.0))
        val expected = typed().record(2, 1_000_000, doubles(1.0, 2.0)).string(5, 1_000_000, "ready").string(5, 2_000_000, "ready")
            .record(4, 2_000_000, byteArrayOf(1)).record(2, 3_000_000, doubles(1.0, 2.5)).record(2, 4_000_000, doubles(1.0, 2.0))
        var repeats = 0
        val bytes = copyOf(log.bytes) { repeats = changes { it.name == "Said" } }
        bytes.toList() shouldBe expected.bytes.toList()
        repeats shouldBe 1
    }

    test("a merge has the payloads of all logs in the order of time, and shared ones only once") {
        val one = recordsOf(typed().record(2, 1_000_000, doubles(1.0, 2.0)).record(3, 2_000_000, longs(BIG)).record(4, 3_000_000, byteArrayOf(1)).bytes)
        val two = recordsOf(typed().record(3, 1_000_000, longs(BIG)).record(2, 1_500_000, doubles(3.0, 4.0)).record(3, 9_000_000, longs(7)).bytes)
        val lanes = one.entries.zip(two.entries).map { (a, b) -> MergedEntry(a.name, listOf(RecordPiece(a), RecordPiece(b, 1_000_000.0))) }
        val merge = RecordMerge(lanes)
        val merged = recordsOf(written { merge.write(sink = it) })
        merge.repeated shouldContainExactly listOf(0, 0, 1, 0, 0)
        merged.entries.map { "${it.name} ${it.type} ${it.metadata}" } shouldContainExactly one.entries.map { "${it.name} ${it.type} ${it.metadata}" }
        fun held(index: Int) = merged.entries[index].let { entry -> List(entry.size) { entry.time(it) to entry.payload(it).toList() } }
        held(1) shouldContainExactly listOf(1.0 to doubles(1.0, 2.0).toList(), 2.5 to doubles(3.0, 4.0).toList())
        held(2) shouldContainExactly listOf(2.0 to longs(BIG).toList(), 10.0 to longs(7).toList())
        held(3) shouldContainExactly listOf(3.0 to listOf<Byte>(1))
    }

    test("a merge of one log reads as that log") {
        val log = recordsOf(VARIED_LOG.bytes)
        val merged = written { sink -> RecordMerge(log.entries.map { MergedEntry(it.name, listOf(RecordPiece(it))) }).write(sink = sink) }
        val all = written { RecordCopy(log, sink = it).all() }
        fun described(bytes: ByteArray) = describeLog(parseLog(bytes)).lines().filter { "UNKNOWN" !in it && "EARLY" !in it && "goes back" !in it }
        described(merged) shouldContainExactly described(all)
    }
})
