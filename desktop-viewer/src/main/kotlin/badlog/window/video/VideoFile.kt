package badlog.window.video

import org.bytedeco.ffmpeg.avcodec.AVCodec
import org.bytedeco.ffmpeg.avcodec.AVCodecContext
import org.bytedeco.ffmpeg.avcodec.AVPacket
import org.bytedeco.ffmpeg.avformat.AVFormatContext
import org.bytedeco.ffmpeg.avutil.AVDictionary
import org.bytedeco.ffmpeg.avutil.AVFrame
import org.bytedeco.ffmpeg.global.avcodec.av_packet_alloc
import org.bytedeco.ffmpeg.global.avcodec.av_packet_free
import org.bytedeco.ffmpeg.global.avcodec.av_packet_unref
import org.bytedeco.ffmpeg.global.avcodec.avcodec_alloc_context3
import org.bytedeco.ffmpeg.global.avcodec.avcodec_find_decoder
import org.bytedeco.ffmpeg.global.avcodec.avcodec_flush_buffers
import org.bytedeco.ffmpeg.global.avcodec.avcodec_free_context
import org.bytedeco.ffmpeg.global.avcodec.avcodec_open2
import org.bytedeco.ffmpeg.global.avcodec.avcodec_parameters_to_context
import org.bytedeco.ffmpeg.global.avcodec.avcodec_receive_frame
import org.bytedeco.ffmpeg.global.avcodec.avcodec_send_packet
import org.bytedeco.ffmpeg.global.avformat.AVSEEK_FLAG_BACKWARD
import org.bytedeco.ffmpeg.global.avformat.av_find_best_stream
import org.bytedeco.ffmpeg.global.avformat.av_read_frame
import org.bytedeco.ffmpeg.global.avformat.av_seek_frame
import org.bytedeco.ffmpeg.global.avformat.avformat_close_input
import org.bytedeco.ffmpeg.global.avformat.avformat_find_stream_info
import org.bytedeco.ffmpeg.global.avformat.avformat_open_input
import org.bytedeco.ffmpeg.global.avutil.AVERROR_EAGAIN
import org.bytedeco.ffmpeg.global.avutil.AVMEDIA_TYPE_VIDEO
import org.bytedeco.ffmpeg.global.avutil.AV_LOG_QUIET
import org.bytedeco.ffmpeg.global.avutil.AV_NOPTS_VALUE
import org.bytedeco.ffmpeg.global.avutil.av_frame_alloc
import org.bytedeco.ffmpeg.global.avutil.av_frame_free
import org.bytedeco.ffmpeg.global.avutil.av_frame_unref
import org.bytedeco.ffmpeg.global.avutil.av_log_set_level
import org.bytedeco.ffmpeg.global.avutil.av_q2d
import org.bytedeco.javacpp.BytePointer
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.floor

/**
 * The frames of a video. Each seek finds the exact frame. Use it from one thread at a time. It decodes from an earlier frame to which the
 * file can jump. FFmpeg is loaded when the first file is opened.
 *
 * Times are in seconds from the start of the file, as browsers count them.
 *
 * @throws VideoException if [path] is not a readable video.
 */
internal class VideoFile(private val path: Path) : AutoCloseable {
    private val format = AVFormatContext(null)
    private var codec: AVCodecContext? = null
    private val packet: AVPacket
    private var stream = 0
    private var tick = 0.0
    private var origin = 0.0
    private var isAtEnd = false

    /** The current frame, and the next one. */
    private var shown: TimedFrame
    private var ahead: TimedFrame
    private val picture: FramePicture

    /** The duration of the video in seconds; 0 if the file does not contain it. */
    val duration: Double get() = maxOf(0.0, format.duration() / MICROS)

    /** The start of the current frame. */
    val time: Double get() = shown.time

    init {
        if (!Files.isReadable(path)) throw VideoException("${path.fileName} cannot be read; check that it is still there.")
        av_log_set_level(AV_LOG_QUIET)
        packet = av_packet_alloc()
        shown = TimedFrame(av_frame_alloc())
        ahead = TimedFrame(av_frame_alloc())
        picture = FramePicture()
        val isOpen = open() && decode(ahead)
        if (!isOpen) {
            close()
            throw VideoException("${path.fileName} cannot be shown: it is not a video, or it is damaged.")
        }
        next()
    }

