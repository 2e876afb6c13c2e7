package badlog.window.app

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.unit.Density
import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.bag.RowBatchParser
import badlog.files.UserFolders
import badlog.viewer.state.PlaceAction
import badlog.window.log.OpenRecording
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.withContext
import java.nio.file.Path
import kotlin.math.roundToInt
import kotlin.math.sin

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
