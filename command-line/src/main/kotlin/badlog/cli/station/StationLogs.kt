package badlog.cli.station

import badlog.cli.search.signalsBeside
import badlog.files.LogFile
import badlog.files.readStationLog
import badlog.files.reading
import badlog.files.startOfStationLog
import badlog.files.stationLogsIn
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.STATION_HEAD_SIZE
import badlog.formats.driverstation.stationStartIn
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.FoundStation
import badlog.signals.clock.StationSearch
import java.nio.file.Path

/** The Driver Station logs below [folder]. Safe for several threads. */
internal class StationLogs(private val folder: Path) {
    private val logs: List<LogFile> by lazy { reading(folder) { stationLogsIn(folder) } }
    private val starts by lazy { logs.associateWith(::startOf) }

    val size: Int get() = logs.size

    /**
     * Returns the log of the same match as [robot], which was read from [file]; null if none can be identified.
     *
     * @param acceptsOnly see [StationSearch.over].
     */
    fun of(robot: ClockedLog, file: Path, acceptsOnly: Boolean = false): FoundStation<LogFile>? =
        StationSearch(robot, starts::get, ::read).over(logs.filter { it.path.toAbsolutePath() != file.toAbsolutePath() }, acceptsOnly)

    private fun read(log: LogFile): ClockedLog? =
        readStationLog(log, LOG_FORMATS)?.let { ClockedLog(log.name, it, signalsBeside(log.path)) }

    private fun startOf(log: LogFile): Double? = startOfStationLog(log, STATION_HEAD_SIZE, ::stationStartIn)
}
