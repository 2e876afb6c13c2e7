package badlog.cli.station

import badlog.cli.input.Failure
import badlog.cli.input.folderBeside
import badlog.cli.text.JsonNumber
import badlog.cli.text.jsonOf
import badlog.cli.text.shortNumber
import badlog.core.analysis.LogView
import badlog.files.LogFile
import badlog.formats.driverstation.isOfDriverStation
import badlog.signals.clock.ClockFit
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.StationOverlay
import badlog.signals.vocabulary.SignalVocabulary
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.JsonElement
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap

/**
 * Adds the Driver Station's log to each log of a robot, for rules. Thread-safe.
 *
 * @param folder the folder to search for them; empty for the folder of each log.
 */
internal class StationLogFinder(private val folder: Path, private val signals: SignalVocabulary) {
    private val logsIn = ConcurrentHashMap<Path, StationLogs>()
    private val found = ConcurrentHashMap<Path, UsedStationLog>()

    private val doubts = ConcurrentHashMap<Path, String>()

    private class UsedStationLog(val name: String, val fit: ClockFit)

    /** Returns a view for rules: the robot's log [view] of [file], plus the content that only the Driver Station log has. */
    fun over(file: LogFile, view: LogView): LogView {
        if (view.recording.isOfDriverStation) return view
        val below = folderBeside(file.path, folder)
        val robot = ClockedLog(file.name, view.recording, signals)
        val station = try {
            logsIn.computeIfAbsent(below, ::StationLogs).of(robot, file.path) ?: return view
        } catch (e: Failure) {
            doubts[file.path] = e.message
            return view
        }
        found[file.path] = UsedStationLog(station.log.name, station.fit)
        return StationOverlay(view, station.station, station.fit, signals).forRules
    }

    /** Returns a sentence that says which log was added to [file], or may belong to it; null for none. */
    fun sentenceOf(file: LogFile): String? = doubts[file.path] ?: found[file.path]?.run {
        val how = if (fit.edges > 1) {
            "${fit.edges} edges of enabled fit within ${shortNumber(fit.error, DIGITS)} s"
        } else {
            "aligned by the clocks, to about 1 s"
        }
        "${file.path}: rules also used the Driver Station log $name; $how."
    }

    /** Returns the same for programs. */
    fun jsonOf(file: LogFile): Map<String, JsonElement> = found[file.path]?.run {
        jsonOf(StationJson(StationFitJson(name, fit.seconds, fit.edges, fit.error)))
    } ?: doubts[file.path]?.let { jsonOf(StationDoubtJson(it)) }.orEmpty()
}

@Serializable
private class StationJson(private val driverStation: StationFitJson)

@Serializable
private class StationDoubtJson(private val driverStationDoubt: String)

@Serializable
private class StationFitJson(
    private val log: String,
    private val seconds: JsonNumber,
    private val edges: Int,
    private val error: JsonNumber,
)

private const val DIGITS = 3
