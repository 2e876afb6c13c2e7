package badlog.core.bag

import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import java.io.File
import java.util.zip.GZIPInputStream
import kotlin.random.Random

/** The number of damaged files that are read: a few in each build, more by `./gradlew thoroughTest`. */
private val MUTANTS = PropertyTesting.defaultIterationCount

/** A whole file: its header, and where its rows are. */
private class Original(val name: String, val bytes: ByteArray) {
    val recording = parse(bytes)
    val isBag = bytes[0] == '{'.code.toByte()

    /** Where each line begins, then the end of the file. */
    val lines: List<Int> = listOf(0) + bytes.indices.filter { bytes[it] == '\n'.code.toByte() }.map { it + 1 }
    val firstRow = if (isBag) 2 else 1
    val head = lines[firstRow]
    val cells = Cells(recording)

    init {
        recording.rowCount shouldBe lines.size - 1 - firstRow
    }

    override fun toString() = name
}

/** The cells of a recording, to be compared. */
private class Cells(private val recording: Recording) {
    private val texts = recording.topics.associateWith { topic -> List(topic.texts.size) { topic.texts.rows[it] to topic.texts[it] }.toMap() }

    fun of(topic: Topic, row: Int): Any = texts.getValue(topic)[row] ?: topic.samples.getOrElse(row) { Double.NaN }

    val byName: Map<String, Topic> = recording.topics.associateBy { it.name }
}

private fun sample(name: String, rows: Int): Original {
    val file = File("../samples/$name")
    val all = file.inputStream().use { if (name.endsWith(".gz")) GZIPInputStream(it).readNBytes(1 shl 19) else it.readNBytes(1 shl 19) }
    val ends = all.indices.filter { all[it] == '\n'.code.toByte() }
    val first = if (all[0] == '{'.code.toByte()) 2 else 1
    return Original("the first $rows rows of $name", all.copyOf(ends[first + rows - 1] + 1))
}

/** A bag or a CSV file with titles in their own order, and texts with quotes and commas. */
private fun generated(columns: Int, isBag: Boolean, isReordered: Boolean, seed: Int): Original {
    val random = Random(seed)
    val names = List(columns) { if (it == 0) "Time" else "Folder ${it % 3}/Topic $it" }
    val titles = if (isReordered) names.shuffled(random) else names
    val json = "{\"topics\":[" + names.joinToString(",") { "{\"name\":\"$it\",\"unit\":\"V\",\"attrs\":[]}" } + "],\"values\":[]}\n"
    val rows = List(40) { row ->
        titles.joinToString(",") { name ->
            when {
                name == "Time" -> "${row * 2 / 100.0}"
                name.endsWith("1") -> listOf("\"he said \"\"go\"\", twice\"", "auto", "\"left, right\"", "").random(random)
                name.endsWith("2") -> if (random.nextBoolean()) "true" else "false"
                else -> "${random.nextInt(100_000) / 1000.0}"
            }
        }
    }
    return Original("$columns columns, bag $isBag, reordered $isReordered", ((if (isBag) json else "") + titles.joinToString(",") + "\n" + rows.joinToString("") { "$it\n" }).encodeToByteArray())
}

/** Returns the first mistake in the recording that was read from [mutant]; null if there is none. */
private fun fault(original: Original, mutant: Mutant): String? {
    val rows = survivors(original, mutant)
    val recording = parse(mutant.bytes)
    if (rows.isEmpty()) return null
    if (!recording.isReadable) return "refused with ${rows.size} rows: ${recording.problems.last().message}"
    val doubtful = recording.problems.filter { it.kind == ProblemKind.NAME_IN_DOUBT }.map { it.topic }.toSet()
    val cells = Cells(recording)
    val sure = original.recording.topics.filter { it.name in cells.byName && it.name !in doubtful }
    if (doubtful.isEmpty() && isOneHeadWhole(original, mutant) && sure.size < original.recording.topics.size) {
        return "${original.recording.topics.map { it.name } - sure.map { it.name }.toSet()} are missing"
    }
    var at = 0
    for (row in rows) {
        while (at < recording.rowCount && !isRow(original, sure, cells, recording, row, at)) at++
        if (at == recording.rowCount) return "row $row of ${rows.size} is lost; ${sure.size} sure topics"
        at++
    }
    return null
}

private fun isRow(original: Original, sure: List<Topic>, cells: Cells, recording: Recording, row: Int, at: Int): Boolean {
    if (sure.isNotEmpty()) return sure.all { original.cells.of(it, row) == cells.of(cells.byName.getValue(it.name), at) }
    // Even if the names are in doubt, all the values are there.
    val wanted = original.recording.topics.groupingBy { original.cells.of(it, row) }.eachCount()
    val found = recording.topics.groupingBy { cells.of(it, at) }.eachCount()
    return wanted.all { (value, count) -> (found[value] ?: 0) >= count }
}

/** The rows of [original] that are in [mutant] byte for byte, from newline to newline, in their order there. */
private fun survivors(original: Original, mutant: Mutant): List<Int> {
    val rowAt = HashMap<Int, Int>()
    for (row in 0 until original.recording.rowCount) rowAt[original.lines[original.firstRow + row]] = row
    return mutant.origin.indices.mapNotNull { at ->
        val row = rowAt[mutant.origin[at]] ?: return@mapNotNull null
        val from = original.lines[original.firstRow + row]
        val isAfterLine = at > 0 && mutant.bytes[at - 1] == '\n'.code.toByte()
        row.takeIf { isAfterLine && mutant.holdsAt(at, from, original.lines[original.firstRow + row + 1]) }
    }
}

private fun isOneHeadWhole(original: Original, mutant: Mutant): Boolean {
    val isStart = mutant.holdsAt(0, 0, original.lines[1])
    return isStart || (original.isBag && mutant.holds(original.lines[1] - 1, original.lines[2]) && parse(mutant.bytes).topics.none { it.unit != Topic.UNITLESS })
}

class SalvageSpec : FunSpec({
    val originals = listOf(
        sample("qualification-42.bag", 25),
        sample("practice.bag", 40),
        sample("qualification-57.bag.gz", 25),
        sample("elevator-bench.csv", 60),
        generated(6, isBag = true, isReordered = true, 1),
        generated(6, isBag = false, isReordered = false, 2),
        generated(3, isBag = true, isReordered = false, 3),
        generated(30, isBag = true, isReordered = false, 4),
    )

    test("every intact row of any damaged bag or CSV file is read, under its own names") {
        val random = Random(1556)
        val faults = ArrayList<String>()
        repeat(MUTANTS) { number ->
            val original = originals[number % originals.size]
            val mutant = Mutant.of(original.bytes, random, original.head)
            fault(original, mutant)?.let { faults += "$number, $original${mutant.damage}: $it" }
        }
        withClue("${faults.size} of $MUTANTS:\n" + faults.joinToString("\n")) { faults.shouldBeEmpty() }
    }
})
