package badlog.cli.merge

import badlog.cli.Ended
import badlog.cli.Logged
import badlog.cli.with
import badlog.cli.wpilog
import badlog.formats.driverstation.STATION_START
import badlog.formats.driverstation.Status
import badlog.formats.driverstation.TestDslog
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.outputStream

/** Enabled from 5 to 8 s and from 9 to 15 s of 17. */
internal fun stationLog() = TestDslog(start = STATION_START).records(250).records(150, Status.BOTH_AUTO).records(50).records(300, Status.BOTH_TELEOP).records(100)

/** A robot's log of that, with a clock that began [later] than the Driver Station's log. */
internal fun Path.robot(name: String, topic: String, later: Double) = wpilog(
    name,
    listOf(
        Logged("$topic/Robot Enabled", "boolean", "", listOf(0.0 to false, 5 - later to true, 8 - later to false, 9 - later to true, 15 - later to false, 16 - later to false)),
        Logged("/$topic/Angle", "double", "", List(20) { it / 2.0 + 0.5 to it.toDouble() }),
    ),
)

/** Writes a ZIP of [entries] to [file], and returns it. */
internal fun zip(file: Path, vararg entries: Pair<String, ByteArray>): Path {
    ZipOutputStream(file.outputStream()).use { zip ->
        for ((name, bytes) in entries) {
            zip.putNextEntry(ZipEntry(name))
            zip.write(bytes)
            zip.closeEntry()
        }
    }
    return file
}

/** The names of the topics of a log, as `info --json` lists them. */
internal fun JsonObject.topics() = getValue("topics").jsonArray.map { it.jsonObject.getValue("name").jsonPrimitive.content }

/** All that was said, without line breaks. */
internal fun Ended.oneLine() = (out + err).replace(Regex("\\s+"), " ")
