package badlog.season

import badlog.files.inFolder
import badlog.season.lake.Lake
import badlog.season.lake.LakeException
import badlog.season.sql.LakeDatabase
import badlog.season.sql.SqlException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.writeText

/** Symbolic links: on Windows only administrators make them. */
private val IF_LINKS =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows makes symbolic links for administrators only")

class LakeDatabaseSpec : FunSpec({
    fun <R> inLake(work: (Path, LakeDatabase) -> R): R = inFolder { folder ->
        (folder / "logs").put("q1.bag", matchBag(1, 12.5, 11.5))
        (folder / "logs").put("q2.bag", matchBag(2, 12.5, 6.5))
        refresh(folder / "logs", folder / "lake")
        LakeDatabase.open(Lake(folder / "lake")).use { work(folder, it) }
    }

    fun LakeDatabase.answer(sql: String): String = buildString {
        query(sql, { appendLine(it.joinToString("|") { column -> "${column.name} ${column.type}" }) }) { row ->
            appendLine(row.joinToString("|"))
            true
        }
    }.trimEnd()

    test("queries name topics by their names, over all logs, and statistics per match") {
        inLake { _, lake ->
            lake.answer("""SELECT event, number, min("System/Battery Voltage") AS lowest FROM samples GROUP BY ALL ORDER BY lowest""") shouldBe """
                event VARCHAR|number INTEGER|lowest DOUBLE
                "Mill Creek"|2|6.5
                "Mill Creek"|1|11.5
            """.trimIndent()
            lake.answer("""SELECT number, "System/Battery Voltage".min AS lowest FROM match_statistics ORDER BY number""") shouldBe """
                number INTEGER|lowest DOUBLE
                1|11.5
                2|6.5
            """.trimIndent()
        }
    }

    test("all usual forms of queries are understood") {
        inLake { _, lake ->
            val queries = listOf(
                "FROM matches",
                "WITH low AS (SELECT * FROM statistics WHERE min < 7) SELECT log FROM low;",
                "SELECT 1 -- a comment",
                "DESCRIBE matches",
                "SUMMARIZE statistics",
                "SELECT * FROM samples ASOF JOIN events USING (log, t)",
                "VALUES (1), (2)",
            )
            for (sql in queries) {
                withClue(sql) { lake.answer(sql).lines().first() shouldContain " " }
            }
        }
    }

    test("each table lists its columns, even if it is empty") {
        inLake { _, lake ->
            val tables = lake.tables().associateBy { it.name }
            tables.keys shouldContain "match_statistics"
            tables.getValue("series").columns.map { it.name } shouldContain "log"
            tables.getValue("samples").columns.map { it.name } shouldContain "System/Battery Voltage"
        }
    }

    test("a mistake is answered with DuckDB's message") {
        inLake { _, lake ->
            shouldThrow<SqlException> { lake.answer("SELEC 1") }.message shouldContain "syntax error"
            shouldThrow<SqlException> { lake.answer("SELECT nothing FROM matches") }.message shouldStartWith "Binder Error: Referenced column \"nothing\""
        }
    }

    test("only a single query is executed") {
        inLake { folder, lake ->
            val before = (folder / "lake").written()
            val queries = listOf(
                "CREATE TABLE x AS SELECT 1", "DROP VIEW matches", "INSERT INTO matches SELECT * FROM matches", "SET lock_configuration = false",
                "SET enable_external_access = true", "INSTALL httpfs", "LOAD httpfs", "ATTACH '${folder / "x.db"}'", "PRAGMA database_list",
                "COPY (SELECT 1) TO '${folder / "lake/x.parquet"}'", "EXPORT DATABASE '${folder / "lake/x"}'", "CALL pragma_version()",
                "SELECT 1; SELECT 2", "SELECT 1; COPY (SELECT 1) TO '${folder / "lake/x.parquet"}'", "",
                "EXPLAIN ANALYZE COPY (SELECT 1) TO '${folder / "lake/x.parquet"}'", "CHECKPOINT", "VACUUM", "BEGIN",
                "SELECT 1) TO '${folder / "lake/x.parquet"}' --",
            )
            for (sql in queries) {
                withClue(sql) { shouldThrow<SqlException> { lake.answer(sql) } }
            }
            (folder / "lake").written() shouldBe before
        }
    }

    test("no query can read another file or the network").config(enabledOrReasonIf = { IF_LINKS }) {
        inLake { folder, lake ->
            val secret = folder / "secret.csv"
            secret.writeText("word\nsesame\n")
            (folder / "lake2").put("secret.csv", "word\nsesame\n")
            Files.createSymbolicLink(folder / "lake/link.csv", secret)
            val queries = listOf(
                "FROM '$secret'", "SELECT * FROM read_csv('$secret')", "SELECT * FROM read_text('$secret')", "SELECT * FROM read_blob('/etc/hostname')",
                "SELECT * FROM read_csv('${folder / "lake"}/../secret.csv')", "SELECT * FROM read_csv('${folder / "lake2/secret.csv"}')",
                "SELECT * FROM glob('/etc/*')", "SELECT * FROM read_json('$secret')", "SELECT * FROM sniff_csv('$secret')",
                "SELECT * FROM read_parquet('https://example.org/x.parquet')", "SELECT * FROM 'http://127.0.0.1:9/x.csv'",
                "SELECT * FROM read_csv('s3://bucket/x.csv')", "SELECT * FROM parquet_metadata('$secret')", "SELECT getenv('HOME')",
                "SELECT * FROM query('SELECT * FROM read_csv(''$secret'')')",
            )
            for (sql in queries) {
                withClue(sql) { shouldThrow<SqlException> { lake.answer(sql) } }
            }
        }
    }

    test("an answer can be written to the named Parquet file only") {
        inLake { folder, lake ->
            shouldThrow<IllegalStateException> { lake.writeParquet("SELECT 1") }
            LakeDatabase.open(Lake(folder / "lake"), folder / "answer.parquet").use { database ->
                database.writeParquet("SELECT log, min FROM statistics ORDER BY min -- worst first") shouldBe 4
                shouldThrow<SqlException> { database.writeParquet("SELECT 1) TO '${folder / "other.parquet"}' --") }
            }
            (folder / "answer.parquet").exists() shouldBe true
            (folder / "other.parquet").exists() shouldBe false
        }
    }

    test("only a lake is opened") {
        inFolder { folder -> shouldThrow<LakeException> { LakeDatabase.open(Lake(folder)) }.message shouldContain "not a lake" }
    }
})
