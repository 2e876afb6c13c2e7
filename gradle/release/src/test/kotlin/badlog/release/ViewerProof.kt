package badlog.release

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.awt.Rectangle
import java.awt.Robot
import java.io.File
import java.util.concurrent.TimeUnit
import javax.imageio.ImageIO

private val ARCHIVE = "badlog-viewer-$VERSION-$PLATFORM.tar.gz"
private val PACKAGE = "badlog-viewer-$VERSION-$PLATFORM.deb"

class ViewerProof : FunSpec({
    val folder = tempFolder()

    test("the unpacked viewer opens a log on a machine without other programs").config(enabledOrReasonIf = ifShown(ARCHIVE)) {
        val home = unpacked(download(ARCHIVE), File(folder, "archive"))
        shouldShow(File(home, "bin/badlog"), File(folder, "machine"), "viewer-archive.png")
    }

    test("the package has the same program and a menu entry, and opens bags").config(enabledOrReasonIf = ifShown(PACKAGE)) {
        val root = unpacked(download(PACKAGE), File(folder, "package"))
        val launcher = root.walk().first { it.path.endsWith("bin/badlog") }
        val entry = launcher.parentFile.parentFile.walk().first { it.isFile && it.extension == "desktop" }.readText()
        (entry.lines().any { it.startsWith("MimeType=") && "application/x-bag" in it }) shouldBe true
        shouldShow(launcher, File(folder, "package-machine"), "viewer-package.png")
    }
})

/** Starts [launcher] on a sample, waits for graphs on the screen, and saves a picture named [picture]. */
private fun shouldShow(launcher: File, place: File, picture: String) {
    val machine = CleanMachine(place, listOf("sh"))
    val sample = File(place, "qualification-42.bag").also { File(ROOT, "samples/qualification-42.bag").copyTo(it) }
    val output = File(place, "output.txt")
    val process = machine.process(
        listOf("$launcher", "$sample"),
        variables = mapOf("DISPLAY" to System.getenv("DISPLAY"), "SKIKO_RENDER_API" to "SOFTWARE"),
    ).redirectErrorStream(true).redirectOutput(output).start()
    try {
        val robot = Robot()
        val screen = Rectangle(0, 0, SCREEN_WIDTH, SCREEN_HEIGHT)
        val end = System.nanoTime() + TimeUnit.MINUTES.toNanos(5)
        var colors = 0
        while (colors < COLORS_OF_GRAPHS && process.isAlive && System.nanoTime() < end) {
            Thread.sleep(1_000)
            val image = robot.createScreenCapture(screen)
            colors = image.getRGB(0, 0, image.width, image.height, null, 0, image.width).toSet().size
            ImageIO.write(image, "png", File(picture))
        }
        withClue("build/tmp/prove/$picture: $colors colors; ${output.readText()}") {
            colors shouldBeGreaterThan COLORS_OF_GRAPHS - 1
            process.isAlive shouldBe true
            output.readText().contains("Exception") shouldBe false
        }
    } finally {
        process.descendants().forEach { it.destroy() }
        process.destroy()
        if (!process.waitFor(1, TimeUnit.MINUTES)) process.destroyForcibly()
    }
}

private fun ifShown(name: String): EnabledOrReasonIf = { test ->
    val isMade = ifMade(name)(test)
    when {
        !isMade.isEnabled -> isMade
        System.getenv("DISPLAY").isNullOrEmpty() -> Enabled.disabled("there is no screen")
        else -> CleanMachine.IF_POSSIBLE(test)
    }
}

private const val SCREEN_WIDTH = 1600
private const val SCREEN_HEIGHT = 1000

/** More colors than in a window with only its frame, texts and buttons. */
private const val COLORS_OF_GRAPHS = 1_000
