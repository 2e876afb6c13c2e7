package badlog.page.video

import badlog.page.view.Scene
import badlog.viewer.session.video.FrameClock
import badlog.viewer.session.video.VideoAlignment
import badlog.viewer.state.PlaceAction
import kotlinx.browser.window
import org.w3c.dom.HTMLVideoElement
import kotlin.math.abs

/**
 * Makes [video] move the cursor, and the cursor move the video, as soon as there is an [alignment].
 *
 * @param secondsOfX the number of seconds in one unit of x.
 */
internal class VideoSync(private val video: HTMLVideoElement, private val scene: Scene, private val secondsOfX: Double) {
    private val clock = FrameClock()

    /** When the displayed frame begins, in seconds from the video's start. */
    private var frame = 0.0

    /** The frame from which steps are in progress, and their number. */
    private var from = Double.NaN
    private var steps = 0

    /** Where to seek next, once the current seek is done. */
    private var next = Double.NaN
    private var timer = 0

    /** Whether a frame was reported since the last seek began, and since it ended: a report before that may be of an earlier frame. */
    private var isReported = false
    private var isSure = false
    private var waits = 0

    /** Whether the frame is being found out that the video shows after a pause. */
    private var isSettling = false

    /** Whether the video ended before that: it goes back to its end then, because only from there does it play again from its start. */
    private var isAtEnd = false

    /** Whether the browser does not report which frame is shown after a seek. */
    private var isSilent = false
    private val isStale get() = abs(frame - video.currentTime) > FAR
    private var isOwnSeek = false

    /** Whether the cursor moved the video to where it is: the cursor may be between two frames, and stays there. */
    private var isLed = false
    private var isLeading = false
    private var place = Double.NaN

    /** How the video is aligned with the log; null if they are independent. */
    var alignment: VideoAlignment? = null
        set(value) {
            field = value
            place = Double.NaN
            // The video goes to an existing cursor, even if its first frame is drawn before that.
            isLed = scene.cursor.isPlaced
        }

    init {
        scene.cursor.onChange { if (!isLeading) follow() }
        on("loadedmetadata") { follow() }
        on("play") { leave() }
        on("pause") { settle() }
        on("seeking") {
            if (!isOwnSeek) {
                leave()
                isReported = false
                isSure = false
            }
        }
        on("seeked") {
            isOwnSeek = false
            val wanted = next
            next = Double.NaN
            window.clearTimeout(timer)
            if (!isSettling) waits = 0
            if (!wanted.isNaN()) seek(wanted) else await()
        }
        if (video.asDynamic().requestVideoFrameCallback == null) on("timeupdate") { show(video.currentTime) } else watch()
    }

    private fun on(event: String, action: () -> Unit) = video.addEventListener(event, { action() })

    private fun watch() {
        video.asDynamic().requestVideoFrameCallback { _: Double, shown: dynamic ->
            // First, because a frame that comes to the screen before this is not reported.
            watch()
            isSilent = false
            isReported = true
            isSure = !video.seeking
            show(shown.mediaTime.unsafeCast<Double>())
        }
    }

    /**
     * Finds out which frame the video shows where it was paused or ended: a busy browser may not have reported it, and does so after a seek,
     * unless that is to the very same moment, or comes while the video is still being paused.
     */
    private fun settle() {
        if (!video.paused || video.seeking || !next.isNaN()) return
        isLed = false
        isSettling = true
        isAtEnd = video.ended
        waits = 0
        nudge()
    }

    /** Seeks to where the video is, as exactly as makes a seek: where it ended is its duration, whatever the browser says of the time. */
    private fun nudge() = seek(if (isAtEnd) video.duration - (waits + 1) * LITTLE else video.currentTime + LITTLE)

    /** Shows the frame [count] after the displayed one, or before it if negative. */
    fun step(count: Int) {
        video.pause()
        isLed = false
        isSettling = false
        isAtEnd = false
        window.clearTimeout(timer)
        if (steps == 0) from = if (isStale) video.currentTime else frame
        steps += count
        seek(clock.step(from, steps))
    }

    /** Aligns the displayed frame with [x]. */
    fun align(x: Double) {
        // Where the video stands in a frame that is not reported yet is less than a frame after its start.
        val shown = if (isReported && !isStale) frame else video.currentTime
        alignment = VideoAlignment.of(shown, x, secondsOfX)
        lead(shown)
    }

    /** Seeks to the cursor. */
    fun follow() {
        val x = scene.cursor.x
        val aligned = alignment
        if (aligned == null || x.isNaN() || x == place || video.duration.isNaN()) return
        place = x
        leave()
        isLed = true
        seek(aligned.secondsAt(x, secondsOfX))
    }

    private fun await() {
        timer = window.setTimeout(::arrive, PATIENCE)
    }

    /** Handles the end of a seek. If a step did not leave its frame, tries a longer one, unless the video ends there. */
    private fun arrive() {
        if (video.seeking || !video.paused) return
        val isLate = !isSure && ++waits < MAX_WAITS
        if (isLate && isSettling) return nudge()
        if (isStale || (!isReported && !isLate)) isSilent = true
        val tried = clock.frameSeconds
        if (isSilent) {
            show(video.currentTime)
        } else if (isLate) {
            return await()
        } else if (steps > 0 && clock.step(from, steps * 2) < video.duration) {
            clock.lengthen()
            if (clock.frameSeconds > tried) return seek(clock.step(from, steps))
        }
        steps = 0
        if (isAtEnd) returnToEnd()
    }

    /** Unlike a seek to somewhere else, this leaves known which frame the video shows. */
    private fun returnToEnd() {
        isAtEnd = false
        isSettling = false
        isOwnSeek = true
        video.currentTime = video.duration
    }

    private fun leave() {
        isLed = false
        isSettling = false
        isAtEnd = false
        steps = 0
        from = Double.NaN
    }

    private fun seek(seconds: Double) {
        val target = seconds.coerceIn(0.0, video.duration)
        if (video.seeking) {
            next = target
        } else {
            isOwnSeek = true
            isReported = false
            isSure = false
            video.currentTime = target
        }
    }

    private fun show(time: Double) {
        // A frame from before the seek.
        if (video.seeking && abs(time - video.currentTime) > clock.frameSeconds * 2) return
        if (steps != 0 && time == from) return
        clock.show(time, isNext = abs(steps) == 1 || (!video.paused && video.playbackRate <= 1))
        steps = 0
        frame = time
        if (!video.paused || !isLed) lead(time)
    }

    private fun lead(time: Double) {
        val x = alignment?.xAt(time, secondsOfX) ?: return
        // Not x: a video may be longer than the log.
        isLeading = true
        scene.store.send(PlaceAction.GoTo(x))
        place = scene.cursor.x
        isLeading = false
    }

    private companion object {
        /** A frame this many seconds from the video's position is not the displayed one. */
        const val FAR = 0.25

        /** So many seconds make a seek, but hardly ever another frame. */
        const val LITTLE = 1e-4

        /** Milliseconds after which a frame that the video has sought is on the screen. */
        const val PATIENCE = 150

        /** A busy browser reports the frame that it has sought within this many times [PATIENCE]. */
        const val MAX_WAITS = 8
    }
}
