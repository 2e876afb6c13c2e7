package badlog.season

import badlog.files.FolderScan
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.season.lake.Lake
import badlog.season.lake.LakeLog
import badlog.season.lake.LakeResult
import badlog.season.sql.LakeDatabase
import badlog.signals.match.NaturalOrder
import kotlinx.serialization.json.JsonElement
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.readText
import kotlin.io.path.writeBytes

/** The project's samples. */
internal val SAMPLE_LOGS: Path = generateSequence(Path.of("").toAbsolutePath()) { it.parent }.map { it.resolve("samples") }.first(Files::isDirectory)

internal fun Path.put(name: String, bytes: ByteArray): Path = resolve(name).also {
    it.parent.createDirectories()
    it.writeBytes(bytes)
}

internal fun Path.put(name: String, text: String): Path = put(name, text.encodeToByteArray())

/** Returns a bag of match [number] with the voltages [volts], a row each 0.1 s. */
internal fun matchBag(number: Int, vararg volts: Double, event: String = "Mill Creek", start: String = "2025-03-14 10:00:00 UTC"): String = buildString {
    append("""{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"System/Battery Voltage","unit":"V","attrs":["zero"]}],""")
    append(""""values":[{"name":"Event Name","value":"$event"},{"name":"Match Type","value":"Qualification"},""")
    append("""{"name":"Match Number","value":"$number"},{"name":"Start Time","value":"$start"}]}""")
    append("\nTime,System/Battery Voltage\n")
    volts.forEachIndexed { row, volt -> append("${row / 10.0},$volt\n") }
}

/** Returns the files of [logs] in the order and form that a lake needs. */
internal fun lakeLogs(logs: Path): List<LakeLog> = FolderScan.of(logs).files.sortedWith(compareBy(NaturalOrder) { it.path.toString() })
    .map { LakeLog(it, logs.relativize(it.path).invariantSeparatorsPathString) }

/** Updates the lake [lake] from the folder [logs]. */
internal fun refresh(logs: Path, lake: Path, batch: Int = 500, progress: (Int, Int) -> Unit = { _, _ -> }): LakeResult = Lake(lake).refresh(lakeLogs(logs), listOf(logs), RuleSet.BUILT_IN, batch, progress = progress)

/** Returns the rows that [sql] selects from the lake [lake]. */
internal fun rowsOf(lake: Path, sql: String): List<List<JsonElement>> = LakeDatabase.open(Lake(lake)).use { database ->
    buildList {
        database.query(sql, {}) {
            add(it)
            true
        }
    }
}

/** Returns the same as a text: cells between bars, a row per line. */
internal fun answerOf(lake: Path, sql: String): String = rowsOf(lake, sql).joinToString("\n") { row -> row.joinToString("|") }

/** Returns all files below this folder, with the times of their last changes and their sizes. */
internal fun Path.written(): Map<String, Pair<Long, Long>> = Files.walk(this).use { files ->
    files.filter { Files.isRegularFile(it) }.toList()
        .associate { relativize(it).invariantSeparatorsPathString to (Files.getLastModifiedTime(it).toMillis() to Files.size(it)) }
}

/** Returns the text of a sample. */
internal fun sampleText(name: String): String = SAMPLE_LOGS.resolve(name).readText()
