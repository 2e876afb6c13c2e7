package badlog.window.app

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberCoroutineScope
import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.graphics.painter.BitmapPainter
import androidx.compose.ui.graphics.toComposeImageBitmap
import androidx.compose.ui.window.ApplicationScope
import androidx.compose.ui.window.FrameWindowScope
import androidx.compose.ui.window.Window
import androidx.compose.ui.window.WindowState
import badlog.fetch.RobotAddress
import badlog.files.UserFolders
import badlog.window.layout.LayoutStore
import badlog.window.settings.SettingsFile
import badlog.window.settings.SettingsStore
import badlog.window.task.FailureBoundary
import badlog.window.task.FailureLog
import badlog.window.task.Failures
import badlog.window.task.FailuresSeen
import badlog.window.task.Notices
import badlog.window.task.endWhenStuck
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.drop
import kotlinx.coroutines.launch
import org.jetbrains.skia.Image

/**
 * The window, from its opening on [start] to its closing, which ends the application.
 *
 * @param folders the folders of the user's own files.
 * @param robots returns the addresses to try for a robot, given the text that a person typed.
 * @param content additional content of the window.
 */
@Composable
internal fun ApplicationScope.ViewerWindow(
    folders: UserFolders,
    start: (Viewer) -> StartPlace,
    robots: (String) -> List<RobotAddress> = { RobotAddress.of(it) },
    content: @Composable FrameWindowScope.(Viewer) -> Unit = {},
) {
    val scope = rememberCoroutineScope()
    val notices = remember { Notices() }
    val failures = remember { Failures(FailureLog(folders.cache), notices) }
    val kept = remember { SettingsFile(folders.settings.resolve(SettingsFile.NAME)).read() }
    val viewer = remember { Viewer(failures.guarded(scope), folders, kept, notices = notices, robots = robots) }
    val place = remember { windowStateOf(kept.window) }
    val icon = remember { windowIcon() }
    val saveAll = {
        saveAll(viewer.layouts, viewer.settings, place)
        viewer.recording.finish()
        viewer.writes.finish()
    }
    FailureBoundary(failures) {
        OpenWindow(viewer, folders, place, icon, saveAll) {
            FailuresSeen(failures)
            content(it)
        }
    }
    LaunchedEffect(viewer) {
        // The place is saved while the window is open: a program that is ended from outside saves nothing.
        snapshotFlow { placeOf(place, viewer.settings.state.window) }.drop(1).collectLatest { seen ->
            delay(PLACE_MILLIS)
            viewer.settings.change { copy(window = seen) }
        }
    }
    LaunchedEffect(viewer) {
        viewer.start()
        viewer.scope.launch {
            val first = start(viewer)
            with(viewer) { openFirst(first, library, layouts, newest, loader, notices) }
            if (first.isPit) beginWithPit(viewer.library, viewer.layouts, viewer.panels)
        }
        endWhenStuck(failures, isInSight = { !place.isMinimized }) {
            saveAll()
            exitApplication()
        }
    }
}

@Composable
private fun ApplicationScope.OpenWindow(
    viewer: Viewer,
    folders: UserFolders,
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
        title = if (viewer.current.recording == null) viewer.heading else "${viewer.heading} – badlog",
        icon = icon,
        onPreviewKeyEvent = { viewer.keyboard.dispatchFirst(it, viewer.commands) },
        onKeyEvent = { viewer.keyboard.dispatch(it, viewer.commands) },
    ) {
        ViewerScreen(viewer)
        content(viewer)
        LaunchedEffect(viewer) {
            withFrameNanos { }
            viewer.scope.launch { warmUpGraphs(folders) }
        }
    }
}

/** Writes layouts and settings immediately instead of a moment later. */
private fun saveAll(layouts: LayoutStore, settings: SettingsStore, place: WindowState) {
    layouts.saveNow()
    settings.change { copy(window = placeOf(place, window)) }
    settings.saveNow()
}

/** The time to wait after the last move: a window moves in many small steps. */
private const val PLACE_MILLIS = 1000L

private fun windowIcon(): BitmapPainter {
    val png = checkNotNull(Viewer::class.java.getResourceAsStream("/badlog/window/badlog.png")).use { it.readAllBytes() }
    return BitmapPainter(Image.makeFromEncoded(png).toComposeImageBitmap())
}
