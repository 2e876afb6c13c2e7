package badlog.report

import badlog.files.FolderScan
import badlog.files.LogFile
import badlog.signals.match.NaturalOrder
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.encodeToJsonElement
import kotlinx.serialization.json.jsonObject
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

/** A bag of the columns [topics], names with units, with one row for each of [rows]. */
internal fun bag(topics: Map<String, String>, rows: List<String>, values: Map<String, String> = emptyMap()): String {
    fun quoted(text: String) = "\"${text.replace("\\", "\\\\").replace("\"", "\\\"")}\""
    val described = topics.entries.mapIndexed { index, (name, unit) ->
        """{"name":${quoted(name)},"unit":"$unit","attrs":[${if (index == 0) "\"xaxis\"" else ""}]}"""
    }
    val known = values.map { (name, value) -> """{"name":${quoted(name)},"value":${quoted(value)}}""" }
    val titles = topics.keys.joinToString(",") { if (it.any { char -> char in ",\"" }) "\"${it.replace("\"", "\"\"")}\"" else it }
    return "{\"topics\":$described,\"values\":$known}\n$titles\n${rows.joinToString("") { "$it\n" }}"
}

/** A bag with the voltages [volts], a sample each 0.1 s. */
internal fun batteryBag(vararg volts: Double, match: Int = 1, name: String = "System/Battery Voltage", unit: String = "V") = bag(
    mapOf("Time" to "s", name to unit),
    volts.mapIndexed { index, volt -> "${index / 10.0},$volt" },
    mapOf("Event Name" to "Mill Creek", "Match Type" to "Qualification", "Match Number" to "$match"),
)

internal fun Path.put(name: String, text: String): Path = resolve(name).also {
    it.parent.createDirectories()
    it.writeText(text)
}

internal fun logsIn(folder: Path): List<LogFile> = FolderScan.of(folder).files.sortedWith(compareBy(NaturalOrder) { it.path.toString() })

/** Makes [file] unreadable, without changing what its folder shows of it. */
internal fun spoil(file: Path) {
    val time = Files.getLastModifiedTime(file)
    Files.write(file, ByteArray(Files.size(file).toInt()) { 1 })
    Files.setLastModifiedTime(file, time)
}

/** [value] as other programs get it. */
internal inline fun <reified T> jsonOf(value: T): JsonObject = Json.encodeToJsonElement(value).jsonObject
