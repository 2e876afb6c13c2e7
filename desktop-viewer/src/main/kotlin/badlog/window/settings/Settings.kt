package badlog.window.settings

import badlog.window.theme.Theme
import kotlinx.serialization.Serializable

/**
 * The user's settings, stored between starts.
 *
 * @property theme light, dark, or as the system is.
 * @property recentFolders the folders opened last, the latest first.
 * @property previewTopic the topic that the list of logs previews; null for the battery voltage.
 * @property graphHeight the height of a graph, in dp.
 * @property fitsGraphs whether graphs share the window's height instead, if they are few enough.
 * @property window the last place of the window; null before the first time.
 * @property panes the widths of the parts beside the graphs.
 * @property robot the robot that logs were fetched from last, as it was typed.
 * @property stations whether the Driver Station's log of the same match is shown with a log, by the log's path; the latest last.
 * @property videos the video of a log, by the log's path, as `VideoNote` writes it; the latest last.
 * @property fields the file of the field on which the paths of the logs in a folder are drawn, by the folder's path; the latest last.
 * @property ringsForLogs whether there is a sound when a log arrives.
 * @property author the name of the person who changes the to-do list; empty for the name of the system's user.
 */
@Serializable
internal data class Settings(
    val theme: Theme = Theme.SYSTEM,
    val recentFolders: List<String> = emptyList(),
    val previewTopic: String? = null,
    val graphHeight: Int = 150,
    val fitsGraphs: Boolean = true,
    val window: WindowPlace? = null,
    val panes: PaneWidths = PaneWidths(),
    val robot: String = "",
    val stations: Map<String, Boolean> = emptyMap(),
    val videos: Map<String, String> = emptyMap(),
    val fields: Map<String, String> = emptyMap(),
    val ringsForLogs: Boolean = false,
    val author: String = "",
) {
    /** Returns a copy with [folder] as the one opened last. */
    fun opened(folder: String): Settings = copy(recentFolders = (listOf(folder) + (recentFolders - folder)).take(MAX_RECENT))

    /** Returns a copy that says whether the Driver Station's log [isShown] with [log]. */
    fun withStation(log: String, isShown: Boolean): Settings = copy(stations = stations.latest(mapOf(log to isShown)))

    /** Returns a copy with [note] as the video of [log]; null removes it. */
    fun withVideo(log: String, note: String?): Settings =
        copy(videos = if (note == null) videos - log else videos.latest(mapOf(log to note)))

    /** Returns a copy with [file] as the field for the logs in [folder]; null for the field beside them. */
    fun withField(folder: String, file: String?): Settings =
        copy(fields = if (file == null) fields - folder else fields.latest(mapOf(folder to file)))
}

/** Returns this map with [changes], limited to the latest [MAX_LOGS]. */
private fun <T> Map<String, T>.latest(changes: Map<String, T>): Map<String, T> =
    (filterKeys { it !in changes } + changes).toList().takeLast(MAX_LOGS).toMap()

/** Returns the merged settings of two windows: a setting that [mine] has not changed since [before] is as in [theirs]. */
internal fun merged(mine: Settings, before: Settings, theirs: Settings): Settings {
    fun <T> of(property: (Settings) -> T) = property(if (property(mine) == property(before)) theirs else mine)
    val recent = of(Settings::recentFolders)
    return Settings(
        theme = of(Settings::theme),
        recentFolders = (recent + theirs.recentFolders).distinct().take(MAX_RECENT),
        previewTopic = of(Settings::previewTopic),
        graphHeight = of(Settings::graphHeight),
        fitsGraphs = of(Settings::fitsGraphs),
        window = of(Settings::window),
        panes = of(Settings::panes),
        robot = of(Settings::robot),
        stations = theirs.stations.latest(mine.stations.filter { (log, isShown) -> before.stations[log] != isShown }),
        videos = merged(mine.videos, before.videos, theirs.videos),
        fields = merged(mine.fields, before.fields, theirs.fields),
        ringsForLogs = of(Settings::ringsForLogs),
        author = of(Settings::author),
    )
}

private fun merged(mine: Map<String, String>, before: Map<String, String>, theirs: Map<String, String>) =
    (theirs - (before.keys - mine.keys)).latest(mine.filter { (key, value) -> before[key] != value })

private const val MAX_RECENT = 10

/** The largest number of logs with a remembered choice; a team opens fewer in a season. */
private const val MAX_LOGS = 500

/** The place of a window on the screen, in dp; with [isMaximized], it fills the screen. */
@Serializable
internal data class WindowPlace(val x: Int, val y: Int, val width: Int, val height: Int, val isMaximized: Boolean)
