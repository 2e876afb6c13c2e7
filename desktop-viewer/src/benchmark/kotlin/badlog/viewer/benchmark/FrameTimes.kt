package badlog.viewer.benchmark

import badlog.analysis.LogView
import badlog.plot.board.defaultBoard
import badlog.plot.range.Viewport
import badlog.recording.CellCounts
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.TextColumn
import badlog.recording.Topic
import badlog.viewer.graph.GraphPane
import badlog.viewer.recording.OpenRecording
import badlog.viewer.theme.Theme
import badlog.viewer.theme.ViewerTheme
import java.nio.file.Path
import kotlin.math.sin
import kotlin.random.Random

/** How long frames take while a person zooms, pans, and moves the cursor over ten graphs of a million samples each. */
internal fun measureFrames(pictures: Path): List<FrameTimes> {
    OffScreenWindow { viewer -> ViewerTheme(Theme.LIGHT) { GraphPane(viewer.graphs) } }.use { window ->
        val viewer = window.viewer
        val isReady = { viewer.graphs.plots.areReady(viewer.compared.drawn, viewer.view.viewport.visible) }
        window.measure({
            val recording = OpenRecording(Path.of("ten-graphs.bag").toAbsolutePath(), tenMillionSamples())
            viewer.current.replace(recording)
            viewer.board.replace(defaultBoard(recording.view))
            viewer.view.show(recording.span)
        }, isReady)
        window.save(pictures.resolve("ten-graphs.png"))
        val full = viewer.view.viewport.full
        val random = Random(1)

        // From everything to a fiftieth of it: the more samples a pixel column has, the longer its strokes are.
        fun zoom(): Double = window.measure({
            val visible = viewer.view.viewport.visible
            val isIn = if (visible.width < full.width / 50) false else !viewer.view.viewport.isZoomed || random.nextBoolean()
            viewer.view.change { scaled(if (isIn) 1 / 1.22 else 1.22, visible.from + visible.width * random.nextDouble()) }
        }, isReady)
        fun pan(): Double = window.measure({
            val step = viewer.view.viewport.visible.width / 50
            val isAtEnd = viewer.view.viewport.visible.to > full.to - step
            viewer.view.change { shifted(if (isAtEnd) -full.width else step) }
        }, isReady)
        fun cursor(): Double = window.measure({
            viewer.view.placeCursor(viewer.view.viewport.visible.let { it.from + it.width * random.nextDouble() })
        }, isReady)
        repeat(WARM_UP) {
            zoom()
            pan()
            cursor()
        }
        return listOf(
            FrameTimes("zoom", List(FRAMES) { zoom() }),
            FrameTimes("pan", viewer.view.change { showing(0.0, full.width / 20) }.let { List(FRAMES) { pan() } }),
            FrameTimes("cursor", List(FRAMES) { cursor() }),
        ).also { window.save(pictures.resolve("ten-graphs-zoomed.png")) }
    }
}

/**
 * What frames took.
 *
 * @property name what was done.
 * @property millis how long each took.
 */
internal class FrameTimes(val name: String, val millis: List<Double>) {
    /** The value below which [percent] of the frames lie. */
    fun percentile(percent: Int): Double = millis.sorted()[(millis.size - 1) * percent / 100]
}

private fun tenMillionSamples(): LogView {
    val random = Random(7)
    val time = topic("Time", "s", listOf("xaxis", "hide")) { it * 0.02 }
    val topics = List(GRAPHS) { graph ->
        var walk = 0.0
        topic("Signals/Signal $graph", "V", emptyList()) {
            walk += random.nextDouble() - 0.5
            12 + 2 * sin(it / 20000.0 * (graph + 1)) + walk / 50 + random.nextDouble()
        }
    }
    return LogView.of(Recording(RecordingFormat.BAG, null, emptyList(), listOf(time) + topics, SAMPLES, emptyList()))
}

private fun topic(name: String, unit: String, attributes: List<String>, value: (Int) -> Double) =
    Topic(name, unit, attributes, DoubleArray(SAMPLES) { value(it) }, TextColumn.EMPTY, CellCounts(SAMPLES, 0, 0, 0, 0, 0))

private const val GRAPHS = 10
private const val SAMPLES = 1_000_000
private const val WARM_UP = 150
private const val FRAMES = 300
