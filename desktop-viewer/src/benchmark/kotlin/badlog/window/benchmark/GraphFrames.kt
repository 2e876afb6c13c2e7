package badlog.window.benchmark

import badlog.core.recording.Topic
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.state.PlaceAction
import java.nio.file.Path
import kotlin.math.sin
import kotlin.random.Random

/** Returns the durations of frames while zooming, panning, and moving the cursor over ten graphs of a million samples each. */
internal fun measureFrames(pictures: Path): List<FrameTimes> =
    framesOf(tenSignals(), ::defaultBoard, pictures.resolve("ten-graphs.png")) { window, isReady ->
        val viewer = window.viewer
        val full = viewer.view.viewport.full
        val random = Random(1)

        // From the whole log to a fiftieth of it. The more samples a pixel column has, the longer its strokes are.
        fun zoom(): Double = window.measure({
            val visible = viewer.view.viewport.visible
            val isIn = if (visible.width < full.width / 50) false else !viewer.view.viewport.isZoomed || random.nextBoolean()
            viewer.view.send(PlaceAction.Scale(if (isIn) 1 / 1.22 else 1.22, visible.from + visible.width * random.nextDouble()))
        }, isReady)
        fun pan(): Double = window.measure({
            val step = viewer.view.viewport.visible.width / 50
            val isAtEnd = viewer.view.viewport.visible.to > full.to - step
            viewer.view.send(PlaceAction.Shift(if (isAtEnd) -full.width else step))
        }, isReady)
        fun cursor(): Double = window.measure({
            viewer.view.send(PlaceAction.MoveCursor(viewer.view.viewport.visible.let { it.from + it.width * random.nextDouble() }))
        }, isReady)
        repeat(WARM_UP) {
            zoom()
            pan()
            cursor()
        }
        listOf(
            FrameTimes("zoom", List(FRAMES) { zoom() }),
            FrameTimes("pan", viewer.view.send(PlaceAction.Show(0.0, full.width / 20)).let { List(FRAMES) { pan() } }),
            FrameTimes("cursor", List(FRAMES) { cursor() }),
        )
    }

private fun tenSignals(): List<Topic> {
    val random = Random(7)
    return List(GRAPHS) { graph ->
        var walk = 0.0
        topic("Signals/Signal $graph", "V") {
            walk += random.nextDouble() - 0.5
            12 + 2 * sin(it / 20000.0 * (graph + 1)) + walk / 50 + random.nextDouble()
        }
    }
}

private const val GRAPHS = 10
private const val WARM_UP = 150
private const val FRAMES = 300
