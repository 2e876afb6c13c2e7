package badlog.release.windows

import badlog.core.platform.Wine
import badlog.release.ROOT
import badlog.release.found
import badlog.release.tempFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.shouldBe
import java.io.File

/** Tests the window with Java and libraries for Windows in Wine: an emulation, not a real Windows. */
class WindowProof : FunSpec({
    val java = File(System.getProperty("badlog.windows.java"))
    val jars = System.getProperty("badlog.windows.window").split(File.pathSeparator).map(::File)
    val missing = when {
        !found("wine").canExecute() -> "Wine is not installed"
        System.getenv("DISPLAY").isNullOrEmpty() -> "there is no screen"
        !java.exists() -> "its Java could not be installed"
        NATIVE.any { name -> jars.none { it.name.startsWith(name) && "windows" in it.name } } -> "its libraries could not be had"
        else -> null
    }
    val folder = tempFolder()

    test("under Wine, the window draws a folder and a log of it, a drag zooms, and its video shows a frame")
        .config(enabledOrReasonIf = { if (missing == null) Enabled.enabled else Enabled.disabled(missing) }) {
            val logs = File(folder, "Größe").apply { mkdirs() }
            for (name in listOf("qualification-42.bag", "practice.bag")) File(ROOT, "samples/$name").copyTo(File(logs, name))
            val video = File(logs, "match.y4m").apply { writeBytes(VideoOfOneColor.bytes()) }
            val output = File(folder, "output.txt")
            Wine().use { wine ->
                // Compose asks for fonts that only Windows has.
                for ((font, other) in FONTS) wine.run(listOf("wine", "reg", "add", REPLACEMENTS, "/v", font, "/d", other, "/f"))
                settings().writeText("""{"videos":{"${onWindows(File(logs, "qualification-42.bag"))}":"10 ${onWindows(video)}"}}""".replace("\\", "\\\\"))
                val window = wine.process(
                    listOf("wine", java.path) + OPTIONS + listOf("-cp", jars.joinToString(";", transform = ::onWindows), "badlog.window.MainKt", onWindows(logs)),
                    mapOf("SKIKO_RENDER_API" to "SOFTWARE"),
                ).redirectErrorStream(true).redirectOutput(output).start()
                val screen = WindowOnScreen(window, output)

                screen.await("graphs", "graphs of the newest log") { it.count(::isLine) > LINE_PIXELS }
                val whole = screen.picture()
                screen.dragAcrossGraph()
                screen.await("zoomed", "graphs of a part of it") { it.count(::isLine) > LINE_PIXELS && it.differences(whole) > ZOOMED_PIXELS }
                screen.clickVideo()
                screen.await("video", "a frame of the video") { it.count(VideoOfOneColor::isVideoColor) > FRAME_PIXELS }
            }
            output.readText().contains("Exception") shouldBe false
        }
})

/** Returns the file of the window's settings, which has videos by the paths of their logs. */
private fun settings() = File("wine/drive_c/users/${System.getProperty("user.name")}/AppData/Roaming/badlog").apply { mkdirs() }.resolve("settings.json")

private fun onWindows(file: File) = "Z:" + file.absolutePath.replace('/', '\\')

/** Returns whether [color] is the blue of a graph's first line. */
private fun isLine(color: Int) = (color and 0xFF) in 0xB0..0xE0 && (color shr 8 and 0xFF) in 0x50..0x80 && (color shr 16 and 0xFF) < 0x50

private val NATIVE = listOf("skiko-awt-runtime", "ffmpeg", "javacpp")
private const val REPLACEMENTS = "HKCU\\Software\\Wine\\Fonts\\Replacements"
private val FONTS = mapOf("Segoe UI" to "DejaVu Sans", "Consolas" to "DejaVu Sans Mono")
private val OPTIONS = listOf("-Xmx1g", "-XX:+UseSerialGC", "-Dsun.java2d.d3d=false", "-Dsun.java2d.noddraw=true")
private const val LINE_PIXELS = 2_000
private const val ZOOMED_PIXELS = 5_000
private const val FRAME_PIXELS = 20_000
