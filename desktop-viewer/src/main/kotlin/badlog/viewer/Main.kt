package badlog.viewer

import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberCoroutineScope
import androidx.compose.ui.graphics.painter.BitmapPainter
import androidx.compose.ui.graphics.toComposeImageBitmap
import androidx.compose.ui.window.Window
import androidx.compose.ui.window.application
import badlog.viewer.app.StartPlace
import badlog.viewer.app.Viewer
import badlog.viewer.app.ViewerScreen
import badlog.viewer.app.openFirst
import badlog.viewer.app.placeOf
import badlog.viewer.app.windowStateOf
import badlog.viewer.settings.SettingsFile
import badlog.viewer.settings.UserFolders
import badlog.viewer.settings.keepSettings
import java.io.IOException
import java.nio.file.Path
import org.jetbrains.skia.Image

/** Opens the window on the folder or file that [args] names, else on the folder of last time. */
fun main(args: Array<String>) {
    val folders = UserFolders.ofSystem()
    val settingsFile = SettingsFile(folders.settings.resolve("settings.json"))
    val settings = settingsFile.read()
    val samples = System.getProperty("badlog.samples")?.let(Path::of)
    val start = StartPlace.of(args.firstOrNull(), settings, samples)
    application {
        val scope = rememberCoroutineScope()
        val viewer = remember { Viewer(scope, folders, settings) }
        val window = remember { windowStateOf(settings.window) }
        val icon = remember { windowIcon() }
        Window(
            onCloseRequest = {
                viewer.settings = viewer.settings.copy(window = placeOf(window, viewer.settings.window))
                try {
                    settingsFile.write(viewer.settings)
                } catch (_: IOException) {
                    // The window is about to go; that the settings cannot be kept was said when they changed.
                }
                exitApplication()
            },
            state = window,
            title = viewer.open?.label?.let { "$it – badlog" } ?: "badlog",
            icon = icon,
            onKeyEvent = { viewer.keyboard.dispatch(it, viewer.commands) },
        ) {
            ViewerScreen(viewer)
        }
        LaunchedEffect(viewer) {
            openFirst(viewer, start)
            keepSettings(viewer, settingsFile)
        }
    }
}

private fun windowIcon(): BitmapPainter {
    val png = checkNotNull(Viewer::class.java.getResourceAsStream("/badlog/viewer/badlog.png")).use { it.readAllBytes() }
    return BitmapPainter(Image.makeFromEncoded(png).toComposeImageBitmap())
}
