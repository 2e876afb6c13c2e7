package badlog.window.benchmark

import badlog.core.analysis.LogView
import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.viewer.choices.board.Board
import badlog.viewer.state.PlaceAction
import badlog.window.graph.GraphPane
import badlog.window.log.OpenRecording
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import java.nio.file.Path

/**
 * The durations of measured frames.
 *
 * @property name the measured action.
 * @property millis the duration of each frame.
 */
internal class FrameTimes(val name: String, val millis: List<Double>) {
    /** Returns the duration in milliseconds that [percent] percent of the frames do not exceed. */
    fun percentile(percent: Int): Double = millis.sorted()[(millis.size - 1) * percent / 100]
}

/** The number of samples of each topic in the measured logs, at 50 Hz. */
internal const val SAMPLES = 1_000_000

/** Returns a topic of [SAMPLES] samples. */
internal fun topic(name: String, unit: String, attributes: List<String> = emptyList(), value: (Int) -> Double) =
    Topic(name, unit, attributes, DoubleArray(SAMPLES) { value(it) }, TextColumn.EMPTY, CellCounts(SAMPLES, 0, 0, 0, 0, 0))

/**
 * Measures frames of a log of [topics] in an off-screen window, with the graphs of [boardOf] on the board. [measure] gets the window, and a
 * function that returns whether everything is drawn. Pictures from before and after are saved as [picture] and beside it.
 */
internal fun framesOf(
    topics: List<Topic>,
    boardOf: (LogView) -> Board,
    picture: Path,
    measure: (OffScreenWindow, isReady: () -> Boolean) -> List<FrameTimes>,
): List<FrameTimes> = OffScreenWindow { viewer -> ViewerTheme(Theme.LIGHT) { GraphPane(viewer.graphs) } }.use { window ->
    val viewer = window.viewer
    val time = topic("Time", "s", listOf("xaxis", "hide")) { it * 0.02 }
    val isReady = { viewer.graphs.plots.areReady(viewer.compared.drawn, viewer.view.viewport.visible) }
    window.measure({
        val view = LogView.of(Recording(RecordingFormat.BAG, null, emptyList(), listOf(time) + topics, SAMPLES, emptyList()))
        val recording = OpenRecording(picture.resolveSibling("measured.bag").toAbsolutePath(), view)
        viewer.current.replace(recording)
        viewer.board.replace(boardOf(recording.view))
        viewer.view.send(PlaceAction.Open(recording.span))
    }, isReady)
    window.save(picture)
    measure(window, isReady).also { window.save(picture.resolveSibling("zoomed-${picture.fileName}")) }
}
