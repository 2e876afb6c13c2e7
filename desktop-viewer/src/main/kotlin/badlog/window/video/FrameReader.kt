package badlog.window.video

import java.nio.file.Path
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicReference

/** Reads the frames of one video asynchronously; of several waiting requests, only the latest is answered. */
internal interface FrameSource : AutoCloseable {
    /** Requests the frame at [seconds]; the answer has the same [leads]. */
    fun seek(seconds: Double, leads: Boolean)

    /** Requests the frame [count] frames after the current one, or before it if negative. */
    fun step(count: Int)
}

/**
 * A frame read by a [FrameSource].
 *
 * @property duration the duration of the video in seconds; 0 if its file does not contain it.
 * @property leads whether the cursor follows the video, because the user stepped or moved it.
 */
internal class ReadFrame(val frame: VideoFrame, val duration: Double, val leads: Boolean)

/**
 * Reads [path] on its own thread, starting with the first frame.
 *
 * @param onFrame receives each frame, on that thread.
 * @param onFailure receives, on that thread, the reason why the video cannot be shown.
 */
internal class FrameReader(
    private val path: Path,
    private val onFrame: (ReadFrame) -> Unit,
    private val onFailure: (VideoException) -> Unit,
) : FrameSource {
    private val thread: ExecutorService = Executors.newSingleThreadExecutor { work -> Thread(work, "video").apply { isDaemon = true } }
    private val wanted = AtomicReference<FrameRequest?>(null)

    /** Used only by the thread. */
    private var file: VideoFile? = null

    init {
        want { FrameRequest(0.0, 0, leads = false) }
    }

    override fun seek(seconds: Double, leads: Boolean) = want { FrameRequest(seconds, 0, leads) }

    override fun step(count: Int) = want { FrameRequest(it?.seconds, (it?.steps ?: 0) + count, leads = true) }

    override fun close() {
        thread.execute {
            file?.close()
            file = null
        }
        thread.shutdown()
    }

    private fun want(next: (FrameRequest?) -> FrameRequest) {
        if (wanted.getAndUpdate(next) == null && !thread.isShutdown) thread.execute(::serve)
    }

    private fun serve() {
        val request = wanted.getAndSet(null) ?: return
        try {
            val open = file ?: VideoFile(path).also { file = it }
            request.seconds?.let(open::seek)
            repeat(request.steps) { open.next() }
            repeat(-request.steps) { open.previous() }
            onFrame(ReadFrame(open.picture(), open.duration, request.leads))
        } catch (e: VideoException) {
            onFailure(e)
        } catch (e: LinkageError) {
            onFailure(VideoException("Videos cannot be shown on this computer, as FFmpeg does not load: ${e.message}", e))
        }
    }

    private class FrameRequest(val seconds: Double?, val steps: Int, val leads: Boolean)
}
