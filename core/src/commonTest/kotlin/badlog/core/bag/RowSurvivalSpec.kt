package badlog.core.bag

import badlog.core.recording.Topic
import badlog.core.text.NUL
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.random.Random

private val DAMAGE = listOf(
    "1", "-2.5", "abc", "de f", "\"", "\"", "\"\"", ",", ",", ",", "\n", "\r\n", "\r", "\u0000\u0000", "null", "\"a,b\"", " ",
)

class RowSurvivalSpec : FunSpec({
    test("the rest of a row of numbers is not joined to the text of the previous row") {
        val recording = parse("Time,a,State\n0.02,1,STOWED\n0.04,1,STOWED\n0.061OWED\n0.08,1,STOWED\n")
        recording.topics[2].texts.dictionary.toSet() shouldBe setOf("STOWED")
        recording.topics[0].samples.filter { it.isFinite() }.toList() shouldBe listOf(0.02, 0.04, 0.08)
    }

    test("damage to one row, including newlines and quotes, loses no other row") {
        val random = Random(1014)
        repeat(3 * PropertyTesting.defaultIterationCount) {
            val columns = random.nextInt(1, 5)
            val textColumn = if (columns == 1) -1 else random.nextInt(-1, columns)
            val rows = List(10) { row ->
                List(columns) { if (it == textColumn) "text $row" else "${row * 10 + it}" }.joinToString(",")
            }
            val damaged = random.nextInt(rows.size)
            val lines = rows.toMutableList().also { it[damaged] = damage(it[damaged], random) }
            val file = List(columns) { "c$it" }.joinToString(",") + "\n" + lines.joinToString("\n") + "\n"

            val recording = parse(file)
            val found = List(recording.rowCount) { row -> recording.topics.joinToString(",") { cellText(it, row) } }
            for (row in rows.indices) {
                // The bytes between a NUL and the next newline are not a whole row.
                if (row == damaged || (row == damaged + 1 && '\u0000' in lines[damaged])) continue
                // A damaged line may be read as a part of the text above it.
                val isThere = found.any { it == rows[row] || it.startsWith(rows[row] + "\n") }
                if (recording.isReadable && !isThere) throw AssertionError("row $row is lost in:\n$file")
            }
        }
    }
})

private fun damage(row: String, random: Random): String {
    var damaged = row
    repeat(random.nextInt(1, 5)) {
        val at = random.nextInt(damaged.length + 1)
        damaged = damaged.substring(0, at) + DAMAGE.random(random) + damaged.substring(at)
    }
    if (random.nextInt(3) > 0) return damaged
    val from = random.nextInt(damaged.length)
    return damaged.removeRange(from, random.nextInt(from, damaged.length + 1))
}

private fun cellText(topic: Topic, row: Int): String {
    val text = topic.texts.rows.indexOf(row)
    return if (text >= 0) topic.texts[text] else topic.samples.getOrNull(row)?.toLong()?.toString() ?: ""
}
