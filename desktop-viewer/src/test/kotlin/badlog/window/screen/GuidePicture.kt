package badlog.window.screen

import java.awt.image.BufferedImage
import java.awt.image.IndexColorModel
import java.nio.file.Path
import javax.imageio.ImageIO

/** Writes [picture] into docs as the picture [name] of the guides. Only its 256 most frequent colors are kept, which halves the file. */
internal fun writeGuidePicture(picture: BufferedImage, name: String) {
    val pixels = picture.getRGB(0, 0, picture.width, picture.height, null, 0, picture.width)
    val colors = pixels.toList().groupingBy { it and RGB }.eachCount().entries.sortedByDescending { it.value }.take(COLORS).map { it.key }
    val model = IndexColorModel(8, colors.size, colors.toIntArray(), 0, false, -1, 0)
    val places = HashMap<Int, Int>()
    val indexed = BufferedImage(picture.width, picture.height, BufferedImage.TYPE_BYTE_INDEXED, model)
    val row = IntArray(picture.width)
    for (y in 0 until picture.height) {
        for (x in row.indices) row[x] = places.getOrPut(pixels[y * picture.width + x] and RGB) { nearest(colors, pixels[y * picture.width + x]) }
        indexed.raster.setPixels(0, y, picture.width, 1, row)
    }
    ImageIO.write(indexed, "png", Path.of("../docs/$name.png").toFile())
}

private fun nearest(colors: List<Int>, color: Int): Int = colors.indices.minBy { i ->
    listOf(0, 8, 16).sumOf { shift -> ((colors[i] shr shift and 0xFF) - (color shr shift and 0xFF)).let { it * it } }
}

private const val RGB = 0xFFFFFF
private const val COLORS = 256
