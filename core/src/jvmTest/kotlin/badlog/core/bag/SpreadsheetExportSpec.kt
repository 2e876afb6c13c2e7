package badlog.core.bag

import badlog.core.analysis.LogView
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.io.File

/** A season's real log as a spreadsheet tool exported it. It is not part of the project, so the test runs where `BADLOG_REAL_LOGS` names its folder. */
private val LOG = File(System.getenv("BADLOG_REAL_LOGS").orEmpty(), "FRC_TBD_bb075f7372c1ac20.csv")

class SpreadsheetExportSpec : FunSpec({
    test("a sparse CSV of 170 columns opens with every cell accounted for").config(
        enabledOrReasonIf = { if (LOG.exists()) Enabled.enabled else Enabled.disabled("the log is not on this machine") },
    ) {
        val recording = parse(LOG.readBytes())
        recording.topics.size shouldBe 170
        for (topic in recording.topics) topic.counts.total shouldBe recording.rowCount

        // Counted independently of the parser: by commas and quotes alone.
        val cells = LOG.readText().let(::cellsOf).drop(1)
        recording.rowCount shouldBe cells.size
        for ((column, topic) in recording.topics.withIndex()) {
            val texts = cells.map { it[column] }
            topic.counts.empty shouldBe texts.count { it.isBlank() || it.equals("null", ignoreCase = true) }
            topic.counts.truthValues shouldBe texts.count { it.lowercase() in setOf("true", "false") }
            topic.counts.numbers shouldBe texts.count { it.toDoubleOrNull()?.isFinite() == true }
        }
        LogView.of(recording).folders.sumOf { it.graphs.size + it.eventLogs.size } shouldBeGreaterThan 100
    }
})

private fun cellsOf(text: String): List<List<String>> {
    val rows = ArrayList<List<String>>()
    var row = ArrayList<String>()
    val cell = StringBuilder()
    var quoted = false
    for (char in text.replace("\r\n", "\n")) {
        when {
            char == '"' -> quoted = !quoted

            char == ',' && !quoted -> row += cell.toString().also { cell.clear() }

            char == '\n' && !quoted -> {
                row += cell.toString().also { cell.clear() }
                rows += row
                row = ArrayList()
            }

            else -> cell.append(char)
        }
    }
    return rows
}
