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
import androidx.compose.ui.window.WindowState
import badlog.viewer.failure.FailureLog
import badlog.viewer.failure.Failures
import badlog.viewer.failure.FailuresHeard
import badlog.viewer.failure.FailuresSeen
import badlog.viewer.failure.endWhenStuck
import badlog.viewer.graph.warmUpGraphs
import badlog.viewer.settings.SettingsFile
import badlog.viewer.settings.UserFolders
import badlog.viewer.settings.keepSettings
import badlog.viewer.task.Notices
import kotlinx.coroutines.launch
import org.jetbrains.skia.Image
import java.io.IOException

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
    val notices = remember { Notices() }
    val failures = remember { Failures(FailureLog(folders.cache), notices) }
    val settingsFile = remember { SettingsFile(folders.settings.resolve("settings.json")) }
    val kept = remember { settingsFile.read() }
    val viewer = remember { Viewer(failures.guarded(scope), folders, kept, notices = notices) }
    val place = remember { windowStateOf(kept.window) }
    val icon = remember { windowIcon() }
    FailuresHeard(failures) {
        OpenWindow(viewer, place, icon, { keepAll(viewer, place, settingsFile) }) {
            FailuresSeen(failures)
            content(it)
        }
    }
    LaunchedEffect(viewer) {
        viewer.scope.launch { viewer.layouts.keep() }
        viewer.scope.launch { viewer.formulaKeeping.keep() }
        viewer.scope.launch { viewer.ruleRunning.keep() }
        viewer.scope.launch { keepSettings(viewer, settingsFile, kept) }
        viewer.scope.launch { openFirst(viewer, start(viewer)) }
        endWhenStuck(failures, isInSight = { !place.isMinimized }) {
            keepAll(viewer, place, settingsFile)
            exitApplication()
        }
    }
}

@Composable
private fun ApplicationScope.OpenWindow(
    viewer: Viewer,
    place: WindowState,
    icon: BitmapPainter,
    beforeClosing: () -> Unit,
    content: @Composable FrameWindowScope.(Viewer) -> Unit,
) {
    Window(
        onCloseRequest = {
            beforeClosing()
            exitApplication()
        },
        state = place,
        title = viewer.open?.label?.let { "$it – badlog" } ?: "badlog",
        icon = icon,
        onPreviewKeyEvent = { viewer.keyboard.dispatchFirst(it, viewer.commands) },
        onKeyEvent = { viewer.keyboard.dispatch(it, viewer.commands) },
    ) {
        ViewerScreen(viewer)
        content(viewer)
        LaunchedEffect(viewer) {
            withFrameNanos { }
            viewer.scope.launch { warmUpGraphs(viewer.folders) }
        }
    }
}

/** Writes at once what else would be written in a moment. */
private fun keepAll(viewer: Viewer, place: WindowState, file: SettingsFile) {
    viewer.layouts.keepNow()
    viewer.settings = viewer.settings.copy(window = placeOf(place, viewer.settings.window))
    try {
        file.write(viewer.settings)
    } catch (_: IOException) {
        // The window is about to go; that the settings cannot be kept was said when they changed.
    }
}

private fun windowIcon(): BitmapPainter {
    val png = checkNotNull(Viewer::class.java.getResourceAsStream("/badlog/viewer/badlog.png")).use { it.readAllBytes() }
    return BitmapPainter(Image.makeFromEncoded(png).toComposeImageBitmap())
}
