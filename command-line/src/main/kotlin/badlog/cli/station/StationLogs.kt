package badlog.cli.station

import badlog.cli.input.Failure
import badlog.cli.search.signalsBeside
import badlog.core.recording.Recording
import badlog.files.LogFile
import badlog.files.LogName
import badlog.files.ReadOptions
import badlog.files.ReadResult
import badlog.files.filesAround
import badlog.files.readLog
import badlog.files.readStationLog
import badlog.files.reading
import badlog.files.startOfStationLog
import badlog.files.stationLogsIn
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.STATION_HEAD_SIZE
import badlog.formats.driverstation.isOfDriverStation
import badlog.formats.driverstation.stationStartIn
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.FoundStation
import badlog.signals.clock.StationSearch
import badlog.signals.match.files.claimOf
import badlog.signals.match.files.isNamedAlike
import java.nio.file.Path
import kotlin.io.path.name

/** The Driver Station logs below [folder]. Thread-safe. */
internal class StationLogs(private val folder: Path) {
    private val logs: List<LogFile> by lazy { reading(folder) { stationLogsIn(folder) } }
    private val starts by lazy { logs.associateWith(::startOf) }

    val size: Int get() = logs.size

    /**
     * Returns the log of the same match as [robot], which was read from [file]; null if none can be identified.
     *
     * @param acceptsOnly see [StationSearch.over].
     * @param given other logs that are known to be from the same robot.
     * @throws Failure if it may be of another robot in that match, with a log beside [file].
     */
    fun of(robot: ClockedLog, file: Path, acceptsOnly: Boolean = false, given: List<Path> = emptyList()): FoundStation<LogFile>? {
        val others = logs.filter { it.path.toAbsolutePath() != file.toAbsolutePath() }
        val found = StationSearch(robot, starts::get, ::read).over(others, acceptsOnly) ?: return null
        val claim = found.claimOf(robot, besideOf(robot, file, given))
        if (claim.isOwn != null) return found.takeIf { claim.isOwn == true }
        throw Failure(
            "$file: the Driver Station log ${found.log.name} may belong to this robot, or to the robot of " +
                "${claim.rivals.joinToString(" or ") { it.name }}; to merge it with one of them, name it as a log, with --align enabled.",
        )
    }

    /** Returns the logs of robots beside [file]: if there are many, those that are named like logs of its match. */
    private fun besideOf(robot: ClockedLog, file: Path, given: List<Path>): List<ClockedLog> {
        val folder = file.toAbsolutePath().normalize().parent
        val known = given.mapTo(HashSet()) { it.toAbsolutePath().normalize() }
        val beside = filesAround(file) { LogName.of(it).mayBeLog && STATION_ENDING !in it.lowercase() }
            .filter { it.parent == folder && it !in known }
        val possible = if (beside.size <= MOST_RIVALS) beside else beside.filter { robot.isNamedAlike(it.name, "") }.take(MOST_RIVALS)
        return possible.mapNotNull { path ->
            val read = readLog(path, LOG_FORMATS, ReadOptions(cores = 1)) as? ReadResult.Read
            read?.recording?.takeUnless { it.hasStation }?.let { ClockedLog(path.name, it, signalsBeside(path)) }
        }
    }

    /** Whether it is a Driver Station's log, or was made of one. */
    private val Recording.hasStation: Boolean get() = isOfDriverStation || topics.any { it.name.startsWith(STATION_FOLDER) }

    private fun read(log: LogFile): ClockedLog? =
        readStationLog(log, LOG_FORMATS)?.let { ClockedLog(log.name, it, signalsBeside(log.path)) }

    private fun startOf(log: LogFile): Double? = startOfStationLog(log, STATION_HEAD_SIZE, ::stationStartIn)
}

/** The number of robots in a match. */
private const val MOST_RIVALS = 6

/** The beginning of all file name endings of Driver Station logs. */
private const val STATION_ENDING = ".ds"
private const val STATION_FOLDER = "Driver Station/"
