package badlog.window.graph.plot

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.graphics.drawscope.drawIntoCanvas
import androidx.compose.ui.graphics.skiaCanvas
import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.axis.seenOn
import badlog.viewer.draw.axis.seenTogether
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.plot.Plot
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotLane
import badlog.viewer.draw.plot.drawLines
import badlog.viewer.draw.plot.plotOf
import badlog.window.compare.DrawnRecording
import badlog.window.pen.SkiaPen
import badlog.window.theme.Palette
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.withContext
import org.jetbrains.skia.Image
import org.jetbrains.skia.Rect
import org.jetbrains.skia.SamplingMode
import org.jetbrains.skia.Surface
import kotlin.math.roundToInt

/**
 * A graph that is ready to be drawn: everything is in pixels, and nothing is left to calculate.
 *
 * @property request the request it was made for.
 * @property plot the plot for a pen.
 * @property lines the lines of numbers, in the same order as in [plot].
 * @property lanes the lanes of states, below the lines.
 * @property image the drawn lines; null if there are none.
 */
internal class PlotPicture(
    val request: PlotRequest,
    val plot: Plot,
    val lines: List<DrawnLine>,
    val lanes: List<DrawnLine>,
    val image: Image?,
) {
    /** The height of the lines, in pixels; the lanes have the rest. */
    val plotHeight: Float get() = (request.height * (1 - plot.laneShare)).toFloat()

    /** Returns whether it shows [line]. */
    operator fun contains(line: DrawnLine): Boolean = line in lines || line in lanes
}

/** Returns the text beside the lane of [line], which is one of [all]: its title, the name of its recording, or both. */
internal fun laneName(line: DrawnLine, all: List<DrawnLine>): String {
    val label = line.label?.take(MAX_LETTERS) ?: return line.title.take(MAX_LETTERS)
    return if (all.all { it.signal.name == line.signal.name }) label else "${line.title.take(MAX_LETTERS)} · $label"
}

private const val MAX_LETTERS = 40

/**
 * A request for a graph's picture.
 *
 * @property spec the graph.
 * @property recordings the recordings it shows.
 * @property visible the visible part of x.
 * @property width the width of that part in physical pixels; above 0.
 * @property height the height of y in physical pixels; above 0.
 * @property palette the colors.
 * @property sharing the other graphs that share their y limits with it.
 * @property density the number of physical pixels per dp.
 */
internal data class PlotRequest(
    val spec: BoardGraph,
    val recordings: List<DrawnRecording>,
    val visible: Span,
    val width: Int,
    val height: Int,
    val palette: Palette,
    val density: Float,
    val sharing: List<BoardGraph> = emptyList(),
) {
    /** The frame of its picture. */
    val frame: PlotFrame get() = PlotFrame(0.0, 0.0, width.toDouble(), height.toDouble(), visible)
}

/** The maximum number of lines and lanes in a graph; a person cannot distinguish more. */
internal const val MAX_LINES = 64

/**
 * Returns the picture for [request], with an image of its lines for the screen if [hasImage]. It takes a while: call it off the window's
 * thread.
 */
internal fun makePicture(request: PlotRequest, curves: CurveCache, hasImage: Boolean = true): PlotPicture {
    val (states, numbers) = shownLines(request.spec, request).partition { it.signal.states != null }
    val strokes = strokesOf(numbers, request, curves)
    val shared = if (request.spec.sharesY) seen(numbers, strokes) + request.sharing.flatMap { seenIn(it, request, curves) } else emptyList()
    val lanes = states.map { PlotLane(laneName(it, states), it.signal.states.orEmpty(), blocksOf(it, request, curves)) }
    val plot = plotOf(request.spec, numbers, strokes, lanes, request.frame, request.density.toDouble(), seenTogether(shared))
    return PlotPicture(request, plot, numbers, states, if (hasImage) rasterOf(request, plot) else null)
}

private fun shownLines(spec: BoardGraph, request: PlotRequest) = drawnLines(spec, request.recordings)
    .filter { line -> line.signal.name !in spec.hidden && visibleOf(line, request).width.let { it > 0 && it.isFinite() } }
    .take(MAX_LINES)

private fun strokesOf(numbers: List<DrawnLine>, request: PlotRequest, curves: CurveCache) =
    numbers.map { curves.curve(it.recording, it.signal).trace(visibleOf(it, request), request.width) }

