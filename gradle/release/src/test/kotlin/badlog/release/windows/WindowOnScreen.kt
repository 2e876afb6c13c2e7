package badlog.release.windows

import java.awt.Rectangle
import java.awt.Robot
import java.awt.event.InputEvent
import java.awt.image.BufferedImage
import java.io.File
import java.util.concurrent.TimeUnit
import javax.imageio.ImageIO

/**
 * The only window on a black screen, seen and used from outside.
 *
 * @param process the process that draws the window.
 * @param output the output of the process.
 */
internal class WindowOnScreen(private val process: Process, private val output: File) {
    private val robot = Robot().apply { autoDelay = STEP_MILLIS }

    fun picture() = Picture(robot.createScreenCapture(Rectangle(0, 0, WIDTH, HEIGHT)))

    /** Waits until the screen fulfills [matches], and saves a picture of it as [name]. */
    fun await(name: String, what: String, matches: (Picture) -> Boolean) {
        val end = System.nanoTime() + TimeUnit.MINUTES.toNanos(PATIENCE_MINUTES)
        while (true) {
            val picture = picture()
            ImageIO.write(picture.image, "png", File("$name.png"))
            if (matches(picture)) return
            check(process.isAlive) { "The window has ended without $what: ${output.readText()}" }
            check(System.nanoTime() < end) { "Waited in vain for $what; see ${File("$name.png").absolutePath}. ${output.readText()}" }
            Thread.sleep(POLL_MILLIS)
        }
    }

    /** Drags with the mouse across the middle of the graphs. */
    fun dragAcrossGraph() {
        val window = picture().window()
        fun at(share: Double) = robot.mouseMove((window.x + window.width * share).toInt(), window.y + (window.height * MIDDLE).toInt())
        at(FROM)
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK)
        for (step in 1..STEPS) at(FROM + (TO - FROM) * step / STEPS)
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK)
    }

    /** Clicks the button *Video*, at a fixed distance from the window's upper right corner. */
    fun clickVideo() {
        val window = picture().window()
        robot.mouseMove(window.x + window.width - VIDEO_FROM_RIGHT, window.y + VIDEO_FROM_TOP)
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK)
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK)
    }
}

/** A picture of the screen. */
internal class Picture(val image: BufferedImage) {
    private val colors = image.getRGB(0, 0, image.width, image.height, null, 0, image.width)

    /** Returns the number of pixels with a color that fulfills [matches]. */
    fun count(matches: (color: Int) -> Boolean): Int = colors.count(matches)

    /** Returns the number of pixels with a different color in [other]. */
    fun differences(other: Picture): Int = colors.indices.count { colors[it] != other.colors[it] }

    /** Returns the rectangle of the screen that is not black. */
    fun window(): Rectangle {
        val seen = colors.indices.filter { colors[it] and WITHOUT_ALPHA != 0 }
        val (left, right) = seen.minOf { it % image.width } to seen.maxOf { it % image.width }
        val (top, bottom) = seen.first() / image.width to seen.last() / image.width
        return Rectangle(left, top, right - left + 1, bottom - top + 1)
    }
}

private const val WIDTH = 1600
private const val HEIGHT = 1000
private const val PATIENCE_MINUTES = 2L
private const val POLL_MILLIS = 500L
private const val STEP_MILLIS = 60
private const val STEPS = 10
private const val FROM = 0.54
private const val TO = 0.76
private const val MIDDLE = 0.63
private const val VIDEO_FROM_RIGHT = 314
private const val VIDEO_FROM_TOP = 18

private const val WITHOUT_ALPHA = 0xFFFFFF
