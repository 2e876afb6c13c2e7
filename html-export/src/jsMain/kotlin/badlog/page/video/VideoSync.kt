package badlog.page.video

import badlog.page.view.Scene
import badlog.plot.video.FrameClock
import badlog.plot.video.VideoAlignment
import kotlinx.browser.window
import org.w3c.dom.HTMLVideoElement
import kotlin.math.abs

/**
 * Lets [video] move the cursor, and the cursor move the video, as soon as there is an [alignment].
 *
 * @param secondsOfX how many seconds one x is.
 */
internal class VideoSync(private val video: HTMLVideoElement, private val scene: Scene, private val secondsOfX: Double) {
    private val clock = FrameClock()

    /** When the frame that is shown begins, in seconds from the video's start. */
    private var frame = 0.0

    /** From which frame how many steps are on their way. */
    private var from = Double.NaN
    private var steps = 0

    /** Where to go when the video has arrived where it goes now. */
    private var next = Double.NaN
    private var timer = 0

    /** Whether the browser does not report which frame is shown after a jump. */
    private var isSilent = false
    private val isStale get() = abs(frame - video.currentTime) > FAR
    private var isOwnSeek = false

    /** Whether the cursor led the video to where it is: it may stand between two frames, and stays. */
    private var isLed = false
    private var isLeading = false
    private var place = Double.NaN

    /** Where the video lies beside the log; null where each goes its own way. */
    var alignment: VideoAlignment? = null
        set(value) {
            field = value
            place = Double.NaN
            // The video goes to a cursor that is there, also where its first frame is drawn before that is done.
            isLed = scene.cursor.isPlaced
        }

    init {
        scene.cursor.onChange { if (!isLeading) follow() }
        on("loadedmetadata") { follow() }
        on("play") { leave() }
        on("seeking") { if (!isOwnSeek) leave() }
        on("seeked") {
            isOwnSeek = false
            val wanted = next
            next = Double.NaN
            window.clearTimeout(timer)
            if (!wanted.isNaN()) seek(wanted) else timer = window.setTimeout(::arrive, PATIENCE)
        }
        if (video.asDynamic().requestVideoFrameCallback == null) on("timeupdate") { show(video.currentTime) } else watch()
    }

    private fun on(event: String, action: () -> Unit) = video.addEventListener(event, { action() })

    private fun watch() {
        video.asDynamic().requestVideoFrameCallback { _: Double, shown: dynamic ->
            isSilent = false
            show(shown.mediaTime.unsafeCast<Double>())
            watch()
        }
    }

    /** Shows the frame [count] after the one that is shown, or before it when negative. */
    fun step(count: Int) {
        video.pause()
        isLed = false
        window.clearTimeout(timer)
        if (steps == 0) from = if (isStale) video.currentTime else frame
        steps += count
        seek(clock.step(from, steps))
    }

    /** What is shown now belongs to [x]. */
    fun align(x: Double) {
        alignment = VideoAlignment.of(frame, x, secondsOfX)
        lead(frame)
    }

    /** Goes where the cursor is. */
    fun follow() {
        val x = scene.cursor.x
        val aligned = alignment
        if (aligned == null || x.isNaN() || x == place || video.duration.isNaN()) return
        place = x
        leave()
        isLed = true
        seek(aligned.secondsAt(x, secondsOfX))
    }

    /** The video is where it was to go, and stands. Where a step has not left its frame, tries a longer one, unless the video has nothing there. */
    private fun arrive() {
        if (video.seeking || !video.paused) return
        if (isStale) isSilent = true
        val tried = clock.frameSeconds
        if (isSilent) {
            show(video.currentTime)
        } else if (steps > 0 && clock.step(from, steps * 2) < video.duration) {
            clock.lengthen()
            if (clock.frameSeconds > tried) return seek(clock.step(from, steps))
        }
        steps = 0
    }

    private fun leave() {
        isLed = false
        steps = 0
        from = Double.NaN
    }

    private fun seek(seconds: Double) {
        val target = seconds.coerceIn(0.0, video.duration)
        if (video.seeking) {
            next = target
        } else {
            isOwnSeek = true
            video.currentTime = target
        }
    }

    private fun show(time: Double) {
        // What was on its way to the screen before the jump.
        if (video.seeking && abs(time - video.currentTime) > clock.frameSeconds * 2) return
        if (steps != 0 && time == from) return
        clock.show(time, isNext = abs(steps) == 1 || (!video.paused && video.playbackRate <= 1))
        steps = 0
        frame = time
        if (!video.paused || !isLed) lead(time)
    }

    private fun lead(time: Double) {
        val x = alignment?.xAt(time, secondsOfX) ?: return
        isLeading = true
        place = x
        scene.cursor.change { pinnedAt(x) }
        scene.range.change { revealing(x) }
        isLeading = false
    }

    private companion object {
        /** So many seconds beside where the video is, a frame is not the one that is shown. */
        const val FAR = 0.25

        /** Milliseconds after which a frame is on the screen that the video has gone to. */
        const val PATIENCE = 150
    }
}
