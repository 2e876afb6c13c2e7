package badlog.season

import badlog.core.analysis.LogView
import badlog.core.python.TestPython
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.TestLog
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.season.engine.Engine
import badlog.season.lake.LakeException
import badlog.season.lake.ParquetFile
import badlog.season.lake.ParquetWriter
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.Json
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.name

private val PYTHON = TestPython("pandas, pyarrow", "pandas and pyarrow")

@Tags("InCheck")
class ParquetWriterSpec : FunSpec({
    fun written(log: Path, target: Path): List<ParquetFile> = ParquetWriter().use {
        it.write(LogView.of(readRecording(log, LOG_FORMATS)), log.name, log.name, RuleSet.BUILT_IN.signals, target)
    }

    /** Returns the rows that DuckDB reads for [sql], one line each. */
    fun rows(sql: String): List<String> = Engine(memoryMegabytes = null, threads = 1).use { engine ->
        engine.connected { connection ->
            connection.createStatement().use { statement ->
                statement.executeQuery(sql).use { rows ->
                    buildList { while (rows.next()) add((1..rows.metaData.columnCount).joinToString("|") { "${rows.getObject(it)}" }) }
                }
            }
        }
    }

    test("DuckDB reads the same columns and rows from a single log as from a lake") {
        inFolder { folder ->
            val wpilog = TestLog().start(1, "/Arm/Angle", "double").start(2, "/State", "string")
                .double(1, 1_000_000, 1.5).string(2, 1_500_000, "up").double(1, 2_000_000, 2.5)
            (folder / "logs").put("q1.bag", matchBag(1, 12.5, 11.5))
            (folder / "logs").put("practice.bag", sampleText("practice.bag"))
            (folder / "logs").put("one.wpilog", wpilog.bytes)
            refresh(folder / "logs", folder / "lake")
            val inLake = (folder / "lake").written().keys.filter { it.startsWith("samples/") || it.startsWith("series/") }.associateBy { it.substringAfterLast('/') }
            for (name in listOf("q1.bag", "practice.bag", "one.wpilog")) {
                val file = written(folder / "logs" / name, folder / "own" / "$name.parquet").single()
                val other = "read_parquet('${folder / "lake" / inLake.getValue("$name.parquet")}', hive_partitioning = false)"
                val own = "read_parquet('${file.path}')"
                rows("DESCRIBE SELECT * FROM $own") shouldContainExactly rows("DESCRIBE SELECT * FROM $other")
                rows("(FROM $own EXCEPT ALL FROM $other) UNION ALL (FROM $other EXCEPT ALL FROM $own)").shouldBeEmpty()
                rows("SELECT count(*) FROM $own") shouldContainExactly listOf("${file.rows}")
                val metadata = "SELECT decode(value) FROM parquet_kv_metadata"
                rows("$metadata('${file.path}')") shouldContainExactly rows("$metadata('${folder / "lake" / inLake.getValue("$name.parquet")}')")
            }
        }
    }

    test("pandas reads a single log with the units from its file").config(enabledOrReasonIf = PYTHON.isHere) {
        inFolder { folder ->
            val file = written(folder.put("q1.bag", matchBag(1, 12.5, 11.5)), folder / "q1.parquet").single()
            val python = PYTHON.running("src/test/python/read_log.py", "${file.path}")
            val output = python.inputStream.readAllBytes().decodeToString()
            python.waitFor() shouldBe 0
            Json.parseToJsonElement(output) shouldBe Json.parseToJsonElement(
                """{"columns": ["log", "type", "number", "t", "timestamp", "System/Battery Voltage"], "lowest": 11.5, "start": "2025-03-14T10:00:00+00:00", "unit": "V"}""",
            )
        }
    }

    test("a log without samples makes no file, and a missing folder is reported") {
        inFolder { folder ->
            val empty = folder.put("header.bag", matchBag(3).lines().first() + "\n")
            written(empty, folder / "header.parquet").shouldBeEmpty()
            val log = folder.put("q1.bag", matchBag(1, 12.0))
            shouldThrow<LakeException> { written(log, log / "q1.parquet") }.message shouldContain "is a file, not a folder; rename that file"
        }
    }
})
