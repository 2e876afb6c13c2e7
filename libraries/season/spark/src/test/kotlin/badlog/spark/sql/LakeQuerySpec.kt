package badlog.spark.sql

import badlog.files.inFolder
import badlog.formats.wpilog.TestLog
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.season.answerOf
import badlog.season.lake.LakeException
import badlog.season.matchBag
import badlog.season.put
import badlog.season.refresh
import badlog.season.written
import badlog.spark.LocalSpark
import badlog.spark.SPARK_IS_HERE
import badlog.spark.lake.SparkLake
import badlog.spark.program.Jobs
import badlog.spark.program.UsageException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.maps.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.apache.spark.sql.SparkSession
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.readText

private val SESSION by lazy { SparkSession.builder().sparkContext(LocalSpark.context.sc()).getOrCreate() }

/** Returns Spark's answer in the form in which `answerOf` returns DuckDB's. */
private fun sparkAnswer(lake: Path, sql: String): String = LakeQuery(SESSION, "$lake").ask(sql).collectAsList().joinToString("\n") { row ->
    (0 until row.length()).joinToString("|") { column -> row.get(column).let { if (it is String) "\"$it\"" else "$it" } }
}

private fun inLake(work: (Path) -> Unit) = inFolder { folder ->
    for (match in 1..4) (folder / "logs").put("q$match.bag", matchBag(match, 12.5, 11.5 - match, event = "Mill/Creek ü ${match % 2}"))
    // A topic with numbers in one log and texts in another, and one with another letter case.
    (folder / "logs").put("mixed.csv", "Time,System/Battery Voltage,Extra\n0,low,1\n1,high,2\n")
    (folder / "logs").put("case.csv", "Time,EXTRA\n0,5\n1,6\n")
    (folder / "logs").put("one.wpilog", TestLog().start(1, "/Arm", "double").double(1, 1_000_000, 1.5).double(1, 2_000_000, 2.5).bytes)
    refresh(folder / "logs", folder / "lake")
    work(folder)
}

class LakeQuerySpec : FunSpec({
    test("Spark and DuckDB have the same answers about every table").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inLake { folder ->
            val queries = listOf(
                "SELECT log, season, event, type, number, title, duration, format, salvaged FROM matches ORDER BY log",
                "SELECT log, topic, stored, column_name, unit, kind, samples FROM topics ORDER BY log, topic",
                "SELECT log, topic, count, min, max, mean, median FROM statistics ORDER BY log, topic",
                "SELECT event, number, t, \"System/Battery Voltage\" FROM samples WHERE number > 1 ORDER BY number, t",
                "SELECT log, t, \"System/Battery Voltage\" FROM samples WHERE log = 'mixed.csv' ORDER BY t",
                "SELECT log, sum(extra) FROM samples GROUP BY log ORDER BY log",
                "SELECT topic, t, value, text FROM series ORDER BY topic, t",
                "SELECT number, \"System/Battery Voltage\".min AS lowest FROM match_statistics WHERE number IS NOT NULL ORDER BY lowest",
                "SELECT log, \"EXTRA\".min AS upper, \"Extra (2)\".min AS lower FROM match_statistics ORDER BY log",
                "SELECT log, rule, severity, t, text, next, span_count FROM findings ORDER BY log, t, rule",
                "SELECT log, topic, t, text FROM events ORDER BY log, t",
            )
            for (sql in queries) {
                withClue(sql) { sparkAnswer(folder / "lake", sql) shouldBe answerOf(folder / "lake", sql) }
            }
        }
    }

    test("a wrong query, and a folder that is not a lake, are refused with a reason").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inLake { folder ->
            shouldThrow<org.apache.spark.sql.AnalysisException> { sparkAnswer(folder / "lake", "SELECT nothing FROM matches") }
                .message shouldContain "nothing"
            shouldThrow<LakeException> { LakeQuery(SESSION, "${folder / "logs"}") }.message shouldContain "not a lake"
        }
    }

    test("rules run over logs, and over the logs of a lake, without their samples").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inLake { folder ->
            val rules = (folder / "low.toml").also {
                (folder).put("low.toml", "[[rule]]\nname = \"Low battery\"\nseverity = \"warning\"\nwhen = \"min(battery) < 9\"\ntext = \"low\"\n")
            }
            val lines = ArrayList<String>()
            Jobs(SESSION, lines::add).rules(listOf("${folder / "logs"}", "--rules", "$rules", "--out", "${folder / "found"}"))
            Jobs(SESSION, lines::add).rules(listOf("${folder / "lake"}", "--rules", "$rules", "--out", "${folder / "again"}"))
            lines.single { it.startsWith("${folder / "found"}: ") } shouldContain "7 written"
            val findings = "SELECT log, rule FROM findings ORDER BY log"
            sparkAnswer(folder / "found", findings) shouldBe "\"q3.bag\"|\"Low battery\"\n\"q4.bag\"|\"Low battery\""
            sparkAnswer(folder / "again", findings) shouldBe sparkAnswer(folder / "found", findings)
            (folder / "found").written().filterKeys { it.startsWith("samples/") || it.startsWith("series/") } shouldBe emptyMap()
            // A lake with samples differs from the existing one.
            SparkLake(LocalSpark.context, "${folder / "found"}").refresh(listOf("${folder / "logs"}"), RuleSet.BUILT_IN).written shouldBe 7
            (folder / "found").written().filterKeys { it.startsWith("samples/") }.shouldNotBeEmpty()
        }
    }

    test("an answer is written as files, and a wrong option is refused").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inLake { folder ->
            val lines = ArrayList<String>()
            val query = "SELECT number FROM matches WHERE number IS NOT NULL ORDER BY number"
            Jobs(SESSION, lines::add).sql(listOf("${folder / "lake"}", query, "--out", "${folder / "answer"}", "--format", "csv"))
            lines shouldContain "The answer is in ${folder / "answer"}."
            (folder / "answer").toFile().walk().filter { it.extension == "csv" }.joinToString("") { it.toPath().readText() } shouldBe "number\n1\n2\n3\n4\n"
            val wrongCalls = listOf(
                listOf("${folder / "lake"}"),
                listOf("${folder / "lake"}", query, "--out", "x", "--format", "xlsx"),
                listOf("${folder / "lake"}", query, "--into", "x"),
                listOf("${folder / "lake"}", query, "--out"),
            )
            for (words in wrongCalls) {
                shouldThrow<UsageException> { Jobs(SESSION, lines::add).sql(words) }
            }
            shouldThrow<UsageException> { Jobs(SESSION, lines::add).lake(listOf("logs", "--out", "x", "--max-size", "large")) }
                .message shouldContain "number of MB"
        }
    }
})
