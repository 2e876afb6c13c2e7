package badlog.window.benchmark

import androidx.compose.runtime.Composable
import androidx.compose.runtime.snapshots.Snapshot
import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.unit.Density
import badlog.files.UserFolders
import badlog.window.app.Viewer
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.SupervisorJob
import org.jetbrains.skia.EncodedImageFormat
import java.nio.file.Files
import java.nio.file.Path

/** An off-screen window of 1600×900 pixels, drawn by software as on a pit laptop without a driver. */
internal class OffScreenWindow(content: @Composable (Viewer) -> Unit) : AutoCloseable {
    private val thread = WindowThread()
    private val home = Files.createTempDirectory("badlog-benchmark")

    /** The folders of the user's own files. */
    val folders = UserFolders(home, home)
    val viewer = Viewer(CoroutineScope(SupervisorJob() + thread), folders)
    private val scene = ImageComposeScene(WIDTH, HEIGHT, Density(1f), thread) { content(viewer) }

    /**
     * Draws frames until [isDone] and nothing is left to draw; returns the milliseconds since [change]. The first frame is drawn at once,
     * the last as soon as possible, and the others at most as often as a display of 120 Hz shows them.
     */
    fun measure(change: () -> Unit = {}, isDone: () -> Boolean): Double {
        val start = System.nanoTime()
        thread.longest = 0.0
        thread.time {
            change()
            Snapshot.sendApplyNotifications()
        }
        var drawn = Long.MIN_VALUE / 2
        while (true) {
            thread.runPending()
            val isDue = System.nanoTime() - drawn >= DISPLAY_NANOS || isDone()
            if (scene.hasInvalidations() && isDue) {
                drawn = System.nanoTime()
                thread.time { scene.render(drawn).close() }
            } else if (!scene.hasInvalidations() && isDone()) {
                break
            } else {
                thread.await()
            }
        }
        return (System.nanoTime() - start) / 1e6
    }

    /** The longest time in milliseconds that a frame or other work blocked the window's thread in the last measurement. */
    val longestBlock: Double get() = thread.longest

    /** Saves the current picture as [file], for people to look at. */
    fun save(file: Path) {
        Files.createDirectories(file.parent)
        scene.render(System.nanoTime()).use { Files.write(file, it.encodeToData(EncodedImageFormat.PNG)!!.bytes) }
    }

    override fun close() {
        scene.close()
        home.toFile().deleteRecursively()
    }
}

private const val WIDTH = 1600
private const val HEIGHT = 900
private const val DISPLAY_NANOS = 1_000_000_000L / 120
