package badlog.site.picture

import java.awt.Color
import java.awt.RenderingHints
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.div
import kotlin.io.path.fileSize
import kotlin.io.path.writeBytes

/**
 * Makes the moving pictures of the README: the docs' folder, then the page of Qualification 42.
 *
 * That of the page is taken from the real page in Chromium, at the addresses of a person who looks for the brownout. That of the window shows the
 * pictures that the window's tests have taken of the real window.
 */
internal fun main(args: Array<String>) {
    val docs = Path.of(args[0])
    val tour = MovingPicture(WIDTH, HEIGHT)
    PageCamera(Path.of(args[1]), WIDTH, HEIGHT).use { camera -> for ((part, millis) in PAGE) tour.add(camera.take(part), millis) }
    write(docs / "page-moving.png", tour)
    val windows = MovingPicture(WIDTH, HEIGHT)
    for (name in WINDOW) windows.add(fitted(ImageIO.read((docs / "$name.png").toFile())), WINDOW_MILLIS)
    write(docs / "viewer-moving.png", windows)
}

private fun write(file: Path, picture: MovingPicture) {
    file.writeBytes(picture.bytes())
    check(file.fileSize() < MAX_BYTES) {
        "${file.fileName} has ${file.fileSize()} bytes, more than $MAX_BYTES; show fewer or smaller pictures."
    }
    println("$file: ${file.fileSize()} bytes")
}

/** [image] as large as fits, in the middle of a picture of the usual size. */
private fun fitted(image: BufferedImage): BufferedImage {
    val scale = minOf(WIDTH.toDouble() / image.width, HEIGHT.toDouble() / image.height)
    val width = (image.width * scale).toInt()
    val height = (image.height * scale).toInt()
    return BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB).apply {
        createGraphics().apply {
            setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC)
            color = Color(image.getRGB(0, 0))
            fillRect(0, 0, WIDTH, HEIGHT)
            drawImage(image, (WIDTH - width) / 2, (HEIGHT - height) / 2, width, height, null)
        }.dispose()
    }
}

private const val WIDTH = 1100
private const val HEIGHT = 680
private const val MAX_BYTES = 1_000_000L
private const val WINDOW_MILLIS = 2500

/** Where a person who looks for the brownout goes, and for how many milliseconds. */
private val PAGE = listOf(
    "" to 3000,
    "#x=0:156&t=92.4" to 1500,
    "#x=60:130&t=92.4" to 600,
    "#x=80:110&t=92.4" to 600,
    "#x=86:100&t=92.4" to 1200,
    "#x=86:100&t=93" to 900,
    "#x=86:100&t=93.7" to 3000,
)

/** Pictures of the window's guide. */
private val WINDOW = listOf("viewer-logs", "viewer-recording", "viewer-findings", "viewer-compare")
