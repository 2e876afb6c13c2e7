package badlog.spark

import badlog.season.lake.Lake
import badlog.season.sql.LakeDatabase
import badlog.season.written
import io.kotest.assertions.withClue
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import java.nio.file.Path

/** The tables with many rows; only a hash of each row is compared. */
private val MANY = listOf("samples", "series")
private val ALWAYS_THERE = listOf("samples", "statistics", "matches", "topics")

/** Compares two lakes: their files by name, and each table by its columns and row by row. */
internal infix fun Path.shouldEqualLake(expected: Path) {
    written().keys.sorted() shouldBe expected.written().keys.filter { it != ".lock" }.sorted()
    for (table in ALWAYS_THERE + listOf("series", "events", "findings")) {
        withClue("$table of $this") {
            columnsOf(this, table) shouldBe columnsOf(expected, table)
            val rows = rowsOf(this, table)
            val wanted = rowsOf(expected, table)
            if (table in ALWAYS_THERE) wanted.shouldNotBeEmpty()
            // As sets first, for a short failure message.
            (rows - wanted.toSet()).take(2).shouldBeEmpty()
            (wanted - rows.toSet()).take(2).shouldBeEmpty()
            (rows == wanted) shouldBe true
        }
    }
}

private fun columnsOf(lake: Path, table: String): List<String> = LakeDatabase.open(Lake(lake)).use { database ->
    buildList { database.query("SELECT * FROM $table LIMIT 0", { all -> all.mapTo(this) { "${it.name} ${it.type}" } }) { true } }
}

/** The rows of [table], sorted. */
private fun rowsOf(lake: Path, table: String): List<String> = LakeDatabase.open(Lake(lake)).use { database ->
    val row = if (table in MANY) "md5(CAST($table AS VARCHAR))" else "*"
    buildList { database.query("SELECT $row FROM $table ORDER BY ALL", {}) { add(it.joinToString("|")) } }
}
