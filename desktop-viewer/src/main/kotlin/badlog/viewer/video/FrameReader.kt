package badlog.viewer.video

import java.nio.file.Path
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicReference

/** What reads the frames of one video. What it is asked for comes later; of several requests that wait, the latest wins. */
internal interface FrameSource : AutoCloseable {
    /** Wants the frame of the moment [seconds]; [leads] is passed on with it. */
    fun seek(seconds: Double, leads: Boolean)

    /** Wants the frame [count] after the one that is shown, or before it when negative. */
    fun step(count: Int)
}

/**
 * What a [FrameSource] has read.
 *
 * @property duration how long the video lasts, in seconds; 0 where its file does not say.
 * @property leads whether the cursor is to follow: the video was stepped, or moved by itself.
 */
internal class ReadFrame(val frame: VideoFrame, val duration: Double, val leads: Boolean)

/**
 * Reads [path] on a thread of its own, from its first frame on.
 *
 * @param onFrame hears of each frame, on that thread.
 * @param onFailure hears, on that thread, why there is nothing to see.
 */
internal class FrameReader(
    private val path: Path,
    private val onFrame: (ReadFrame) -> Unit,
    private val onFailure: (VideoException) -> Unit,
) : FrameSource {
    private val thread: ExecutorService = Executors.newSingleThreadExecutor { work -> Thread(work, "video").apply { isDaemon = true } }
    private val wanted = AtomicReference<Wanted?>(null)

    /** Of the thread alone. */
    private var file: VideoFile? = null

    init {
        want { Wanted(0.0, 0, leads = false) }
    }

    override fun seek(seconds: Double, leads: Boolean) = want { Wanted(seconds, 0, leads) }

    override fun step(count: Int) = want { Wanted(it?.seconds, (it?.steps ?: 0) + count, leads = true) }

    override fun close() {
        thread.execute {
            file?.close()
            file = null
        }
        thread.shutdown()
    }

    private fun want(next: (Wanted?) -> Wanted) {
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

    private class Wanted(val seconds: Double?, val steps: Int, val leads: Boolean)
}
