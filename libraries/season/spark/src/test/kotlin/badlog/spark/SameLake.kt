package badlog.spark

import badlog.season.lake.Lake
import badlog.season.sql.LakeDatabase
import badlog.season.written
import io.kotest.assertions.withClue
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.nio.file.Path

private val TABLES = listOf("samples", "series", "statistics", "matches", "topics", "events", "findings")

/** Compares two lakes: their files by name, and each table row by row. */
internal infix fun Path.shouldBeTheLake(expected: Path) {
    written().keys.sorted() shouldBe expected.written().keys.filter { it != ".lock" }.sorted()
    for (table in TABLES) {
        val rows = rowsOf(this, table)
        val wanted = rowsOf(expected, table)
        withClue("$table of $this") {
            wanted.size shouldBeGreaterThan 1
            // As sets first, for a short message.
            (rows - wanted.toSet()).take(2).shouldBeEmpty()
            (wanted - rows.toSet()).take(2).shouldBeEmpty()
            rows shouldBe wanted
        }
    }
}

/** The columns of [table], then its rows in an order of their own. */
private fun rowsOf(lake: Path, table: String): List<String> = LakeDatabase.open(Lake(lake)).use { database ->
    buildList {
        database.query("SELECT * FROM $table ORDER BY ALL", { add(it.joinToString("|") { column -> "${column.name} ${column.type}" }) }) { row ->
            add(row.joinToString("|"))
        }
    }
}
