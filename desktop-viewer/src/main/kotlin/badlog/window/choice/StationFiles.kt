package badlog.window.choice

import badlog.catalog.match.MatchMaker
import badlog.files.LogFile
import badlog.files.readStationLog
import badlog.files.startOfStationLog
import badlog.files.stationFolders
import badlog.files.stationLogsIn
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.STATION_HEAD_SIZE
import badlog.formats.driverstation.stationStartIn
import badlog.rules.folder.FolderRules
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.FoundStation
import badlog.signals.clock.StationSearch
import badlog.window.log.OpenRecording
import java.io.IOException
import java.nio.file.Path

/**
 * Returns the Driver Station's log of the same match as [robot]; null if none can be identified. It may be in the folder of [robot], in the
 * folder of logs [library], or where the Driver Station of this computer keeps its logs. Interrupting the thread cancels.
 */
internal fun stationBeside(robot: OpenRecording, library: Path?): FoundStation<LogFile>? {
    // A ZIP has the files of its match.
    if (isMatch(robot.file)) return null
    val clocked = ClockedLog(robot.file.fileName.toString(), robot.view.recording, robot.vocabulary)
    if (!clocked.hasClock) return null
    val logs = (listOfNotNull(robot.file.parent, library) + stationFolders()).distinct().flatMap(::logsIn).distinctBy { it.path }
    return StationSearch(clocked, ::startOf) { clockedLog(it, library) }.over(logs, mostRead = MAX_READ)
}

private fun isMatch(file: Path): Boolean = try {
    MatchMaker.isSource(file)
} catch (_: IOException) {
    // It was removed.
    false
}

private fun logsIn(folder: Path): List<LogFile> = try {
    stationLogsIn(folder, ::checkInterrupt)
} catch (_: IOException) {
    emptyList()
}

private fun clockedLog(log: LogFile, library: Path?): ClockedLog? {
    checkInterrupt()
    return readStationLog(log, LOG_FORMATS)?.let { ClockedLog(log.name, it, FolderRules.of(log.path, library).rules.signals) }
}

private fun startOf(log: LogFile): Double? = startOfStationLog(log, STATION_HEAD_SIZE, ::stationStartIn)

private fun checkInterrupt() {
    if (Thread.interrupted()) throw InterruptedException()
}

/** The largest number of logs to read. More than a team plays in a day would take too much time and memory. */
private const val MAX_READ = 40
