package badlog.window.graph

import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.snapshots.Snapshot
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.asSkiaBitmap
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.captureToImage
import androidx.compose.ui.test.onRoot
import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.files.UserFolders
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.log.OpenRecording
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import badlog.window.waiting.waitFor
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.swing.Swing
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import java.nio.file.Files
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds

/** Returns a viewer that shows [recording] with its default graphs. */
internal fun viewerOf(recording: OpenRecording?): Viewer {
    val nowhere = Path.of("build", "nowhere")
    return Viewer(MainScope(), UserFolders(nowhere, nowhere)).apply {
        if (recording == null) return@apply
        current.replace(recording)
        board.replace(recording.standardGraphs)
        view.send(PlaceAction.Open(recording.span))
    }
}

/** Returns the recording of a bag's [text]. */
internal fun recordingOf(text: String): OpenRecording = recordingOf(Path.of("test.bag"), text.encodeToByteArray())

/** Returns the recording of a file of the samples. */
internal fun sample(name: String): OpenRecording = Path.of("..", "samples", name).let { recordingOf(it, Files.readAllBytes(it)) }

private fun recordingOf(file: Path, bytes: ByteArray): OpenRecording {
    val parser = BagParser()
    parser.accept(bytes)
    return OpenRecording(file.toAbsolutePath(), LogView.of(parser.finish()))
}

/** Returns a bag of one topic over seconds: [value] at each of [count] samples, a tenth of a second apart. */
internal fun bagOf(count: Int, unit: String = "V", value: (Int) -> Double): String = buildString {
    append("""{"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"A/Voltage","unit":"$unit","attrs":[]}],"values":[]}""")
    append("\nTime,A/Voltage\n")
    repeat(count) { append("${it / 10.0},${value(it)}\n") }
}

/** The graphs of [viewer], in light colors. */
@Composable
internal fun TestGraphs(viewer: Viewer, theme: Theme = Theme.LIGHT) {
    ViewerTheme(theme) { viewer.keyboard.Watch { GraphPane(viewer.graphs, Modifier.fillMaxSize()) } }
}

/** Waits until all visible graphs of [viewer] are drawn. */
@OptIn(ExperimentalTestApi::class)
internal fun DesktopComposeUiTest.waitForPictures(viewer: Viewer) {
    waitFor { viewer.graphs.plots.areReady(viewer.compared.drawn, viewer.view.viewport.visible) }
    waitForIdle()
}

/** Saves the current picture under the build folder, for people to look at. */
@OptIn(ExperimentalTestApi::class)
internal fun DesktopComposeUiTest.savePicture(name: String): ImageBitmap {
    val picture = onRoot().captureToImage()
    val folder = Files.createDirectories(Path.of("build", "pictures"))
    val data = Image.makeFromBitmap(picture.asSkiaBitmap()).encodeToData(EncodedImageFormat.PNG)
    Files.write(folder.resolve("$name.png"), checkNotNull(data).bytes)
    return picture
}

/** Calls [choice] on the window's thread, and returns when the chosen state is shown. */
internal fun choosing(viewer: Viewer, choice: () -> Unit) = runBlocking(Dispatchers.Swing) {
    val following = launch { viewer.shown.run() }
    choice()
    eventually(60.seconds) {
        // Without a window, this has to be done here.
        Snapshot.sendApplyNotifications()
        (viewer.shown.isWaiting || viewer.tasks.all.isNotEmpty()) shouldBe false
    }
    following.cancelAndJoin()
}

/** Returns this recording with the formulas [definitions]. */
internal fun OpenRecording.withFormulas(definitions: List<String>): OpenRecording = with(choices.copy(definitions = definitions))
