package badlog.catalog.folder

import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.time.Instant

/** Returns a bag of [rows] rows at 50 Hz, with a voltage falling from 12 V to 8 V. [values] are names and texts. */
internal fun bag(
    rows: Int = 200,
    values: Map<String, String> = emptyMap(),
    voltage: (row: Int) -> Double = { 12 - 4.0 * it / rows },
    isEnabled: Boolean = true,
): String = buildString {
    val named = values.entries.joinToString(",") { """{"name":"${it.key}","value":"${it.value}"}""" }
    append("""{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"System/Battery Voltage","unit":"V","attrs":[]},""")
    append("""{"name":"Enabled","unit":"ul","attrs":[]}],"values":[$named]}""").append('\n')
    append("Time,System/Battery Voltage,Enabled\n")
    for (row in 0 until rows) appendLine("${row * 0.02},${voltage(row)},${if (isEnabled) 1 else 0}")
}

/** Returns the values of qualification [number] at the Mill Creek Regional. */
internal fun matchValues(number: Int, alliance: String = "Red") = mapOf(
    "Event Name" to "Mill Creek Regional",
    "Match Type" to "Qualification",
    "Match Number" to "$number",
    "Alliance" to alliance,
    "Start Time" to "2024-03-16T%02d:00:00".format(8 + number % 12),
)

/** Puts a file with [text] into this folder. */
internal fun Path.put(name: String, text: String): Path {
    val file = resolve(name)
    Files.createDirectories(file.parent)
    return Files.writeString(file, text)
}

/** The folder of the project's samples. */
internal val samples: Path = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
    .map { it.resolve("samples") }
    .first { Files.exists(it.resolve("practice.bag")) }

/**
 * Copies the project's samples into this folder.
 *
 * @param areSettled whether their times are a minute ago; rules wait for younger logs, which may still grow.
 */
internal fun Path.putSamples(areSettled: Boolean = false) {
    val written = FileTime.from(Instant.now().minusSeconds(60))
    for (name in listOf("elevator-bench.csv", "practice.bag", "qualification-42.bag", "qualification-57.bag.gz")) {
        val log = Files.copy(samples.resolve(name), resolve(name))
        if (areSettled) Files.setLastModifiedTime(log, written)
    }
}
