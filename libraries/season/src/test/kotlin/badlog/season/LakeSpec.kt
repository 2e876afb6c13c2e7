package badlog.season

import badlog.core.bag.VARIED_BAG
import badlog.files.inFolder
import badlog.formats.wpilog.TestLog
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.season.lake.Lake
import badlog.season.lake.LakeException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.WRITE
import kotlin.io.path.deleteExisting
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.writeText

@Tags("InCheck")
class LakeSpec : FunSpec({
    test("a bag becomes a table with a row for each of its rows: numbers, flags, texts and gaps") {
        inFolder { folder ->
            (folder / "logs").put("match.bag", VARIED_BAG)
            refresh(folder / "logs", folder / "lake").written shouldBe 1
            answerOf(folder / "lake", """SELECT log, t, "Arm/Angle", "Log (2)", "Enabled" FROM samples ORDER BY t""") shouldBe """
                "match.bag"|0.0|12.346|null|false
                "match.bag"|0.02|-123460.0|"armed, ready"|false
                "match.bag"|0.04|null|"said \"go\"\ntwice"|true
                "match.bag"|0.06|1.0E-5|null|true
                "match.bag"|0.08|null|"Ω ready"|true
                "match.bag"|0.1|99.0|null|true
            """.trimIndent()
            answerOf(folder / "lake", "SELECT topic, t, text FROM events ORDER BY t") shouldBe """
                "Log"|0.02|"armed, ready"
                "Log"|0.04|"said \"go\"\ntwice"
                "Log"|0.08|"Ω ready"
            """.trimIndent()
            answerOf(folder / "lake", "SELECT topic, stored, column_name, unit, kind FROM topics ORDER BY ALL") shouldContain
                """"Arm/Angle"|"samples"|"Arm/Angle"|"deg"|"numeric""""
        }
    }

    test("each log is in the folder of its season and event, with times in UTC, its header values and statistics") {
        inFolder { folder ->
            (folder / "logs").put("a/one.bag", matchBag(7, 12.5, 12.0, 11.0, event = "Mill/Creek ü"))
            (folder / "logs").put("plain.csv", "Time,Voltage\n0,1\n1,2\n")
            refresh(folder / "logs", folder / "lake").written shouldBe 2
            (folder / "lake/samples/season=2025/event=Mill%2FCreek%20%C3%BC/a%2Fone.bag.parquet").exists() shouldBe true
            (folder / "lake/samples/season=__HIVE_DEFAULT_PARTITION__/event=__HIVE_DEFAULT_PARTITION__/plain.csv.parquet").exists() shouldBe true
            answerOf(
                folder / "lake",
                "SELECT log, season, event, type, number, title, start, duration, header['Match Number'] FROM matches ORDER BY log",
            ) shouldBe """
                "a/one.bag"|2025|"Mill/Creek ü"|"Qualification"|7|"Mill/Creek ü Qualification 7"|"2025-03-14T10:00:00Z"|0.2|"7"
                "plain.csv"|null|null|null|null|null|null|null|null
            """.trimIndent()
            answerOf(folder / "lake", """SELECT event, number, timestamp FROM samples WHERE "System/Battery Voltage" = 12""") shouldBe
                """"Mill/Creek ü"|7|"2025-03-14T10:00:00.100Z""""
            answerOf(folder / "lake", "SELECT unit, count, min, max, first, last FROM statistics WHERE topic LIKE '%Voltage' AND unit = 'V'") shouldBe
                """"V"|3|11.0|12.5|12.5|11.0"""
        }
    }

    test("topics with times of their own keep each sample") {
        inFolder { folder ->
            val log = TestLog().start(1, "/Arm/Angle", "double").start(2, "/State", "string")
                .double(1, 1_000_000, 1.5).string(2, 1_500_000, "up").double(1, 2_000_000, 2.5).string(2, 2_500_000, "down")
            (folder / "logs").put("one.wpilog", log.bytes)
            refresh(folder / "logs", folder / "lake").written shouldBe 1
            answerOf(folder / "lake", "SELECT topic, t, value, text FROM series ORDER BY topic, t") shouldBe """
                "/Arm/Angle"|1.0|1.5|null
                "/Arm/Angle"|2.0|2.5|null
                "/State"|1.5|null|"up"
                "/State"|2.5|null|"down"
            """.trimIndent()
        }
    }

    test("a refresh without changes writes no files") {
        inFolder { folder ->
            (folder / "logs").put("one.bag", matchBag(1, 12.0))
            (folder / "logs").put("notes.bag", ByteArray(5000) { (it * 31).toByte() })
            refresh(folder / "logs", folder / "lake")
            val before = (folder / "lake").written()
            val result = refresh(folder / "logs", folder / "lake") { _, _ -> error("Something was read.") }
            result.written shouldBe 0
            result.unchanged shouldBe 1
            result.outcomes.count { it.isNoLog } shouldBe 1
            (folder / "lake").written() shouldBe before
        }
    }

    test("only changed logs are rewritten, and deleted ones are removed from the lake") {
        inFolder { folder ->
            val logs = folder / "logs"
            val lake = folder / "lake"
            val one = logs.put("one.bag", matchBag(1, 12.0, 11.0))
            logs.put("two.bag", matchBag(2, 12.0, 10.0))
            val three = logs.put("three.bag", matchBag(3, 12.0, 9.0, event = "Elsewhere"))
            refresh(logs, lake).written shouldBe 3
            val before = lake.written()
            Files.writeString(one, "0.2,8.0\n", APPEND)
            three.deleteExisting()
            val result = refresh(logs, lake)
            result.written shouldBe 1
            result.removed shouldBe 1
            answerOf(lake, "SELECT log, min FROM statistics WHERE topic LIKE 'System%' ORDER BY log") shouldBe
                "\"one.bag\"|8.0\n\"two.bag\"|10.0"
            answerOf(lake, "SELECT log FROM matches ORDER BY log") shouldBe "\"one.bag\"\n\"two.bag\""
            val after = lake.written()
            after.filterKeys { "two.bag" in it } shouldBe before.filterKeys { "two.bag" in it }
            after.keys.filter { "three.bag" in it || "Elsewhere" in it }.shouldBeEmpty()
        }
    }

    test("damaged, cut and empty logs are in the lake with their problems and their readable samples") {
        inFolder { folder ->
            val logs = folder / "logs"
            logs.put("cut.bag", matchBag(1, 12.0, 11.0) + "0.2")
            logs.put("gap.bag", matchBag(2, 12.0) + "\u0000".repeat(300) + "0.3,9.5\n")
            logs.put("header.bag", matchBag(3).lines().first() + "\n")
            logs.put("cut.bag.gz", (SAMPLE_LOGS / "qualification-57.bag.gz").readBytes().copyOf(20_000))
            val result = refresh(logs, folder / "lake")
            result.outcomes.mapNotNull { it.message }.shouldBeEmpty()
            answerOf(folder / "lake", "SELECT log, salvaged, len(problems) > 0 FROM matches ORDER BY log") shouldBe """
                "cut.bag"|true|true
                "cut.bag.gz"|true|true
                "gap.bag"|true|true
                "header.bag"|false|true
            """.trimIndent()
            answerOf(folder / "lake", """SELECT log, t, "System/Battery Voltage" FROM samples WHERE log IN ('cut.bag', 'gap.bag') ORDER BY ALL""") shouldBe """
                "cut.bag"|0.0|12.0
                "cut.bag"|0.1|11.0
                "gap.bag"|0.0|12.0
                "gap.bag"|0.3|9.5
            """.trimIndent()
        }
    }

    test("an interrupted run leaves a readable lake, and the next run completes it") {
        inFolder { folder ->
            // More than are ever read ahead of the first unfinished one.
            val matches = 10 + 4 * Runtime.getRuntime().availableProcessors()
            for (match in 1..matches) (folder / "logs").put("q$match.bag", matchBag(match, 12.0, 11.0))
            val stop = IllegalStateException("stop")
            shouldThrow<IllegalStateException> {
                refresh(folder / "logs", folder / "lake", batch = 1) { done, _ -> if (done == 4) throw stop }
            } shouldBe stop
            val there = rowsOf(folder / "lake", "SELECT log FROM matches").size
            (there in 4 until matches) shouldBe true
            (folder / "lake").written().keys.filter { ".part" in it }.shouldBeEmpty()
            rowsOf(folder / "lake", "SELECT DISTINCT log FROM samples").size shouldBe there
            val rest = refresh(folder / "logs", folder / "lake")
            rest.written shouldBe matches - there
            rowsOf(folder / "lake", "SELECT log, topic FROM statistics").size shouldBe matches * 2
        }
    }

    test("the first logs are soon in the tables, so that a program killed early keeps them") {
        inFolder { folder ->
            for (match in 1..20) (folder / "logs").put("q$match.bag", matchBag(match, 12.0, 11.0))
            val there = HashMap<Int, Int>()
            refresh(folder / "logs", folder / "lake") { done, _ ->
                if (done in setOf(4, 8, 16)) there.getOrPut(done) { rowsOf(folder / "lake", "SELECT log FROM matches").size }
            }
            there.filter { (done, logs) -> logs >= done / 2 }.keys shouldBe setOf(4, 8, 16)
        }
    }

    test("leftovers of a killed run are overwritten or removed, and no reader sees them") {
        inFolder { folder ->
            (folder / "logs").put("one.bag", matchBag(1, 12.0))
            refresh(folder / "logs", folder / "lake")
            val draft = (folder / "lake/samples").put(".badlog-1234.part", "half a file")
            answerOf(folder / "lake", "SELECT count(*) FROM samples") shouldBe "1"
            (folder / "logs").put("two.bag", matchBag(2, 12.0))
            refresh(folder / "logs", folder / "lake")
            draft.exists() shouldBe false
        }
    }

    test("a file of a log that was deleted from the lake is made again") {
        inFolder { folder ->
            (folder / "logs").put("one.bag", matchBag(1, 12.0))
            refresh(folder / "logs", folder / "lake")
            val file = (folder / "lake").written().keys.single { it.startsWith("samples") }
            (folder / "lake" / file).deleteExisting()
            refresh(folder / "logs", folder / "lake").written shouldBe 1
            (folder / "lake" / file).exists() shouldBe true
        }
    }

    test("logs of one name from two folders have two names in the lake, and keep them") {
        inFolder { folder ->
            (folder / "a").put("q1.bag", matchBag(1, 12.0))
            (folder / "b").put("Q1.bag", matchBag(2, 12.0))
            val both = lakeLogs(folder / "a") + lakeLogs(folder / "b")
            val roots = listOf(folder / "a", folder / "b")
            repeat(2) {
                Lake(folder / "lake").refresh(both, roots, RuleSet.BUILT_IN)
            }
            refresh(folder / "b", folder / "lake").removed shouldBe 0
            answerOf(folder / "lake", "SELECT log, number FROM matches ORDER BY number") shouldBe "\"q1.bag\"|1\n\"Q1.bag (2)\"|2"
        }
    }

    test("topics named like fixed columns, or like each other except for case, have columns of their own") {
        inFolder { folder ->
            (folder / "logs").put("odd.csv", "T,t,log,\"a\"\"b; DROP TABLE x\",A,a\n0,1,2,3,4,5\n1,6,7,8,9,10\n")
            refresh(folder / "logs", folder / "lake")
            answerOf(folder / "lake", "SELECT topic, column_name FROM topics ORDER BY column_name") shouldContain "\"a\"|\"a (2)\""
            answerOf(folder / "lake", """SELECT "T (2)", "t (3)", "log (2)", "a""b; DROP TABLE x", "A", "a (2)" FROM samples WHERE t = 1""") shouldBe
                "1.0|6.0|7.0|8.0|9.0|10.0"
        }
    }

    test("a folder with other files in it and a lake of another version are not changed") {
        inFolder { folder ->
            (folder / "logs").put("one.bag", matchBag(1, 12.0))
            (folder / "mine").put("thesis.txt", "mine")
            shouldThrow<LakeException> { refresh(folder / "logs", folder / "mine") }.message shouldContain "other files"
            (folder / "mine").written().keys.toList() shouldBe listOf("thesis.txt")
            refresh(folder / "logs", folder / "lake")
            (folder / "lake/lake.json").writeText("""{"format":"badlog-lake","version":99}""")
            shouldThrow<LakeException> { refresh(folder / "logs", folder / "lake") }.message shouldContain "version 99"
        }
    }

    test("a lake that another badlog writes to is refused, or waited for") {
        inFolder { folder ->
            (folder / "logs").put("one.bag", matchBag(1, 12.0))
            refresh(folder / "logs", folder / "lake")
            FileChannel.open(folder / "lake/.lock", WRITE).use { channel ->
                val lock = channel.lock()
                shouldThrow<LakeException> { refresh(folder / "logs", folder / "lake") }.message shouldContain "Another badlog"
                var asked = 0
                val isBusy = {
                    if (++asked == 3) lock.release()
                    true
                }
                Lake(folder / "lake").refresh(lakeLogs(folder / "logs"), listOf(folder / "logs"), RuleSet.BUILT_IN, isBusy = isBusy).unchanged shouldBe 1
                asked shouldBe 3
            }
        }
    }
})
