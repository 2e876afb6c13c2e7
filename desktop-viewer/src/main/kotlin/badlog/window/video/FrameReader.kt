package badlog.window.video

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.asComposeImageBitmap
import org.bytedeco.ffmpeg.avcodec.AVCodecParameters
import org.bytedeco.ffmpeg.avformat.AVStream
import org.bytedeco.ffmpeg.avutil.AVFrame
import org.bytedeco.ffmpeg.global.avcodec.AV_PKT_DATA_DISPLAYMATRIX
import org.bytedeco.ffmpeg.global.avcodec.av_packet_side_data_get
import org.bytedeco.ffmpeg.global.avformat.av_guess_sample_aspect_ratio
import org.bytedeco.ffmpeg.global.avutil.AV_PIX_FMT_BGRA
import org.bytedeco.ffmpeg.global.avutil.av_display_rotation_get
import org.bytedeco.ffmpeg.global.avutil.av_frame_alloc
import org.bytedeco.ffmpeg.global.avutil.av_frame_free
import org.bytedeco.ffmpeg.global.avutil.av_frame_get_buffer
import org.bytedeco.ffmpeg.global.avutil.av_frame_unref
import org.bytedeco.ffmpeg.global.avutil.av_q2d
import org.bytedeco.ffmpeg.global.swscale.SWS_BILINEAR
import org.bytedeco.ffmpeg.global.swscale.sws_freeContext
import org.bytedeco.ffmpeg.global.swscale.sws_getCachedContext
import org.bytedeco.ffmpeg.global.swscale.sws_scale
import org.bytedeco.ffmpeg.swscale.SwsContext
import org.bytedeco.javacpp.DoublePointer
import org.bytedeco.javacpp.IntPointer
import org.jetbrains.skia.Bitmap
import org.jetbrains.skia.ColorAlphaType
import org.jetbrains.skia.ColorType
import org.jetbrains.skia.ImageInfo
import java.nio.file.Path
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.atomic.AtomicReference
import kotlin.math.roundToInt

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

/**
 * A frame of a video.
 *
 * @property time its start, in seconds from the start of the video.
 */
internal class VideoFrame(val time: Double, private val bitmap: Bitmap) : AutoCloseable {
    /** The image to draw, upright. */
    val image: ImageBitmap = bitmap.asComposeImageBitmap()

    /** Frees its memory, which is too much to leave to the garbage collector. It must not be drawn afterwards. */
    override fun close() = bitmap.close()
}

/** Makes pictures of decoded frames: upright, with square pixels, and with no side longer than [MAX_SIDE]. */
internal class FramePicture : AutoCloseable {
    /** The clockwise rotation of a frame in quarter turns, 0 to 3: phones store frames as the sensor saw them. */
    var turns = 0
    private val scaled: AVFrame = av_frame_alloc()
    private var scaler: SwsContext? = null

    /** Returns a picture of [frame], which was decoded from [stream]. The caller must close it. */
    fun of(frame: AVFrame, stream: AVStream): Bitmap {
        val aspect = av_q2d(av_guess_sample_aspect_ratio(null, stream, frame)).takeIf { it > 0 && it.isFinite() } ?: 1.0
        val factor = minOf(1.0, MAX_SIDE / maxOf(frame.width() * aspect, frame.height().toDouble()))
        val width = (frame.width() * aspect * factor).roundToInt().coerceAtLeast(1)
        val height = (frame.height() * factor).roundToInt().coerceAtLeast(1)
        scale(frame, width, height)
        val stride = scaled.linesize(0)
        val bytes = ByteArray(stride * height)
        scaled.data(0).get(bytes)
        return if (turns == 0) bitmapOf(width, height, bytes, stride) else turned(width, height, bytes, stride)
    }

    override fun close() {
        scaler?.let(::sws_freeContext)
        av_frame_free(scaled)
    }

    private fun scale(frame: AVFrame, width: Int, height: Int) {
        scaler = sws_getCachedContext(
            scaler,
            frame.width(),
            frame.height(),
            frame.format(),
            width,
            height,
            AV_PIX_FMT_BGRA,
            SWS_BILINEAR,
            null,
            null,
            null as DoublePointer?,
        )
        if (scaled.width() != width || scaled.height() != height) {
            av_frame_unref(scaled)
            scaled.width(width)
            scaled.height(height)
            scaled.format(AV_PIX_FMT_BGRA)
            av_frame_get_buffer(scaled, 0)
        }
        sws_scale(scaler, frame.data(), frame.linesize(), 0, frame.height(), scaled.data(), scaled.linesize())
    }

    private fun turned(width: Int, height: Int, bytes: ByteArray, stride: Int): Bitmap {
        val isSideways = turns % 2 == 1
        val newWidth = if (isSideways) height else width
        val newHeight = if (isSideways) width else height
        val turned = ByteArray(width * height * BYTES)
        for (y in 0 until newHeight) {
            for (x in 0 until newWidth) {
                val from = when (turns) {
                    1 -> (height - 1 - x) * stride + y * BYTES
                    2 -> (height - 1 - y) * stride + (width - 1 - x) * BYTES
                    else -> x * stride + (width - 1 - y) * BYTES
                }
                bytes.copyInto(turned, (y * newWidth + x) * BYTES, from, from + BYTES)
            }
        }
        return bitmapOf(newWidth, newHeight, turned, newWidth * BYTES)
    }

    private fun bitmapOf(width: Int, height: Int, bytes: ByteArray, stride: Int) = Bitmap().apply {
        installPixels(ImageInfo(width, height, ColorType.BGRA_8888, ColorAlphaType.OPAQUE), bytes, stride)
        // An immutable bitmap is drawn without a copy.
        setImmutable()
    }
}

/** Returns the clockwise rotation in quarter turns for a video with [parameters]. */
internal fun quarterTurns(parameters: AVCodecParameters): Int {
    val side = parameters.coded_side_data()?.takeUnless { it.isNull } ?: return 0
    val matrix = av_packet_side_data_get(side, parameters.nb_coded_side_data(), AV_PKT_DATA_DISPLAYMATRIX) ?: return 0
    val degrees = av_display_rotation_get(IntPointer(matrix.data())).takeIf { it.isFinite() } ?: return 0
    return (-degrees / QUARTER).roundToInt().mod(FULL)
}

private const val QUARTER = 90
private const val FULL = 4

private const val BYTES = 4

/** The longest side in pixels: larger than the panel on most screens; a 4K picture would take 33 MB. */
private const val MAX_SIDE = 1280.0
