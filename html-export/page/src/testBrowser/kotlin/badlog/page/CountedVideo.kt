package badlog.page

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.util.Base64
import kotlin.math.roundToInt

/**
 * A WebM video with the number of each frame in its picture, in binary. A white square is a one, and the leftmost is worth 1. Chromium
 * encodes the pictures, because a lossy WebP picture is a key frame of VP8.
 */
internal object CountedVideo {
    const val FRAMES_PER_SECOND = 30
    const val FRAMES = 300
    private const val DIGITS = 10
    private const val SQUARE = 24
    private const val WIDTH = DIGITS * SQUARE
    private const val HEIGHT = 136
    private const val FIRST_CHUNK = 12

    val bytes: ByteArray by lazy { webm(pictures().map(::keyFrame)) }

    /** JavaScript that puts the video into the page's file input, as if a reader had selected it. */
    val pick: String by lazy {
        val base64 = Base64.getEncoder().encodeToString(bytes)
        """
        (() => {
            const data = new DataTransfer(), input = document.querySelector('#video-file')
            data.items.add(new File([Uint8Array.from(atob('$base64'), c => c.charCodeAt(0))], 'match.webm', {type: 'video/webm'}))
            input.files = data.files
            input.dispatchEvent(new Event('change'))
        })()
        """.trimIndent()
    }

    /** A JavaScript expression for the number of the frame that the page's video shows. */
    const val SHOWN = """(() => {
        const canvas = document.createElement('canvas')
        canvas.width = $WIDTH
        canvas.height = $SQUARE
        const context = canvas.getContext('2d', {willReadFrequently: true})
        context.drawImage(document.querySelector('#video video'), 0, 0)
        let number = 0
        for (let i = 0; i < $DIGITS; i++)
            if (context.getImageData(i * $SQUARE + $SQUARE / 2, $SQUARE / 2, 1, 1).data[1] > 128) number += 1 << i
        return number
    })()"""

    @Suppress("UNCHECKED_CAST")
    private fun pictures(): List<String> = Chromium.driver.executeScript(
        """
        const canvas = document.createElement('canvas')
        canvas.width = $WIDTH
        canvas.height = $HEIGHT
        const context = canvas.getContext('2d', {alpha: false})
        return Array.from({length: $FRAMES}, (_, frame) => {
            context.fillStyle = '#000'
            context.fillRect(0, 0, $WIDTH, $SQUARE)
            context.fillStyle = '#263'
            context.fillRect(0, $SQUARE, $WIDTH, $HEIGHT)
            context.fillStyle = '#fff'
            for (let i = 0; i < $DIGITS; i++) if (frame >> i & 1) context.fillRect(i * $SQUARE, 0, $SQUARE, $SQUARE)
            context.fillRect(frame / $FRAMES * ($WIDTH - $SQUARE), $HEIGHT - 2 * $SQUARE, $SQUARE, $SQUARE)
            context.font = '40px sans-serif'
            context.fillText(frame, 80, 80)
            return canvas.toDataURL('image/webp', 0.6).split(',')[1]
        })
        """.trimIndent(),
    ) as List<String>

    /** Returns the key frame of a WebP picture, which is in one of its chunks. */
    private fun keyFrame(base64: String): ByteArray {
        val webp = Base64.getDecoder().decode(base64)
        var at = FIRST_CHUNK
        while (at < webp.size) {
            val size = Integer.reverseBytes(ByteBuffer.wrap(webp).getInt(at + 4))
            if (String(webp, at, 4) == "VP8 ") return webp.copyOfRange(at + 8, at + 8 + size)
            at += 8 + size + size % 2
        }
        error("The picture is not a lossy one: " + String(webp, 0, 16, Charsets.ISO_8859_1))
    }

    private fun webm(frames: List<ByteArray>): ByteArray {
        val head = element(
            0x1A45DFA3,
            number(0x4286, 1),
            number(0x42F7, 1),
            number(0x42F2, 4),
            number(0x42F3, 8),
            text(0x4282, "webm"),
            number(0x4287, 2),
            number(0x4285, 2),
        )
        val length = element(0x4489, ByteBuffer.allocate(8).putDouble(milliseconds(frames.size).toDouble()).array())
        val info = element(0x1549A966, number(0x2AD7B1, 1_000_000), length, text(0x4D80, "test"), text(0x5741, "test"))
        val size = element(0xE0, number(0xB0, WIDTH), number(0xBA, HEIGHT))
        val tracks = element(0x1654AE6B, element(0xAE, number(0xD7, 1), number(0x73C5, 1), number(0x83, 1), text(0x86, "V_VP8"), size))
        val clusters = frames.indices.chunked(FRAMES_PER_SECOND) { second ->
            val first = milliseconds(second.first())
            val blocks = second.map { element(0xA3, block(milliseconds(it) - first, frames[it])) }
            first to element(0x1F43B675, number(0xE7, first), *blocks.toTypedArray())
        }

        // Every number has four bytes, so that the positions of the clusters do not affect the length of the cues.
        fun cues(start: Int): ByteArray {
            var at = start
            val points = clusters.map { (time, cluster) ->
                element(0xBB, number(0xB3, time), element(0xB7, number(0xF7, 1), number(0xF1, at))).also { at += cluster.size }
            }
            return element(0x1C53BB6B, *points.toTypedArray())
        }
        val before = info.size + tracks.size
        return head + element(0x18538067, info, tracks, cues(before + cues(0).size), *clusters.map { it.second }.toTypedArray())
    }

    private fun milliseconds(frame: Int) = (frame * 1000.0 / FRAMES_PER_SECOND).roundToInt()

    private fun block(time: Int, frame: ByteArray) = byteArrayOf(0x81.toByte(), (time shr 8).toByte(), time.toByte(), 0x80.toByte()) + frame

    private fun number(id: Int, value: Int) = element(id, ByteBuffer.allocate(4).putInt(value).array())

    private fun text(id: Int, text: String) = element(id, text.toByteArray())

    private fun element(id: Int, vararg parts: ByteArray): ByteArray {
        val bytes = ByteArrayOutputStream()
        bytes.write(ByteBuffer.allocate(4).putInt(id).array().dropWhile { it == 0.toByte() }.toByteArray())
        bytes.write(ByteBuffer.allocate(8).putLong(parts.sumOf { it.size } or (1L shl 56)).array())
        for (part in parts) bytes.write(part)
        return bytes.toByteArray()
    }

    private infix fun Int.or(other: Long): Long = toLong() or other
}
