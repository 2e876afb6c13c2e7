package badlog.window.app

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberCoroutineScope
import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.graphics.painter.BitmapPainter
import androidx.compose.ui.graphics.toComposeImageBitmap
import androidx.compose.ui.unit.Density
import androidx.compose.ui.window.ApplicationScope
import androidx.compose.ui.window.FrameWindowScope
import androidx.compose.ui.window.Window
import androidx.compose.ui.window.WindowState
import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.bag.RowBatchParser
import badlog.fetch.RobotAddress
import badlog.files.UserFolders
import badlog.viewer.state.PlaceAction
import badlog.window.layout.LayoutStore
import badlog.window.log.OpenRecording
import badlog.window.settings.SettingsFile
import badlog.window.settings.SettingsStore
import badlog.window.task.FailureBoundary
import badlog.window.task.FailureLog
import badlog.window.task.Failures
import badlog.window.task.FailuresSeen
import badlog.window.task.Notices
import badlog.window.task.endWhenStuck
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.drop
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import org.jetbrains.skia.Image
import java.nio.file.Path
import kotlin.math.roundToInt
import kotlin.math.sin

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

/**
 * Draws a few small invisible graphs. This loads the code for graphs while a person looks for a log. Otherwise, the first graphs would take
 * half a second longer. Call it on the window's thread, which can do other work in between.
 */
internal suspend fun warmUpGraphs(folders: UserFolders): Unit = coroutineScope {
    val recording = withContext(Dispatchers.Default) {
        val parser = BagParser()
        parser.accept(BAG_HEADER.encodeToByteArray())
        // Enough rows to make Java compile the parser.
        val rows = BAG_ROWS.encodeToByteArray()
        parser.accept(rows)
        val batches = RowBatchParser(checkNotNull(parser.readsDecimalComma))
        repeat(REPEATS) {
            parser.accept(checkNotNull(batches.parse(rows, 0, rows.size)))
            parser.accept(rows)
        }
        OpenRecording(Path.of("warm-up.bag"), LogView.of(parser.finish()))
    }
    val viewer = Viewer(this, folders)
    viewer.current.replace(recording)
    viewer.board.replace(recording.standardGraphs)
    viewer.view.send(PlaceAction.Open(recording.span))
    val scene = ImageComposeScene(WIDTH, HEIGHT, Density(1f), coroutineContext) {
        ViewerScreen(viewer)
    }
    try {
        repeat(FRAMES) { frame ->
            viewer.view.send(PlaceAction.MoveCursor(frame / 10.0))
            viewer.view.send(PlaceAction.Scale(0.99, 1.0))
            scene.render(System.nanoTime()).close()
            delay(FRAME_MILLIS)
        }
    } finally {
        scene.close()
    }
}

private const val WIDTH = 1000
private const val HEIGHT = 480
private const val FRAMES = 10
private const val FRAME_MILLIS = 10L

private const val REPEATS = 30

/** A bit of everything: numbers, states, events, and an enabled robot. */
private val BAG_HEADER = buildString {
    append("""{"topics":[{"name":"Time","unit":"s","attrs":["hide"]},{"name":"A/Number","unit":"V","attrs":["differentiate"]},""")
    append(
        """{"name":"A/State","unit":"ul","attrs":[]},{"name":"Enabled","unit":"ul","attrs":[]},{"name":"Events","unit":"ul","attrs":[]}""",
    )
    repeat(NUMBERS) { append(""",{"name":"B/$it","unit":"m","attrs":["hide"]}""") }
    append("""],"values":[]}""")
    append("\nTime,A/Number,A/State,Enabled,Events")
    repeat(NUMBERS) { append(",B/$it") }
    append('\n')
}

private val SCALES = intArrayOf(9_000, 900, 3_000_000, 120_000)

// As robots write them: whole numbers and fractions, negative and small ones, words, quoted events, empty cells. Code that has
// seen only one kind would be compiled for that kind, and again at the first real log.
private val BAG_ROWS = buildString {
    repeat(1000) { row ->
        val event = if (row % 90 == 7) "\"said, at $row\"" else ""
        append("${row / 100.0},${row % 7},${if (row % 500 < 200) "LOW" else "HIGH"},${row > 100},$event")
        repeat(NUMBERS) {
            val wave = (sin(row * 0.1 + it) * SCALES[it % SCALES.size]).roundToInt()
            append(
                if (it % 5 == 0) {
                    ",$wave"
                } else if (row % 200 == it) {
                    ","
                } else {
                    ",${wave / 10_000.0}"
                },
            )
        }
        append('\n')
    }
}

private const val NUMBERS = 16
