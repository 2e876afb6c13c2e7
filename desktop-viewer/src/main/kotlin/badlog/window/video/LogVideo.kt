package badlog.window.video

import androidx.compose.runtime.snapshotFlow
import badlog.core.analysis.Units
import badlog.viewer.session.video.VideoAlignment
import badlog.viewer.session.video.VideoNote
import badlog.viewer.session.video.enabledStart
import badlog.viewer.session.video.videoNoteOf
import badlog.viewer.state.PlaceAction
import badlog.window.files.FileChoice
import badlog.window.files.sayNoLog
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.settings.SettingsStore
import badlog.window.state.StateHolder
import badlog.window.task.Notices
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path

/**
 * The video beside the log.
 *
 * @property file its file; null for none.
 * @property frame the current frame; null until the first was read.
 * @property duration its duration in seconds; 0 while unknown.
 * @property alignment its position in the log's time; null if video and cursor are not linked.
 * @property problem the reason why the video cannot be shown; null if it can.
 */
internal data class ShownVideo(
    val file: Path? = null,
    val frame: VideoFrame? = null,
    val duration: Double = 0.0,
    val alignment: VideoAlignment? = null,
    val problem: String? = null,
)

/**
 * The video beside the [current] log. Once they are aligned, the cursor moves the video, and stepping the video moves the cursor.
 *
 * @param settings remember the video of each log and its alignment.
 * @param source opens a file; it receives the callbacks for frames and for failures.
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
) : StateHolder<ShownVideo>(ShownVideo()) {
    private var reader: FrameSource? = null

    /** The previous frame, which may still be being drawn. */
    private var before: VideoFrame? = null

    /** The place to which the video has moved the cursor, which does not move the video again. */
    private var place: Double? = null

    /** The cursor at the last step or move of the video. If the cursor has moved since then, the video does not move it. */
    private var cursorBefore: Double? = null

    /** The number of seconds per unit of x. Null if x is not a time, so that a video cannot be aligned. */
    val secondsOfX: Double? get() = current.recording?.let { Units.secondsIn(it.view.xAxis.unit) }

    /** Follows the cursor, and shows the last video of each opened log, until cancelled. */
    suspend fun run() = coroutineScope {
        launch { snapshotFlow { current.recording?.file }.collect(::showRemembered) }
        launch { snapshotFlow { Followed(view.cursor, state.alignment?.startSeconds, state.file) }.collect { follow() } }
    }

    /** Asks the user for a video and shows it. */
    fun askForVideo() {
        val log = current.recording ?: return sayNoLog(notices)
        files.toRead("Open a video", state.file?.parent ?: log.file.parent)?.let(::open)
    }

    /** Shows [file] beside the log, with the alignment of the last video of that name. */
    fun open(file: Path) {
        if (current.recording == null) return sayNoLog(notices)
        if (secondsOfX == null) return notices.complain(VideoAlignment.NO_TIME)
        show(file, remembered()?.takeIf { Path.of(it.name).fileName == file.fileName }?.alignment)
        remember()
    }

    /** Closes the video, which is then not shown with the log again. */
    fun close() {
        clear()
        val log = current.recording?.file ?: return
        settings.change { withVideo("$log", null) }
    }

    /** Shows the frame [count] frames after this one, or before it if negative; the cursor follows. */
    fun step(count: Int) {
        if (state.frame == null) return
        player.change { copy(isPlaying = false) }
        cursorBefore = view.cursor
        reader?.step(count)
    }

    /** Shows the frame at [seconds] from the start of the video; the cursor follows. */
    fun seek(seconds: Double) {
        player.change { copy(isPlaying = false) }
        cursorBefore = view.cursor
        reader?.seek(seconds, leads = true)
    }

    /**
     * Aligns the current frame, in which the robot is enabled, with the start of an enabled period. It is the visible period, or otherwise
     * the first one.
     */
    fun alignEnabled() {
        val open = current.recording ?: return
        val x = enabledStart(open.enabled.map { it.span }, view.viewport.visible)
        if (x == null) notices.complain(VideoAlignment.NEVER_ENABLED) else align(x)
    }

    /** Unlinks video and cursor; if they are unlinked, aligns the current frame with the cursor. */
    fun toggleLink() {
        if (state.alignment == null) {
            val x = view.cursor ?: return notices.complain(VideoAlignment.NO_CURSOR)
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
        // Late results of another file are ignored.
        fun ifStill(action: () -> Unit) = scope.launch { if (state.file === file) action() }
        reader = source(file, { read -> ifStill { show(read) } }) { problem -> ifStill { change { copy(problem = problem.message) } } }
    }

    private fun show(read: ReadFrame) {
        before?.close()
        before = state.frame
        val isFirst = before == null
        change { copy(frame = read.frame, duration = read.duration) }
        if (read.leads) {
            if (view.cursor == cursorBefore) lead(read.frame.time)
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
        // The log limits the cursor, since a video may be longer: the place is read afterwards.
        view.send(PlaceAction.GoTo(x))
        // From the state, because calculating view.cursor may notify observers of the cursor.
        place = view.place.cursors.x
        cursorBefore = place
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

/** Makes FFmpeg unpack its libraries into [folder] when it is loaded, instead of the user's home. */
internal fun unpackFfmpegInto(folder: Path) {
    System.setProperty("org.bytedeco.javacpp.cachedir", "${folder.toAbsolutePath()}")
}

/** Returns whether [file] is a video, judged by its name. */
internal fun isVideo(file: Path): Boolean = file.fileName.toString().substringAfterLast('.').lowercase() in ENDINGS

private val ENDINGS = setOf("mp4", "mov", "m4v", "mkv", "webm", "avi", "mts", "mpg", "3gp")
