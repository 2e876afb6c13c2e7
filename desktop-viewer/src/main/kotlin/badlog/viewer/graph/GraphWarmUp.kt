package badlog.viewer.graph

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.unit.Density
import badlog.analysis.LogView
import badlog.bag.BagParser
import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording
import badlog.viewer.settings.Theme
import badlog.viewer.settings.UserFolders
import badlog.viewer.theme.ViewerTheme
import badlog.viewer.view.Viewport
import java.nio.file.Path
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay

/**
 * Draws a few small graphs that nobody sees. The first graphs of a program take half a second longer than the next, because their
 * code has to be loaded: this is better done while a person looks for a log. To be called on the window's thread, which goes
 * on with other things in between.
 */
internal suspend fun warmUpGraphs(folders: UserFolders): Unit = coroutineScope {
    val parser = BagParser()
    parser.accept(SMALL_BAG.encodeToByteArray())
    val recording = OpenRecording(Path.of("warm-up.bag"), LogView.of(parser.finish()))
    val viewer = Viewer(this, folders)
    viewer.open = recording
    viewer.graphs = standardGraphs(recording.view)
    viewer.viewport = Viewport(recording.span)
    val scene = ImageComposeScene(WIDTH, HEIGHT, Density(1f), coroutineContext) {
        ViewerTheme(Theme.LIGHT) { GraphPane(viewer) }
    }
    try {
        repeat(FRAMES) { frame ->
            viewer.cursor = frame / 10.0
            viewer.viewport = viewer.viewport.scaled(0.99, 1.0)
            scene.render(System.nanoTime()).close()
            delay(FRAME_MILLIS)
        }
    } finally {
        scene.close()
    }
}

private const val WIDTH = 640
private const val HEIGHT = 480
private const val FRAMES = 10
private const val FRAME_MILLIS = 10L

/** A little of everything: numbers, states, events, and a robot that is enabled. */
private val SMALL_BAG = buildString {
    append("""{"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"A/Number","unit":"V","attrs":["differentiate"]},""")
    append("""{"name":"A/State","unit":"ul","attrs":[]},{"name":"Enabled","unit":"ul","attrs":[]},{"name":"Events","unit":"ul","attrs":[]}],""")
    append(""""values":[]}""")
    append("\nTime,A/Number,A/State,Enabled,Events\n")
    repeat(3000) { append("${it / 100.0},${it % 7},${if (it % 500 < 200) "LOW" else "HIGH"},${it > 100},${if (it % 900 == 7) "said" else ""}\n") }
}
