package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.Stay
import badlog.window.state.StateHolder
import java.nio.file.Path

/**
 * Stays at the newest moment of the open log while its file grows: the cursor is there, and the visible range moves along, until a person
 * goes elsewhere, see [Stay]. Its state is the file that another program was writing when it was looked at last; null for none. Use it only
 * on the window's thread.
 *
 * @param recorded returns the file that this window itself records; null for none.
 */
internal class LiveView(private val current: CurrentRecording, private val view: AxisView, private val recorded: () -> Path?) :
    StateHolder<Path?>(null) {
    private var awaited: Path? = null

    /** Whether the open log is being written. */
    val isGrowing: Boolean get() = current.recording?.file?.let { it == recorded() || it == state } == true

    /** Whether the person is at the end of the log, and has not gone elsewhere. */
    val isStaying: Boolean by derivedStateOf { view.stay.isAt(view.place) }

    /** Whether nothing was looked at since the end was shown: no part of it, and no selected range. */
    val isUntouched: Boolean get() = view.stay.isUntouched(view.place)

    /** The newest moment of the open log if that is being written; null otherwise. */
    val newest: Double? get() = current.recording?.span?.to?.takeIf { isGrowing }

    /** Goes to the end of the open log; if that grows, stays there. */
    fun begin() {
        if (current.recording == null) return
        view.send(PlaceAction.GoToEnd)
    }

    /** Stays where it is from now on, though the log grows. */
    fun pause() = view.send(PlaceAction.Pause)

    /** Begins with [log] as soon as it is open. */
    fun await(log: Path) {
        awaited = log
    }

    /** Another log is open from now on, which begins where it is, unless it was [awaited][await]. */
    fun opened() {
        val isAwaited = awaited != null && awaited == current.recording?.file
        awaited = null
        change { null }
        if (isAwaited) begin()
    }

    /** Says that another program writes [file] now; null if none writes the open log. */
    fun grows(file: Path?) = change { file }
}