    private fun open(): Boolean {
        if (avformat_open_input(format, BytePointer("${path.toAbsolutePath()}", "UTF-8"), null, null as AVDictionary?) < 0) return false
        if (avformat_find_stream_info(format, null as AVDictionary?) < 0) return false
        stream = av_find_best_stream(format, AVMEDIA_TYPE_VIDEO, -1, -1, null as AVCodec?, 0)
        if (stream < 0) return false
        val parameters = format.streams(stream).codecpar()
        val decoder = avcodec_find_decoder(parameters.codec_id()) ?: return false
        val context = avcodec_alloc_context3(decoder)
        codec = context
        if (avcodec_parameters_to_context(context, parameters) < 0) return false
        context.thread_count(THREADS)
        tick = av_q2d(format.streams(stream).time_base())
        origin = format.start_time().let { if (it == AV_NOPTS_VALUE) 0.0 else it / MICROS }
        picture.turns = quarterTurns(parameters)
        return avcodec_open2(context, decoder, null as AVDictionary?) >= 0
    }

    /** Shows the last frame that begins at [seconds] or earlier; before the start, the first frame. */
    fun seek(seconds: Double) {
        val isNear = seconds - shown.time in -TOLERANCE..NEAR
        if (!isNear) jump(seconds)
        while (ahead.isThere && ahead.time <= seconds + TOLERANCE) next()
    }

    /** Shows the next frame. Returns false at the end. */
    fun next(): Boolean {
        if (!ahead.isThere) return false
        val free = shown
        shown = ahead
        ahead = free
        decode(ahead)
        return true
    }

    /** Shows the previous frame. Returns false at the start. */
    fun previous(): Boolean {
        val before = shown.time
        seek(before - 2 * TOLERANCE)
        return shown.time < before
    }

    /** Returns the picture of the current frame. */
    fun picture(): VideoFrame = VideoFrame(shown.time, picture.of(shown.frame, format.streams(stream)))

    override fun close() {
        picture.close()
        shown.close()
        ahead.close()
        av_packet_free(packet)
        codec?.let(::avcodec_free_context)
        avformat_close_input(format)
    }

    /** Jumps to a frame at [seconds] or earlier from which decoding can start. */
    private fun jump(seconds: Double) {
        var back = 0.0
        do {
            val target = maxOf(0.0, seconds - back)
            // Some files begin before their zero.
            val mark = if (target == 0.0) Long.MIN_VALUE / 2 else floor((target + origin) / tick).toLong()
            if (av_seek_frame(format, stream, mark, AVSEEK_FLAG_BACKWARD) < 0 &&
                av_seek_frame(format, stream, 0, AVSEEK_FLAG_BACKWARD) < 0
            ) {
                return
            }
            avcodec_flush_buffers(codec)
            isAtEnd = false
            shown.clear()
            decode(ahead)
            next()
            // If frames are stored in another order, a seek may end after the requested frame.
            back = if (back == 0.0) 1.0 else back * 2
        } while ((!shown.isThere || shown.time > seconds + TOLERANCE) && target > 0)
    }

    /** Decodes the next frame into [into]. Returns false at the end of the file, and [into] is then empty. */
    private fun decode(into: TimedFrame): Boolean {
        into.clear()
        val latest = shown.time
        while (true) {
            val result = avcodec_receive_frame(codec, into.frame)
            if (result == 0) {
                val mark = into.frame.best_effort_timestamp()
                into.time = if (mark == AV_NOPTS_VALUE) latest + into.frame.duration() * tick else mark * tick - origin
                into.isThere = true
                return true
            }
            if (result != AVERROR_EAGAIN() || isAtEnd) return false
            feed()
        }
    }

    /** Passes the next packet of the file to the decoder; packets that it cannot use are skipped. */
    private fun feed() {
        while (true) {
            if (av_read_frame(format, packet) < 0) {
                isAtEnd = true
                avcodec_send_packet(codec, null)
                return
            }
            val isVideo = packet.stream_index() == stream
            if (isVideo) avcodec_send_packet(codec, packet)
            av_packet_unref(packet)
            if (isVideo) return
        }
    }

    private class TimedFrame(val frame: AVFrame) {
        var time = Double.NEGATIVE_INFINITY
        var isThere = false

        fun clear() {
            av_frame_unref(frame)
            time = Double.NEGATIVE_INFINITY
            isThere = false
        }

        fun close() = av_frame_free(frame)
    }
}

/** The reason why a video cannot be shown; its [message] is one sentence for a person. */
internal class VideoException(message: String, cause: Throwable? = null) : Exception(message, cause)

private const val MICROS = 1e6
private const val THREADS = 2

/** The tolerance of times in seconds. Alignments are rounded to it; no camera has shorter frames. */
private const val TOLERANCE = 1e-4

/** The longest distance in seconds that is decoded instead of jumped over. */
private const val NEAR = 0.5
