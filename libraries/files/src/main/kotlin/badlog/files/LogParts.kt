package badlog.files

import badlog.core.recording.LogFormat
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Returns the files that make up the log [file], in the order in which their bytes are read: usually only that file. A `.dslog` of
 * the Driver Station usually has a `.dsevents` with the same name beside it.
 */
public fun partsOfLog(file: Path): List<Path> =
    listOfNotNull(file, sibling(file, LogName.DSLOG, LogName.DSEVENTS)?.takeIf(Files::isRegularFile))

/**
 * Returns the files below [folder] with names of Driver Station logs; a pair is included once.
 *
 * @param checkpoint called for each file; may throw to cancel.
 * @throws java.io.IOException if [folder] cannot be read.
 */
public fun stationLogsIn(folder: Path, checkpoint: () -> Unit = {}): List<LogFile> =
    FolderScan.of(folder, checkpoint).files.filter { LogName.of(it.name).ending.lowercase() in STATION_ENDINGS }

/**
 * Returns the content of [log], one of [stationLogsIn], read by [formats]; null if it is not a log of the Driver Station, has no samples,
 * or cannot be read.
 */
public fun readStationLog(log: LogFile, formats: List<LogFormat>): Recording? = try {
    readRecording(log.path, formats, cores = 1).takeIf { it.format == RecordingFormat.DRIVER_STATION && it.sampleCount > 0 }
} catch (_: UnreadableFileException) {
    // Whatever it is, it is not the log being searched for.
    null
}

/**
 * Returns when [log], one of [stationLogsIn], began; null if that is not known before it is read.
 *
 * @param headSize the number of its first bytes from which [startIn] returns the time, in s since 1970.
 */
public fun startOfStationLog(log: LogFile, headSize: Int, startIn: (ByteArray) -> Double?): Double? = try {
    startIn(Files.newInputStream(log.path).use { it.readNBytes(headSize) })
} catch (_: IOException) {
    null
}

private val STATION_ENDINGS = setOf(LogName.DSLOG, LogName.DSEVENTS)

/** Returns those of [files], whose paths [pathOf] returns, that are not the second file of a log among them. */
public fun <T> wholeLogs(files: List<T>, pathOf: (T) -> Path): List<T> {
    val paths = files.mapTo(HashSet(), pathOf)
    return files.filter { file -> firstPartOf(pathOf(file))?.let { it in paths } != true }
}

/** Returns the log whose second file is [file], if it exists; null if [file] has a name of a separate log. */
public fun firstPartOf(file: Path): Path? = sibling(file, LogName.DSEVENTS, LogName.DSLOG)

private fun sibling(file: Path, from: String, to: String): Path? {
    val name = file.fileName?.toString().orEmpty()
    val parts = LogName.of(name)
    if (!parts.ending.equals(from, ignoreCase = true)) return null
    val ending = if (parts.ending == from.uppercase()) to.uppercase() else to
    return file.resolveSibling(parts.stem + ending + name.drop(parts.stem.length + parts.ending.length))
}
