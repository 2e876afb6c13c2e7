package badlog.viewer.benchmark

import badlog.analysis.LogView
import badlog.plot.board.Board
import badlog.plot.board.BoardGraph
import badlog.plot.board.GraphHeight
import badlog.plot.path.Field
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
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.random.Random

/** How long frames take while a person zooms into the path of a robot of a million poses, beside its plan, and moves the cursor. */
internal fun measurePathFrames(pictures: Path): List<FrameTimes> {
    OffScreenWindow { viewer -> ViewerTheme(Theme.LIGHT) { GraphPane(viewer.graphs) } }.use { window ->
        val viewer = window.viewer
        val isReady = { viewer.graphs.plots.areReady(viewer.compared.drawn, viewer.view.viewport.visible) }
        window.measure({
            val recording = OpenRecording(Path.of("path.bag").toAbsolutePath(), longPath())
            viewer.current.replace(recording)
            val lines = listOf("Drive/Pose X", "Drive/Pose Y", "Drive/Target Pose X", "Drive/Target Pose Y")
            viewer.board.replace(Board(listOf(BoardGraph(1, "Path", lines, isXy = true, height = GraphHeight.LARGE.pixels))))
            viewer.view.show(recording.span)
        }, isReady)
        window.save(pictures.resolve("path-of-a-million.png"))
        val random = Random(1)
        val planes = viewer.graphs.planes
        val whole = checkNotNull(viewer.current.recording?.xyPlot(viewer.board.state.graphs[0].lines)).full

        fun zoom(): Double = window.measure({
            val plane = planes[1] ?: whole
            val isIn = plane.x.width > whole.x.width / 50 && (plane.x.width > whole.x.width || random.nextBoolean())
            val factor = if (isIn) 1 / 1.22 else 1.22
            planes[1] = plane.scaled(factor, random.nextDouble() * Field.LENGTH, random.nextDouble() * Field.WIDTH)
        }, isReady)
        fun cursor(): Double = window.measure({
            viewer.view.placeCursor(viewer.view.viewport.visible.let { it.from + it.width * random.nextDouble() })
        }, isReady)
        repeat(WARM_UP) {
            zoom()
            cursor()
        }
        return listOf(FrameTimes("zoom of the path", List(FRAMES) { zoom() }), FrameTimes("cursor on the path", List(FRAMES) { cursor() }))
            .also { window.save(pictures.resolve("path-of-a-million-zoomed.png")) }
    }
}

/** Rounds over the whole field, a little beside the plan. */
private fun longPath(): LogView {
    val random = Random(7)
    fun x(i: Int) = Field.LENGTH / 2 + Field.LENGTH * 0.4 * sin(2 * PI * i / 1500) * cos(i / 90_000.0)
    fun y(i: Int) = Field.WIDTH / 2 + Field.WIDTH * 0.4 * cos(2 * PI * i / 1100)
    val topics = listOf(
        topic("Time", "s", listOf("xaxis", "hide")) { it * 0.02 },
        topic("Drive/Pose X", "m") { x(it) + 0.1 * random.nextDouble() },
        topic("Drive/Pose Y", "m") { y(it) + 0.1 * random.nextDouble() },
        topic("Drive/Pose Heading", "deg") { it % 360.0 },
        topic("Drive/Target Pose X", "m") { x(it) },
        topic("Drive/Target Pose Y", "m") { y(it) },
    )
    return LogView.of(Recording(RecordingFormat.BAG, null, emptyList(), topics, SAMPLES, emptyList()))
}

private fun topic(name: String, unit: String, attributes: List<String> = emptyList(), value: (Int) -> Double) =
    Topic(name, unit, attributes, DoubleArray(SAMPLES) { value(it) }, TextColumn.EMPTY, CellCounts(SAMPLES, 0, 0, 0, 0, 0))

private const val SAMPLES = 1_000_000
private const val WARM_UP = 60
private const val FRAMES = 200
