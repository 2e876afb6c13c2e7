package badlog.files

import badlog.core.recording.LogFormat
import badlog.core.recording.Recording
import badlog.formats.driverstation.DriverStationFormat
import badlog.formats.driverstation.DriverStationFormat.FIRST_ENDING
import badlog.formats.driverstation.DriverStationFormat.SECOND_ENDING
import badlog.formats.driverstation.isOfDriverStation
import badlog.formats.wpilog.WpilogFormat
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Returns the files that make up the log [file], in the order in which their bytes are read. Usually there is only [file]. A `.dslog` of
 * the Driver Station usually has a `.dsevents` with the same name beside it.
 */
public fun partsOfLog(file: Path): List<Path> =
    listOfNotNull(file, sibling(file, FIRST_ENDING, SECOND_ENDING)?.takeIf(Files::isRegularFile))

/**
 * Returns the files below [folder] with names of Driver Station logs; a pair is included once.
 *
 * @param checkpoint called for each file; may throw to cancel.
 * @throws java.io.IOException if [folder] cannot be read.
 */
public fun stationLogsIn(folder: Path, checkpoint: () -> Unit = {}): List<LogFile> =
    FolderScan.of(folder, checkpoint).files.filter { file ->
        val name = LogName.of(file.name)
        val ending = name.ending.lowercase()
        ending in DriverStationFormat.endings || (ending in WpilogFormat.endings && name.stem.startsWith(STATION_STEM, ignoreCase = true))
    }

/**
 * Returns the content of [log], one of [stationLogsIn], read by [formats]. Null if it is not a log of the Driver Station, has no samples, or cannot
 * be read.
 */
public fun readStationLog(log: LogFile, formats: List<LogFormat>): Recording? = try {
    readRecording(log.path, formats, ReadOptions(cores = 1)).takeIf { it.isOfDriverStation && it.sampleCount > 0 }
} catch (_: UnreadableFileException) {
    // Such a file is not the log being searched for.
    null
}

/**
 * Returns the time when [log], one of [stationLogsIn], began, in s since 1970; null if its first bytes do not show it.
 *
 * @param headSize the number of its first bytes that [startIn] needs.
 * @param startIn returns the time that these bytes show, in s since 1970.
 */
public fun startOfStationLog(log: LogFile, headSize: Int, startIn: (ByteArray) -> Double?): Double? = try {
    startIn(Files.newInputStream(log.path).use { it.readNBytes(headSize) })
} catch (_: IOException) {
    null
}

/** The beginning of its logs' names from 2027 on. */
private const val STATION_STEM = "FIRST_DS"

/** Returns the folders of the Driver Station's logs on this computer. The first is for the seasons to 2026, the others from 2027 on. */
public fun stationFolders(
    user: Path = Path.of(System.getProperty("user.home")),
    variable: (String) -> String? = System::getenv,
): List<Path> {
    val shared = variable("PUBLIC")?.takeIf { it.isNotBlank() }?.let { Path.of(it, "Documents") }
    val ofWindows = shared?.run { listOf(resolve("FRC/Log Files/DSLogs"), resolve("FIRSTDriverStation/Logs"), resolve("firstds")) }
    return ofWindows.orEmpty() + listOf(user.resolve(".firstds"))
}

/** Returns [files] without the second files of logs among them; [pathOf] returns a file's path. */
public fun <T> wholeLogs(files: List<T>, pathOf: (T) -> Path): List<T> {
    val paths = files.mapTo(HashSet(), pathOf)
    return files.filter { file -> firstPartOf(pathOf(file))?.let { it in paths } != true }
}

/**
 * Returns the path of a log's first file, derived from the name of its second file, [file]. Null if [file] is not named like a second file.
 * The first file need not exist.
 */
public fun firstPartOf(file: Path): Path? = sibling(file, SECOND_ENDING, FIRST_ENDING)

private fun sibling(file: Path, from: String, to: String): Path? {
    val name = file.fileName?.toString().orEmpty()
    val parts = LogName.of(name)
    if (!parts.ending.equals(from, ignoreCase = true)) return null
    val ending = if (parts.ending == from.uppercase()) to.uppercase() else to
    return file.resolveSibling(parts.stem + ending + name.drop(parts.stem.length + parts.ending.length))
}
