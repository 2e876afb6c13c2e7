package badlog.window.benchmark

import badlog.core.recording.Topic
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.draw.path.Field
import badlog.viewer.state.PlaceAction
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.random.Random

/**
 * Returns the durations of frames while zooming and moving the cursor over a robot's path. The path has a million poses, and its plan is
 * beside it.
 */
internal fun measurePathFrames(pictures: Path): List<FrameTimes> {
    val lines = listOf("Drive/Pose X", "Drive/Pose Y", "Drive/Target Pose X", "Drive/Target Pose Y")
    val board = Board(listOf(BoardGraph(1, "Path", lines, isXy = true, height = GraphHeight.LARGE.pixels)))
    return framesOf(longPath(), { board }, pictures.resolve("path-of-a-million.png")) { window, isReady ->
        val viewer = window.viewer
        val random = Random(1)
        val planes = viewer.graphs.planes
        val whole = checkNotNull(viewer.current.recording?.paths?.plotOf(lines)).full

        fun zoom(): Double = window.measure({
            val plane = planes[1] ?: whole
            val isIn = plane.x.width > whole.x.width / 50 && (plane.x.width >= whole.x.width || random.nextBoolean())
            val factor = if (isIn) 1 / 1.22 else 1.22
            // Around a visible place, so that the path stays visible.
            planes[1] = plane.scaled(factor, plane.xAt(random.nextDouble()), plane.yAt(random.nextDouble()))
        }, isReady)
        fun cursor(): Double = window.measure({
            viewer.view.send(PlaceAction.MoveCursor(viewer.view.viewport.visible.let { it.from + it.width * random.nextDouble() }))
        }, isReady)
        repeat(WARM_UP) {
            zoom()
            cursor()
        }
        listOf(FrameTimes("zoom of the path", List(FRAMES) { zoom() }), FrameTimes("cursor on the path", List(FRAMES) { cursor() }))
    }
}

/** Returns rounds over the whole field, a little beside the plan. */
private fun longPath(): List<Topic> {
    val random = Random(7)
    fun x(i: Int) = Field.LENGTH / 2 + Field.LENGTH * 0.4 * sin(2 * PI * i / 1500) * cos(i / 90_000.0)
    fun y(i: Int) = Field.WIDTH / 2 + Field.WIDTH * 0.4 * cos(2 * PI * i / 1100)
    return listOf(
        topic("Drive/Pose X", "m") { x(it) + 0.1 * random.nextDouble() },
        topic("Drive/Pose Y", "m") { y(it) + 0.1 * random.nextDouble() },
        topic("Drive/Pose Heading", "deg") { it % 360.0 },
        topic("Drive/Target Pose X", "m") { x(it) },
        topic("Drive/Target Pose Y", "m") { y(it) },
    )
}

private const val WARM_UP = 60
private const val FRAMES = 200