private fun seen(numbers: List<DrawnLine>, strokes: List<Strokes>) = seenOn(graphAxes(numbers.map { it.signal.unit }), strokes)

/** Returns the visible range of each unit in [spec], another graph that shares the y limits. */
private fun seenIn(spec: BoardGraph, request: PlotRequest, curves: CurveCache): List<SeenOfUnit> {
    val numbers = shownLines(spec, request).filter { it.signal.states == null }
    return seen(numbers, strokesOf(numbers, request, curves))
}

/** Returns the visible part of the line's own x. */
private fun visibleOf(line: DrawnLine, request: PlotRequest) = Span(request.visible.from - line.offset, request.visible.to - line.offset)

private fun blocksOf(line: DrawnLine, request: PlotRequest, curves: CurveCache) = LaneBlocks().apply {
    place(curves.runs(line.recording, line.signal), visibleOf(line, request), request.width.toDouble(), request.density.toDouble())
}

/**
 * Returns an image of the lines of [plot], which was made for [request]; null if there are none. Without a graphics card, long strokes are
 * most of the work of a frame. They are therefore drawn here, on the thread that makes the picture, and the window only copies the image.
 */
internal fun rasterOf(request: PlotRequest, plot: Plot): Image? {
    val frame = request.frame.part(0.0, 1 - plot.laneShare)
    val rows = frame.height.roundToInt()
    if (plot.lines.isEmpty() || rows < 1) return null
    return Surface.makeRasterN32Premul(request.width, rows).use { surface ->
        SkiaPen(surface.canvas, request.density.toDouble()).drawLines(frame, plot.lines, plot.axes, plot.isFilled, request.palette.pen)
        surface.makeImageSnapshot()
    }
}

/**
 * Draws the lines of [picture] within [frame]. A picture made for another part of x is stretched to fit, until the requested one is ready.
 */
internal fun DrawScope.drawLines(picture: PlotPicture, frame: PlotFrame) {
    val image = picture.image ?: return
    val made = picture.request.visible
    val left = frame.left.toFloat() + pixelOf(made.from, frame.shown, frame.width.toFloat())
    val right = frame.left.toFloat() + pixelOf(made.to, frame.shown, frame.width.toFloat())
    // A picture of a much larger or smaller range would show nothing.
    if (right - left !in frame.width / MAX_STRETCH..frame.width * MAX_STRETCH) return
    val whole = Rect.makeWH(image.width.toFloat(), image.height.toFloat())
    clipRect(left = frame.left.toFloat(), right = frame.right.toFloat()) {
        drawIntoCanvas { canvas ->
            canvas.skiaCanvas.drawImageRect(image, whole, Rect(left, 0f, right, image.height.toFloat()), SamplingMode.DEFAULT, null, true)
        }
    }
}

/** Returns the frame that fills this scope and shows [shown]. */
internal fun DrawScope.frameOf(shown: Span): PlotFrame = PlotFrame(0.0, 0.0, size.width.toDouble(), size.height.toDouble(), shown)

/** Returns the pixel of [x] on [width] pixels that show [visible]. */
internal fun pixelOf(x: Double, visible: Span, width: Float): Float = ((x - visible.from) / visible.width * width).toFloat()

private const val MAX_STRETCH = 64

/**
 * Keeps the picture of [state] up to date with [request]; a null request leaves it unchanged. Pictures are made off the window's thread; of
 * the requests in the meantime, only the latest is kept.
 */
@Composable
internal fun PictureEffect(state: PlotState, curves: CurveCache, request: () -> PlotRequest?) {
    val latest by rememberUpdatedState(request)
    LaunchedEffect(state, curves) {
        snapshotFlow { latest() }.conflate().collect { wanted ->
            if (wanted != null && wanted != state.picture?.request) {
                val before = state.picture
                // The old picture stays until then only if it shows one of the same lines.
                if (before != null && before.request.spec.lines.none { it in wanted.spec.lines }) state.picture = null
                state.picture = withContext(Dispatchers.Default) { makePicture(wanted, curves) }
                // Images of sixty frames per second would fill the memory long before the garbage collector frees them.
                before?.image?.close()
            }
        }
    }
}
