package badlog.cli.station

import badlog.cli.search.signalsBeside
import badlog.driverstation.DriverStationFormat
import badlog.file.LogFile
import badlog.file.UnreadableFileException
import badlog.file.readRecording
import badlog.file.reading
import badlog.file.stationLogsIn
import badlog.formats.LOG_FORMATS
import badlog.recording.RecordingFormat
import badlog.rules.station.ClockedLog
import badlog.rules.station.FoundStation
import badlog.rules.station.StationSearch
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** The Driver Station logs below [folder]. Safe for several threads. */
internal class StationLogs(private val folder: Path) {
    private val logs: List<LogFile> by lazy { reading(folder) { stationLogsIn(folder) } }
    private val starts by lazy { logs.associateWith(::startOf) }

    /** How many there are. */
    val size: Int get() = logs.size

    /**
     * The one of the match that [robot] is the log of, which stands in [file]; null when none can be told to be it.
     *
     * @param acceptsOnly see [StationSearch.over].
     */
    fun of(robot: ClockedLog, file: Path, acceptsOnly: Boolean = false): FoundStation<LogFile>? =
        StationSearch(robot, starts::get, ::read).over(logs.filter { it.path.toAbsolutePath() != file.toAbsolutePath() }, acceptsOnly)

    private fun read(log: LogFile): ClockedLog? = try {
        val recording = readRecording(log.path, LOG_FORMATS, cores = 1)
        val isStation = recording.format == RecordingFormat.DRIVER_STATION && recording.sampleCount > 0
        if (isStation) ClockedLog(log.name, recording, signalsBeside(log.path)) else null
    } catch (_: UnreadableFileException) {
        // Whatever it is, it is not the one that is looked for.
        null
    }

    private fun startOf(log: LogFile): Double? = try {
        DriverStationFormat.startOf(Files.newInputStream(log.path).use { it.readNBytes(DriverStationFormat.HEAD_SIZE) })
    } catch (_: IOException) {
        null
    }
}
