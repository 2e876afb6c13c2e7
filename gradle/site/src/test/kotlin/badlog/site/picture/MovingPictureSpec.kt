package badlog.site.picture

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import java.io.DataInputStream
import java.util.zip.CRC32
import java.util.zip.InflaterInputStream
import javax.imageio.ImageIO

class MovingPictureSpec : FunSpec({
    class Chunk(val type: String, val data: ByteArray) {
        fun numbers(): DataInputStream = DataInputStream(ByteArrayInputStream(data))
    }

    fun chunks(file: ByteArray): List<Chunk> {
        val input = DataInputStream(ByteArrayInputStream(file, 8, file.size - 8))
        return generateSequence {
            if (input.available() == 0) return@generateSequence null
            val size = input.readInt()
            val named = input.readNBytes(size + 4)
            input.readInt() shouldBe CRC32().apply { update(named) }.value.toInt()
            Chunk(named.decodeToString(0, 4), named.copyOfRange(4, named.size))
        }.toList()
    }

    fun picture(vararg colors: Int) = BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB).apply { setRGB(0, 0, 3, 2, colors, 0, 3) }

    val blue = 0x0000FF
    val red = 0xFF0000
    val first = picture(blue, blue, blue, blue, blue, blue)

    test("a program that does not support animation shows the first picture") {
        val file = MovingPicture(3, 2).apply { add(first, 100) }.bytes()
        val read = ImageIO.read(ByteArrayInputStream(file))
        (read.getRGB(2, 1) and 0xFFFFFF) shouldBe blue
        listOf(read.width, read.height) shouldContainExactly listOf(3, 2)
    }

    test("only the differing rectangle of the next picture is stored, with its position and its time") {
        val next = picture(blue, blue, blue, blue, red, blue)
        val chunks = chunks(
            MovingPicture(3, 2).apply {
                add(first, 100)
                add(next, 250)
            }.bytes(),
        )
        chunks.map { it.type } shouldContainExactly listOf("IHDR", "acTL", "PLTE", "fcTL", "IDAT", "fcTL", "fdAT", "IEND")
        val control = chunks[5].numbers()
        List(5) { control.readInt() } shouldContainExactly listOf(1, 1, 1, 1, 1)
        listOf(control.readShort().toInt(), control.readShort().toInt()) shouldContainExactly listOf(250, 1000)
        val part = InflaterInputStream(ByteArrayInputStream(chunks[6].data, 4, chunks[6].data.size - 4)).readAllBytes()
        val color = chunks[2].numbers().apply { skipBytes(part[1] * 3) }.readNBytes(3)
        color.toList() shouldContainExactly listOf(-1, 0, 0)
    }

    test("beyond 256 colors, rare colors become the nearest frequent ones") {
        val pixels = IntArray(600) { if (it < 300) it else 0x00FF00 }
        val palette = Palette.of(listOf(pixels))
        palette.colors.size shouldBe 256
        palette.colors[palette.indexOf(0x00FE00)] shouldBe 0x00FF00
    }

    test("a picture of another size is refused") {
        shouldThrow<IllegalArgumentException> { MovingPicture(4, 4).add(first, 100) }.message shouldBe "The picture is 3 × 2, expected 4 × 4."
    }
})
