package badlog.page.video

import badlog.page.view.Scene
import badlog.viewer.session.video.FrameClock
import badlog.viewer.session.video.VideoAlignment
import badlog.viewer.state.PlaceAction
import kotlinx.browser.window
import org.w3c.dom.HTMLVideoElement
import kotlin.math.abs

/**
 * Moves the cursor with [video], and [video] with the cursor, as soon as there is an [alignment].
 *
 * @param secondsOfX the number of seconds in one unit of x.
 */
internal class VideoSync(private val video: HTMLVideoElement, private val scene: Scene, private val secondsOfX: Double) {
    private val clock = FrameClock()

    /** The start of the displayed frame, in seconds from the video's start. */
    private var frame = 0.0

    /** The frame from which steps are in progress, and their number. */
    private var from = Double.NaN
    private var steps = 0

    /** The next position to seek, once the current seek is done. */
    private var next = Double.NaN
    private var timer = 0

    /** Whether a frame was reported since the last seek began, and since it ended. An earlier report may be about an earlier frame. */
    private var isReported = false
    private var isSure = false
    private var waits = 0

    /** Whether the video has paused and its displayed frame is not known yet. */
    private var isSettling = false

    /** Whether the video had ended before settling. It then returns to its end, because only from there it plays again from its start. */
    private var isAtEnd = false

    /** Whether the browser does not report the frame shown after a seek. */
    private var isSilent = false
    private val isStale get() = abs(frame - video.currentTime) > FAR
    private var isOwnSeek = false

    /** Whether the cursor moved the video last. The cursor may be between two frames, and stays there. */
    private var isLed = false
    private var isLeading = false
    private var place = Double.NaN

    /** The alignment of the video with the log; null if they are independent. */
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
            // First, because a frame that reaches the screen before this is not reported.
            watch()
            isSilent = false
            isReported = true
            isSure = !video.seeking
            show(shown.mediaTime.unsafeCast<Double>())
        }
    }

    /**
     * Determines the frame at which the video was paused or ended. A busy browser may not have reported it, but reports it after a seek,
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

    /**
     * Seeks to almost the current position, far enough for a real seek. An ended video is at its duration, whatever time the browser
     * reports.
     */
    private fun nudge() = seek(if (isAtEnd) video.duration - (waits + 1) * LITTLE else video.currentTime + LITTLE)

    /** Moves by [count] frames from the displayed one, backward if it is negative. */
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
        // A position in a frame that is not reported yet is less than a frame after the frame's start.
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

    /** Returns an ended video to its end. Unlike other seeks, this does not change which frame is displayed. */
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
        // The cursor may not reach x, because a video may be longer than the log.
        isLeading = true
        scene.store.send(PlaceAction.GoTo(x))
        place = scene.cursor.x
        isLeading = false
    }
}

/** The distance in seconds from the video's position at which a frame cannot be the displayed one. */
private const val FAR = 0.25

/** A distance in seconds that is enough for a seek, but hardly ever reaches another frame. */
private const val LITTLE = 1e-4

/** The milliseconds after a seek until its frame is on the screen. */
private const val PATIENCE = 150

/** The number of [PATIENCE] intervals within which a busy browser reports the frame of a seek. */
private const val MAX_WAITS = 8
