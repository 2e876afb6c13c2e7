package badlog.viewer.video

import androidx.compose.runtime.snapshotFlow
import badlog.analysis.Units
import badlog.plot.video.VideoAlignment
import badlog.plot.video.VideoNote
import badlog.plot.video.enabledStart
import badlog.plot.video.videoNoteOf
import badlog.viewer.files.FileChoice
import badlog.viewer.files.sayNoLog
import badlog.viewer.part.Part
import badlog.viewer.playback.Player
import badlog.viewer.recording.CurrentRecording
import badlog.viewer.settings.SettingsStore
import badlog.viewer.task.Notices
import badlog.viewer.view.AxisView
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path

/**
 * The video beside the log.
 *
 * @property file it; null for none.
 * @property frame what is shown of it; null until the first was read.
 * @property duration how long it lasts, in seconds; 0 while nobody knows.
 * @property alignment where it lies beside the log; null where video and cursor go their own ways.
 * @property problem why there is nothing to see; null while there is.
 */
internal data class ShownVideo(
    val file: Path? = null,
    val frame: VideoFrame? = null,
    val duration: Double = 0.0,
    val alignment: VideoAlignment? = null,
    val problem: String? = null,
)

/**
 * The video beside the [current] log: as soon as it is aligned, the cursor moves the video, and a video that is stepped moves the cursor.
 *
 * @param settings remember for each log which video it was, and where that lies.
 * @param source reads a file: it is given who hears of its frames, and of why there are none.
 */
internal class LogVideo(
    private val scope: CoroutineScope,
    private val current: CurrentRecording,
    private val view: AxisView,
    private val player: Player,
    private val settings: SettingsStore,
    private val files: FileChoice,
    private val notices: Notices,
    private val source: (Path, (ReadFrame) -> Unit, (VideoException) -> Unit) -> FrameSource = ::FrameReader,
) : Part<ShownVideo>(ShownVideo()) {
    private var reader: FrameSource? = null

    /** Drawn until now: what draws it may still be under way. */
    private var before: VideoFrame? = null

    /** Where the video has put the cursor: from there it is not led back. */
    private var place: Double? = null

    /** How many seconds one x is; null where x is not a time, and a video has no place. */
    val secondsOfX: Double? get() = current.recording?.let { Units.secondsIn(it.view.xAxis.unit) }

    /** Follows the cursor, and shows with each log the video that was shown with it before; ends with the window. */
    suspend fun run() = coroutineScope {
        launch { snapshotFlow { current.recording?.file }.collect(::showRemembered) }
        launch { snapshotFlow { Followed(view.cursor, state.alignment?.startSeconds, state.file) }.collect { follow() } }
    }

    /** Asks for a video, and shows it. */
    fun askForVideo() {
        val log = current.recording ?: return sayNoLog(notices)
        files.toRead("Open a video", state.file?.parent ?: log.file.parent)?.let(::open)
    }

    /** Shows [file] beside the log, where a video of that name lay before. */
    fun open(file: Path) {
        if (current.recording == null) return sayNoLog(notices)
        if (secondsOfX == null) return notices.complain("The x axis of this log is not a time, so no video can be shown beside it.")
        show(file, remembered()?.takeIf { Path.of(it.name).fileName == file.fileName }?.alignment)
        remember()
    }

    /** Closes the video, which does not come again with the log. */
    fun close() {
        clear()
        val log = current.recording?.file ?: return
        settings.change { withVideo("$log", null) }
    }

    /** Shows the frame [count] after this one, or before it when negative; the cursor follows. */
    fun step(count: Int) {
        if (state.frame == null) return
        player.change { copy(isPlaying = false) }
        reader?.step(count)
    }

    /** Shows the moment [seconds] from the video's start; the cursor follows. */
    fun seek(seconds: Double) {
        player.change { copy(isPlaying = false) }
        reader?.seek(seconds, leads = true)
    }

    /** The robot is enabled in the frame that is shown: it belongs where the time enabled begins that is visible, or else the first. */
    fun alignEnabled() {
        val open = current.recording ?: return
        val x = enabledStart(open.enabled.map { it.span }, view.viewport.visible)
        if (x == null) notices.complain("This log does not say when the robot was enabled.") else align(x)
    }

    /** Lets video and cursor go their own ways; or, where they do, the frame that is shown belongs where the cursor is. */
    fun toggleLink() {
        if (state.alignment == null) {
            val x = view.cursor ?: return notices.complain("Click a graph first.")
            return align(x)
        }
        change { copy(alignment = null) }
        remember()
    }

    private fun align(x: Double) {
        val frame = state.frame ?: return
        val alignment = VideoAlignment.of(frame.time, x, secondsOfX ?: return)
        change { copy(alignment = alignment) }
        lead(frame.time)
        remember()
    }

    private fun show(file: Path, alignment: VideoAlignment?) {
        clear()
        change { ShownVideo(file, alignment = alignment) }
        // What another file still had under way is of no interest.
        fun ifStill(action: () -> Unit) = scope.launch { if (state.file === file) action() }
        reader = source(file, { read -> ifStill { show(read) } }) { problem -> ifStill { change { copy(problem = problem.message) } } }
    }

    private fun show(read: ReadFrame) {
        before?.close()
        before = state.frame
        val isFirst = before == null
        change { copy(frame = read.frame, duration = read.duration) }
        if (read.leads) {
            lead(read.frame.time)
        } else if (isFirst) {
            follow()
        }
    }

    private fun clear() {
        reader?.close()
        reader = null
        place = null
        change { ShownVideo() }
    }

    private fun lead(seconds: Double) {
        val x = state.alignment?.xAt(seconds, secondsOfX ?: return) ?: return
        place = x
        view.goTo(x)
    }

    private fun follow() {
        val x = view.cursor ?: return
        val seconds = state.alignment?.secondsAt(x, secondsOfX ?: return) ?: return
        if (x == place) return
        place = x
        reader?.seek(seconds, leads = false)
    }

    private fun showRemembered(log: Path?) {
        clear()
        val note = log?.let { remembered() } ?: return
        val file = Path.of(note.name)
        if (secondsOfX != null && Files.isRegularFile(file)) show(file, note.alignment)
    }

    private fun remembered(): VideoNote? = current.recording?.let { settings.state.videos["${it.file}"] }?.let(::videoNoteOf)

    private fun remember() {
        val log = current.recording?.file ?: return
        val file = state.file ?: return
        settings.change { withVideo("$log", VideoNote("${file.toAbsolutePath()}", state.alignment).toText()) }
    }

    private data class Followed(val cursor: Double?, val start: Double?, val file: Path?)
}

/** Lets FFmpeg unpack its libraries into [folder] when it is loaded, rather than into the user's home. */
internal fun unpackFfmpegInto(folder: Path) {
    System.setProperty("org.bytedeco.javacpp.cachedir", "${folder.toAbsolutePath()}")
}

/** Returns whether [file] is a video by its name. */
internal fun isVideo(file: Path): Boolean = file.fileName.toString().substringAfterLast('.').lowercase() in ENDINGS

private val ENDINGS = setOf("mp4", "mov", "m4v", "mkv", "webm", "avi", "mts", "mpg", "3gp")
