package badlog.file

import badlog.recording.LogFormat
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * The files that hold the log [file], in the order in which their bytes are read: mostly it alone. A `.dslog` of the Driver Station
 * mostly has a `.dsevents` of the same name beside it.
 */
public fun partsOfLog(file: Path): List<Path> =
    listOfNotNull(file, sibling(file, LogName.DSLOG, LogName.DSEVENTS)?.takeIf(Files::isRegularFile))

/**
 * The logs of the Driver Station below [folder], named so; a pair is there once.
 *
 * @param checkpoint is called for each file, and may throw to give up.
 * @throws java.io.IOException when [folder] cannot be looked into.
 */
public fun stationLogsIn(folder: Path, checkpoint: () -> Unit = {}): List<LogFile> =
    FolderScan.of(folder, checkpoint).files.filter { LogName.of(it.name).ending.lowercase() in STATION_ENDINGS }

/** What [log], one of [stationLogsIn], holds, read by [formats]; null where it is not a log of the Driver Station, has no samples, or cannot be read. */
public fun readStationLog(log: LogFile, formats: List<LogFormat>): Recording? = try {
    readRecording(log.path, formats, cores = 1).takeIf { it.format == RecordingFormat.DRIVER_STATION && it.sampleCount > 0 }
} catch (_: UnreadableFileException) {
    // Whatever it is, it is not the one that is looked for.
    null
}

/**
 * When [log], one of [stationLogsIn], began; null where that is not known before it is read.
 *
 * @param headSize how many bytes of it say that, and [startIn] how, in s since 1970.
 */
public fun startOfStationLog(log: LogFile, headSize: Int, startIn: (ByteArray) -> Double?): Double? = try {
    startIn(Files.newInputStream(log.path).use { it.readNBytes(headSize) })
} catch (_: IOException) {
    null
}

private val STATION_ENDINGS = setOf(LogName.DSLOG, LogName.DSEVENTS)

/** Those of [files], whose paths are [pathOf] them, that are not the second file of a log among them. */
public fun <T> wholeLogs(files: List<T>, pathOf: (T) -> Path): List<T> {
    val paths = files.mapTo(HashSet(), pathOf)
    return files.filter { file -> firstPartOf(pathOf(file))?.let { it in paths } != true }
}

/** The log whose second file is [file], if that is there; null where [file] is named like a log by itself. */
public fun firstPartOf(file: Path): Path? = sibling(file, LogName.DSEVENTS, LogName.DSLOG)

private fun sibling(file: Path, from: String, to: String): Path? {
    val name = file.fileName?.toString().orEmpty()
    val parts = LogName.of(name)
    if (!parts.ending.equals(from, ignoreCase = true)) return null
    val ending = if (parts.ending == from.uppercase()) to.uppercase() else to
    return file.resolveSibling(parts.stem + ending + name.drop(parts.stem.length + parts.ending.length))
}
