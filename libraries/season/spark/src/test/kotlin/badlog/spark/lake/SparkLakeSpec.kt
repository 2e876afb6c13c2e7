package badlog.spark.lake

import badlog.core.bag.VARIED_BAG
import badlog.files.inFolder
import badlog.formats.wpilog.TestLog
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.season.SAMPLE_LOGS
import badlog.season.answerOf
import badlog.season.lake.LakeException
import badlog.season.matchBag
import badlog.season.put
import badlog.season.refresh
import badlog.season.written
import badlog.spark.LocalSpark
import badlog.spark.SPARK_IS_HERE
import badlog.spark.shouldEqualLake
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteExisting
import kotlin.io.path.div
import kotlin.io.path.readBytes
import kotlin.io.path.writeText

private fun onSpark(logs: Path, lake: Path, maxBytes: Long = Long.MAX_VALUE): SparkLakeResult = SparkLake(LocalSpark.context, "$lake").refresh(listOf("$logs"), RuleSet.BUILT_IN, maxBytes)

/** Logs of all kinds, some of them damaged. */
private fun variedLogs(logs: Path) {
    logs.createDirectories()
    for (name in listOf("qualification-57.bag.gz", "elevator-bench.csv")) {
        (SAMPLE_LOGS / name).takeIf(Files::exists)?.copyTo(logs / name)
    }
    for (match in 1..12) logs.put("day ${match % 3}/q$match.bag", matchBag(match, 12.5, 11.0 - match / 10.0, event = "Mill/Creek ü ${match % 2}"))
    logs.put("varied.bag", VARIED_BAG)
    logs.put("same/VARIED.bag", VARIED_BAG)
    logs.put(
        "one.wpilog",
        TestLog().start(1, "/Arm/Angle", "double").start(2, "/State", "string")
            .double(1, 1_000_000, 1.5).string(2, 1_500_000, "up").double(1, 2_000_000, 2.5).string(2, 2_500_000, "down").bytes,
    )
    logs.put("cut.bag", matchBag(20, 12.0, 11.0) + "0.2")
    logs.put("cut.bag.gz", (SAMPLE_LOGS / "qualification-57.bag.gz").readBytes().copyOf(20_000))
    logs.put("notes.bag", ByteArray(5000) { (it * 31).toByte() })
    logs.put("empty.bag", "")
    logs.put(".hidden/q1.bag", matchBag(1, 12.0))
}

class SparkLakeSpec : FunSpec({
    test("Spark makes the same lake as one process, file by file and row by row").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inFolder { folder ->
            variedLogs(folder / "logs")
            val expected = refresh(folder / "logs", folder / "expected")
            val result = onSpark(folder / "logs", folder / "lake")
            result.written shouldBe expected.written
            result.salvaged shouldBe expected.outcomes.count { it.isSalvaged }
            result.refused.map { it.path to it.message }.toSet() shouldBe
                expected.outcomes.filter { it.message != null }.map { "${it.log.file.path}" to it.message }.toSet()
            folder / "lake" shouldEqualLake folder / "expected"
        }
    }

    test("a second run reads no logs, and one process can continue the lake that Spark made").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inFolder { folder ->
            variedLogs(folder / "logs")
            val first = onSpark(folder / "logs", folder / "lake")
            val before = (folder / "lake").written()
            val second = onSpark(folder / "logs", folder / "lake")
            second.written shouldBe 0
            second.unchanged shouldBe first.written
            second.refused.map { it.path }.toSet() shouldBe first.refused.map { it.path }.toSet()
            (folder / "lake").written() shouldBe before
            refresh(folder / "logs", folder / "lake").unchanged shouldBe first.written
        }
    }

    test("changed logs are rewritten, deleted ones removed, and a log with a new event is stored once")
        .config(enabledOrReasonIf = SPARK_IS_HERE) {
            inFolder { folder ->
                val logs = folder / "logs"
                variedLogs(logs)
                onSpark(logs, folder / "lake")
                Files.writeString(logs / "day 1/q1.bag", "0.2,8.0\n", APPEND)
                (logs / "day 2/q2.bag").writeText(matchBag(2, 12.0, 9.0, event = "Elsewhere"))
                (logs / "day 0/q3.bag").deleteExisting()
                val result = onSpark(logs, folder / "lake")
                result.written shouldBe 2
                result.removed shouldBe 1
                refresh(logs, folder / "expected")
                folder / "lake" shouldEqualLake folder / "expected"
            }
        }

    test("a file over the limit is reported and left out, and a lake that has it keeps it").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inFolder { folder ->
            val large = (folder / "logs").put("large.bag", matchBag(1, *DoubleArray(500) { 12.0 }))
            (folder / "logs").put("small.bag", matchBag(2, 12.0))
            val result = onSpark(folder / "logs", folder / "lake", maxBytes = 2_000)
            result.written shouldBe 1
            result.refused.single().run {
                path shouldBe "$large"
                message shouldContain "--max-size"
                isNoLog shouldBe false
            }
            onSpark(folder / "logs", folder / "lake").written shouldBe 1
            onSpark(folder / "logs", folder / "lake", maxBytes = 2_000).removed shouldBe 0
            answerOf(folder / "lake", "SELECT log FROM matches ORDER BY log") shouldBe "\"large.bag\"\n\"small.bag\""
        }
    }

    test("leftovers of killed tasks are removed, and no reader sees them").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inFolder { folder ->
            (folder / "logs").put("one.bag", matchBag(1, 12.0))
            onSpark(folder / "logs", folder / "lake")
            (folder / "lake/samples").put(".badlog-1234.part", "half a file")
            (folder / "logs").put("two.bag", matchBag(2, 12.0))
            onSpark(folder / "logs", folder / "lake").written shouldBe 1
            (folder / "lake").written().keys.filter { ".part" in it }.shouldBeEmpty()
        }
    }

    test("a folder with other files in it is not changed").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inFolder { folder ->
            (folder / "logs").put("one.bag", matchBag(1, 12.0))
            (folder / "mine").put("thesis.txt", "mine")
            shouldThrow<LakeException> { onSpark(folder / "logs", folder / "mine") }.message shouldContain "other files"
            (folder / "mine").written().keys.toList() shouldBe listOf("thesis.txt")
        }
    }
})
