package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import badlog.viewer.state.EndFollowing
import badlog.viewer.state.PlaceAction
import badlog.window.state.StateHolder
import java.nio.file.Path

/**
 * Follows the newest moment of the open log while its file grows, with the cursor and the visible range. It ends when a person goes
 * elsewhere, see [EndFollowing]. Its state is the file that another program was writing at the last look; null for none. Use it only on the
 * window's thread.
 *
 * @param recorded returns the file that this window itself records; null for none.
 */
internal class LiveView(private val current: CurrentRecording, private val view: AxisView, private val recorded: () -> Path?) :
    StateHolder<Path?>(null) {
    private var awaited: Path? = null

    /** Whether the open log is being written. */
    val isGrowing: Boolean get() = current.recording?.file?.let { it == recorded() || it == state } == true

    /** Whether the person is at the end of the log, and has not gone elsewhere. */
    val isStaying: Boolean by derivedStateOf { view.following.isAt(view.place) }

    /** Whether the person is still at the end of the log, with the same visible range, and without a selection. */
    val isUntouched: Boolean get() = view.following.isUntouched(view.place)

    /** The newest moment of the open log if that is being written; null otherwise. */
    val newest: Double? get() = current.recording?.span?.to?.takeIf { isGrowing }

    /** Goes to the end of the open log, and follows it if it grows. */
    fun begin() {
        if (current.recording == null) return
        view.send(PlaceAction.GoToEnd)
    }

    /** Stays at the current place from now on, even if the log grows. */
    fun pause() = view.send(PlaceAction.Pause)

    /** Follows [log] as soon as it is open. */
    fun await(log: Path) {
        awaited = log
    }

    /** Handles the opening of another log, which is followed only if it was [awaited][await]. */
    fun opened() {
        val isAwaited = awaited != null && awaited == current.recording?.file
        awaited = null
        change { null }
        if (isAwaited) begin()
    }

    /** Records that another program writes [file] now; null if none writes the open log. */
    fun grows(file: Path?) = change { file }
}
