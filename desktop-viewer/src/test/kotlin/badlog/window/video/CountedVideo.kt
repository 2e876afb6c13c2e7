package badlog.window.video

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.toPixelMap
import org.bytedeco.ffmpeg.global.avcodec.AV_CODEC_ID_MPEG4
import org.bytedeco.ffmpeg.global.avutil.AV_LOG_QUIET
import org.bytedeco.ffmpeg.global.avutil.AV_PIX_FMT_YUV420P
import org.bytedeco.ffmpeg.global.avutil.av_log_set_level
import org.bytedeco.javacv.FFmpegFrameRecorder
import org.bytedeco.javacv.Frame
import java.nio.ByteBuffer
import java.nio.file.Path

/** A video with pictures that count its frames. White squares are the ones of a binary number, worth 1 at the left. */
internal object CountedVideo {
    const val FRAMES_PER_SECOND = 30
    const val FRAMES = 300
    private const val DIGITS = 10
    private const val SQUARE = 24
    private const val HEIGHT = 136

    /** The number of frames from one independent frame to the next. */
    private const val GROUP = 75

    /** Writes the video to [file], to be shown [turnedBy] degrees clockwise. Some frames refer to later ones, as in videos of phones. */
    fun write(file: Path, turnedBy: Int = 0): Path {
        av_log_set_level(AV_LOG_QUIET)
        FFmpegFrameRecorder(file.toFile(), DIGITS * SQUARE, HEIGHT).apply {
            videoCodec = AV_CODEC_ID_MPEG4
            pixelFormat = AV_PIX_FMT_YUV420P
            format = file.fileName.toString().substringAfterLast('.')
            frameRate = FRAMES_PER_SECOND.toDouble()
            gopSize = GROUP
            maxBFrames = 2
            videoBitrate = 1_000_000
            // FFmpeg counts to the left.
            if (turnedBy != 0) setDisplayRotation(-turnedBy.toDouble())
            start()
            for (number in 0 until FRAMES) record(frame(number))
            stop()
            release()
        }
        return file
    }

    private fun frame(number: Int) = Frame(DIGITS * SQUARE, HEIGHT, Frame.DEPTH_UBYTE, 3).apply {
        val pixels = image[0] as ByteBuffer
        for (y in 0 until HEIGHT) {
            for (x in 0 until DIGITS * SQUARE) {
                val isWhite = y < SQUARE && number shr (x / SQUARE) and 1 == 1
                val shade: Byte = if (isWhite) -1 else 0
                for (color in 0 until 3) pixels.put(y * imageStride + x * 3 + color, shade)
            }
        }
    }

    /** Returns the number of the frame that [picture] shows. */
    fun numberIn(picture: ImageBitmap): Int = numberIn(picture) { along, down -> along to down }

    /** Returns the number in a picture that was turned clockwise by a quarter and stands on its short side. */
    fun numberInTurned(picture: ImageBitmap): Int = numberIn(picture) { along, down -> picture.width - 1 - down to along }

    private fun numberIn(picture: ImageBitmap, place: (along: Int, down: Int) -> Pair<Int, Int>): Int {
        val pixels = picture.toPixelMap()
        return (0 until DIGITS).sumOf { digit ->
            val (x, y) = place(digit * SQUARE + SQUARE / 2, SQUARE / 2)
            if (pixels[x, y].green > 0.5f) 1 shl digit else 0
        }
    }
}
