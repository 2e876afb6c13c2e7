package badlog.release.windows

import java.io.ByteArrayOutputStream

/** A video of five seconds in a color that the window itself does not have. It is YUV4MPEG2, which needs no encoder. */
internal object VideoOfOneColor {
    private const val WIDTH = 160
    private const val HEIGHT = 120
    private const val FRAMES = 150

    /** Magenta, as brightness and two color differences; these have a quarter of the pixels. */
    private const val Y = 105
    private const val U = 180
    private const val V = 235

    fun bytes(): ByteArray = ByteArrayOutputStream().apply {
        writeBytes("YUV4MPEG2 W$WIDTH H$HEIGHT F30:1 Ip A1:1 C420jpeg\n".encodeToByteArray())
        val pixels = WIDTH * HEIGHT
        val bright = ByteArray(pixels) { Y.toByte() }
        val (blue, red) = listOf(U, V).map { color -> ByteArray(pixels / 4) { color.toByte() } }
        val frame = "FRAME\n".encodeToByteArray() + bright + blue + red
        repeat(FRAMES) { writeBytes(frame) }
    }.toByteArray()

    /** Returns whether [color] is the video's color. */
    fun isVideoColor(color: Int): Boolean = (color shr 16 and 0xFF) > 0xE0 && (color shr 8 and 0xFF) < 0x20 && (color and 0xFF) > 0xB0
}
