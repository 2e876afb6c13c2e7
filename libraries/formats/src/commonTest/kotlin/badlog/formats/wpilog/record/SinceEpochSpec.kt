package badlog.formats.wpilog.record

import badlog.core.analysis.Span
import badlog.core.recording.Recording
import badlog.core.recording.Value
import badlog.formats.wpilog.TestLog
import badlog.formats.wpilog.longs
import badlog.formats.wpilog.parseLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll

/** A moment as the clock of a laptop counts it, in µs since 1970. */
private const val START = 1_795_832_420_123_456

private fun Recording.times(name: String) = topics.first { it.name == name }.times?.toList()

private fun log(vararg micros: Long) = TestLog().start(1, "A", "double", at = START).apply { for (at in micros) double(1, START + at, at / 1e6) }

/** The logs of servers on laptops, with times since 1970. */
class SinceEpochSpec : FunSpec({
    test("times since 1970 begin at 0, and Start Time says when that was") {
        val recording = parseLog(log(0, 20_001, 3_600_000_001).bytes)
        recording.times("A") shouldBe listOf(0.0, 0.020001, 3600.000001)
        recording.values shouldBe listOf(Value("Start Time", "2026-11-28 02:20:20 UTC"))
        recording.problems shouldBe emptyList()
    }

    test("every whole microsecond is kept, in any order, with values from before the clock was set at the start") {
        checkAll(Arb.list(Arb.long(0L..50_000_000), 1..20)) { offsets ->
            val recording = parseLog(log(*offsets.toLongArray()).double(1, -7, -1.0).bytes)
            val least = offsets.min()
            recording.times("A") shouldBe (listOf(0.0) + offsets.sorted().map { (it - least) / 1e6 })
        }
    }

    test("a clock that the log has is better than its times") {
        val recording = parseLog(log(0).start(2, "systemTime", "int64").record(2, START + 5_000_000, longs(START + 65_000_000)).bytes)
        recording.values shouldBe listOf(Value("Start Time", "2026-11-28 02:21:20 UTC"))
    }

    test("times that count from the start of a robot, or from no year of today, stay as they are") {
        for (first in listOf(0L, 5_000_000L, 999_999_999_000_000, 4_100_000_000_000_000)) {
            val recording = parseLog(TestLog().start(1, "A", "double").double(1, first, 1.0).double(1, first + 1_000_000, 2.0).bytes)
            recording.times("A") shouldBe listOf(first / 1e6, first / 1e6 + 1)
            recording.values shouldBe emptyList()
        }
    }

    test("a part is named by the times that the log shows, and its records keep theirs") {
        val part = written { sink ->
            RecordCopy(recordsOf(log(0, 10_000_000, 12_000_000, 30_000_000).bytes), sink = sink).spans(listOf(Span(9.0, 20.0)), { false })
        }
        // The value of 0 s holds at 9 s.
        part.toList() shouldBe TestLog().start(1, "A", "double", at = START).double(1, START + 9_000_000, 0.0)
            .double(1, START + 10_000_000, 10.0).double(1, START + 12_000_000, 12.0).bytes.toList()
        parseLog(part).values shouldBe listOf(Value("Start Time", "2026-11-28 02:20:29 UTC"))
    }

    test("two logs of one clock are merged by it, and another one is moved to the requested time") {
        val first = recordsOf(log(0, 1_000_000).bytes).entries.single()
        val second = recordsOf(log(60_000_000).bytes).entries.single()
        val robot = recordsOf(TestLog().start(1, "R", "double").double(1, 2_000_000, 1.0).bytes).entries.single()
        fun merged(vararg entries: MergedEntry) = parseLog(written { sink -> RecordMerge(entries.toList()).write(sink = sink) })
        merged(MergedEntry("A", listOf(RecordPiece(first), RecordPiece(second)))).times("A") shouldBe listOf(0.0, 1.0, 60.0)
        merged(MergedEntry("A", listOf(RecordPiece(first))), MergedEntry("B", listOf(RecordPiece(second, 5e6)))).times("B") shouldBe listOf(5.0)
        val beside = merged(MergedEntry("R", listOf(RecordPiece(robot, 3e6))), MergedEntry("A", listOf(RecordPiece(first))))
        beside.times("R") shouldBe listOf(5.0)
        beside.times("A") shouldBe listOf(0.0, 1.0)
        beside.values shouldBe listOf(Value("Start Time", "2026-11-28 02:20:20 UTC"))
    }
})
