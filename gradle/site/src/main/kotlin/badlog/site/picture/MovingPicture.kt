package badlog.site.picture

import java.awt.Rectangle
import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.util.zip.CRC32
import java.util.zip.Deflater
import java.util.zip.DeflaterOutputStream

/**
 * A sequence of pictures as an animated PNG of 256 colors. Each picture is stored as the rectangle that differs from the previous one.
 * Programs that do not support animation show the first picture.
 */
internal class MovingPicture(private val width: Int, private val height: Int) {
    private class Frame(val pixels: IntArray, val millis: Int)

    private val frames = ArrayList<Frame>()

    /**
     * Adds [image], shown for [millis] ms.
     *
     * @throws IllegalArgumentException if its size differs.
     */
    fun add(image: BufferedImage, millis: Int) {
        require(image.width == width && image.height == height) {
            "The picture is ${image.width} × ${image.height}, expected $width × $height."
        }
        frames += Frame(IntArray(width * height).also { image.getRGB(0, 0, width, height, it, 0, width) }, millis)
    }

    /** Returns the file, which repeats forever. */
    fun bytes(): ByteArray {
        check(frames.isNotEmpty()) { "A moving picture needs a picture; add one first." }
        val palette = Palette.of(frames.map { it.pixels })
        val file = ByteArrayOutputStream()
        file.write(SIGNATURE)
        chunk(file, "IHDR") {
            writeInt(width)
            writeInt(height)
            // 8 bits of a palette; the usual compression and filters; not interlaced.
            write(byteArrayOf(8, 3, 0, 0, 0))
        }
        chunk(file, "acTL") {
            writeInt(frames.size)
            writeInt(0)
        }
        chunk(file, "PLTE") {
            for (color in palette.colors) write(byteArrayOf((color shr 16).toByte(), (color shr 8).toByte(), color.toByte()))
        }
        var number = 0
        for ((i, frame) in frames.withIndex()) {
            val part = if (i == 0) Rectangle(width, height) else difference(frames[i - 1].pixels, frame.pixels)
            chunk(file, "fcTL") {
                writeInt(number++)
                for (value in listOf(part.width, part.height, part.x, part.y)) writeInt(value)
                writeShort(frame.millis)
                writeShort(MILLIS_OF_SECOND)
                // Drawn over the previous picture, and kept.
                writeShort(0)
            }
            val packed = packed(frame.pixels, part, palette)
            if (i == 0) {
                chunk(file, "IDAT") { write(packed) }
            } else {
                chunk(file, "fdAT") {
                    writeInt(number++)
                    write(packed)
                }
            }
        }
        chunk(file, "IEND") {}
        return file.toByteArray()
    }

    /** Returns the smallest rectangle that contains all differences between both pictures; one pixel if they are the same. */
    private fun difference(before: IntArray, after: IntArray): Rectangle {
        val changed = after.indices.filter { before[it] != after[it] }
        if (changed.isEmpty()) return Rectangle(1, 1)
        val left = changed.minOf { it % width }
        val top = changed.first() / width
        return Rectangle(left, top, changed.maxOf { it % width } - left + 1, changed.last() / width - top + 1)
    }

    private fun packed(pixels: IntArray, part: Rectangle, palette: Palette): ByteArray {
        val packed = ByteArrayOutputStream()
        DeflaterOutputStream(packed, Deflater(Deflater.BEST_COMPRESSION)).use { out ->
            for (y in part.y until part.y + part.height) {
                out.write(0)
                for (x in part.x until part.x + part.width) out.write(palette.indexOf(pixels[y * width + x]))
            }
        }
        return packed.toByteArray()
    }

    private fun chunk(file: ByteArrayOutputStream, type: String, write: DataOutputStream.() -> Unit) {
        val data = ByteArrayOutputStream()
        DataOutputStream(data).apply { writeBytes(type) }.write()
        val sum = CRC32().apply { update(data.toByteArray()) }
        with(DataOutputStream(file)) {
            writeInt(data.size() - type.length)
            write(data.toByteArray())
            writeInt(sum.value.toInt())
        }
    }

    private companion object {
        val SIGNATURE = byteArrayOf(-119, 80, 78, 71, 13, 10, 26, 10)
        const val MILLIS_OF_SECOND = 1000
    }
}
