package badlog.viewer.app

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberCoroutineScope
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.graphics.painter.BitmapPainter
import androidx.compose.ui.graphics.toComposeImageBitmap
import androidx.compose.ui.window.ApplicationScope
import androidx.compose.ui.window.FrameWindowScope
import androidx.compose.ui.window.Window
import badlog.viewer.graph.warmUpGraphs
import badlog.viewer.settings.SettingsFile
import badlog.viewer.settings.UserFolders
import badlog.viewer.settings.keepSettings
import java.io.IOException
import org.jetbrains.skia.Image

/**
 * The window, from its opening on [start] to its closing, which ends the application.
 *
 * @param folders where the user's own files are.
 * @param content what more is to happen in the window.
 */
@Composable
internal fun ApplicationScope.ViewerWindow(
    folders: UserFolders,
    start: (Viewer) -> StartPlace,
    content: @Composable FrameWindowScope.(Viewer) -> Unit = {},
) {
    val scope = rememberCoroutineScope()
    val settingsFile = remember { SettingsFile(folders.settings.resolve("settings.json")) }
    val viewer = remember { Viewer(scope, folders, settingsFile.read()) }
    val place = remember { windowStateOf(viewer.settings.window) }
    val icon = remember { windowIcon() }
    Window(
        onCloseRequest = {
            viewer.layouts.keepNow()
            viewer.settings = viewer.settings.copy(window = placeOf(place, viewer.settings.window))
            try {
                settingsFile.write(viewer.settings)
            } catch (_: IOException) {
                // The window is about to go; that the settings cannot be kept was said when they changed.
            }
            exitApplication()
        },
        state = place,
        title = viewer.open?.label?.let { "$it – badlog" } ?: "badlog",
        icon = icon,
        onKeyEvent = { viewer.keyboard.dispatch(it, viewer.commands) },
    ) {
        ViewerScreen(viewer)
        content(viewer)
        LaunchedEffect(viewer) {
            withFrameNanos { }
            warmUpGraphs(viewer.folders)
        }
    }
    LaunchedEffect(viewer) { viewer.layouts.keep() }
    LaunchedEffect(viewer) {
        openFirst(viewer, start(viewer))
        keepSettings(viewer, settingsFile)
    }
}

private fun windowIcon(): BitmapPainter {
    val png = checkNotNull(Viewer::class.java.getResourceAsStream("/badlog/viewer/badlog.png")).use { it.readAllBytes() }
    return BitmapPainter(Image.makeFromEncoded(png).toComposeImageBitmap())
}
