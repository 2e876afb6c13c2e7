package badlog.site.picture

import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.div
import kotlin.io.path.fileSize
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.writeBytes

/**
 * Makes the moving pictures of the README. Arguments: the docs' folder, the page of Qualification 42, and the folder of the window's
 * pictures.
 *
 * The page's pictures are taken from the real page in Chromium, at addresses that a person would visit to find the brownout. The window's
 * are the screenshots of its test `TourSpec`; their names contain their order and their duration in ms: `07-1500.png`.
 */
internal fun main(args: Array<String>) {
    val docs = Path.of(args[0])
    val tour = MovingPicture(WIDTH, HEIGHT)
    PageCamera(Path.of(args[1]), WIDTH, HEIGHT).use { camera -> for ((part, millis) in PAGE) tour.add(camera.take(part), millis) }
    write(docs / "page-moving.png", tour)
    val seen = Path.of(args[2]).listDirectoryEntries("*.png").sorted().map { it to ImageIO.read(it.toFile()) }
    val windows = MovingPicture(seen[0].second.width, seen[0].second.height)
    for ((file, image) in seen) windows.add(image, file.nameWithoutExtension.substringAfter('-').toInt())
    write(docs / "viewer-moving.png", windows)
}

private fun write(file: Path, picture: MovingPicture) {
    file.writeBytes(picture.bytes())
    check(file.fileSize() < MAX_BYTES) {
        "${file.fileName} has ${file.fileSize()} bytes, more than $MAX_BYTES; show fewer or smaller pictures."
    }
    println("$file: ${file.fileSize()} bytes")
}

private const val WIDTH = 1100
private const val HEIGHT = 680
private const val MAX_BYTES = 1_000_000L

/** The addresses that a person would visit to find the brownout, each with its duration in ms. */
private val PAGE = listOf(
    "" to 3000,
    "#x=0:156&t=92.4" to 1500,
    "#x=60:130&t=92.4" to 600,
    "#x=80:110&t=92.4" to 600,
    "#x=86:100&t=92.4" to 1200,
    "#x=86:100&t=93" to 900,
    "#x=86:100&t=93.7" to 3000,
)
