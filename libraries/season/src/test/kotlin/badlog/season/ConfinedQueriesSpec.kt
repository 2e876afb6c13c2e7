package badlog.season

import badlog.files.inFolder
import badlog.season.lake.Lake
import badlog.season.sql.LakeDatabase
import badlog.season.sql.SqlException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Path
import kotlin.io.path.div

@Tags("InCheck")
class ConfinedQueriesSpec : FunSpec({
    fun inLake(work: (Path, LakeDatabase) -> Unit) = inFolder { folder ->
        (folder / "logs").put("q1.bag", matchBag(1, 12.5, 11.5))
        refresh(folder / "logs", folder / "lake")
        LakeDatabase.open(Lake(folder / "lake"), isConfined = true).use { work(folder, it) }
    }

    fun LakeDatabase.answer(sql: String): String = buildString {
        query(sql, { appendLine(it.joinToString("|") { column -> column.name }) }) { row ->
            appendLine(row.joinToString("|"))
            true
        }
    }.trimEnd()

    test("queries of the tables, with subqueries and unnesting, are answered") {
        inLake { _, lake ->
            lake.answer("SELECT number, \"System/Battery Voltage\".min AS lowest FROM match_statistics") shouldBe "number|lowest\n1|11.5"
            lake.answer("WITH low AS (SELECT * FROM statistics WHERE topic LIKE 'System%' AND min < 12), \"all\" AS (FROM low) SELECT count(*) AS n FROM \"all\" JOIN matches USING (log)") shouldBe "n\n1"
            lake.answer("SELECT m.log, f.unnest AS file FROM matches m, unnest(m.files) f") shouldContain "samples/"
            lake.answer("SELECT count(*) AS n FROM (VALUES (1), (2)) v, range(3)") shouldBe "n\n6"
            lake.answer("SELECT (SELECT max(t) FROM samples s WHERE s.log = m.log) AS until FROM matches m") shouldBe "until\n0.1"
            lake.answer("DESCRIBE matches") shouldContain "duration"
        }
    }

    test("no query learns where files are, or reads anything but the tables") {
        inLake { folder, lake ->
            val place = "${folder.toRealPath()}"
            lake.tables().single { it.name == "matches" }.columns.map { it.name } shouldNotContain "path"
            lake.answer("FROM matches") shouldNotContain place
            lake.answer("FROM match_statistics") shouldNotContain place
            val queries = listOf(
                "SELECT path FROM matches", "SELECT filename FROM matches", "FROM duckdb_views()", "FROM duckdb_views", "FROM duckdb_settings()",
                "SELECT current_setting('allowed_directories')", "SELECT (SELECT current_setting('temp_directory'))",
                "SELECT 1 ORDER BY current_setting('temp_directory')", "FROM read_parquet('$folder/lake/matches/*/*/*.parquet')",
                "FROM '$folder/lake/lake.json'", "FROM \"$folder/lake/matches/season=2025/event=Mill%20Creek/matches.parquet\"", "FROM glob('$folder/**')",
                "FROM parquet_metadata('$folder/lake/x.parquet')", "FROM information_schema.tables", "FROM pg_catalog.pg_views", "FROM pg_views",
                "FROM sqlite_master", "FROM pragma_database_list", "FROM main.matches", "FROM query('FROM duckdb_views()')", "FROM query_table('duckdb_views')",
                "WITH duckdb_views AS (SELECT 1) FROM duckdb_views", "SELECT * FROM (WITH pg_views AS (SELECT 1) FROM pg_views), pg_views",
                "WITH \"$folder/lake/lake.json\" AS (SELECT 1) SELECT 1", "SELECT (SELECT count(*) FROM duckdb_secrets())", "DESCRIBE duckdb_views", "SHOW ALL TABLES",
                "SELECT * FROM matches WHERE log IN (SELECT sql FROM duckdb_views())", "FROM badlog_table(1)", "SELECT getenv('HOME')",
                "FROM matches, LATERAL (FROM duckdb_settings())", "SUMMARIZE duckdb_settings()", "FROM json_execute_serialized_sql('{}')",
            )
            for (sql in queries) {
                withClue(sql) {
                    val said = shouldThrow<SqlException> { lake.answer(sql) }.message
                    if (place !in sql) said shouldNotContain place
                }
            }
        }
    }
})
