package badlog.window.benchmark

import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.viewer.choices.board.Board
import badlog.viewer.state.PlaceAction
import badlog.window.graph.GraphPane
import badlog.window.log.OpenRecording
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import kotlinx.coroutines.launch
import java.nio.file.Path
import kotlin.math.sin

/**
 * Returns the longest time that the window's thread is blocked after each of a few choices. A log of a million rows is compared with
 * another one of as many, with five formulas in both.
 */
internal fun measureChoiceBlocks(): List<FrameTimes> =
    OffScreenWindow { viewer -> ViewerTheme(Theme.LIGHT) { GraphPane(viewer.graphs) } }.use(::choiceBlocksIn)

private fun choiceBlocksIn(window: OffScreenWindow): List<FrameTimes> {
    val viewer = window.viewer
    val isReady = {
        !viewer.shown.isWaiting && viewer.graphs.plots.areReady(viewer.compared.drawn, viewer.view.viewport.visible)
    }
    window.measure({
        val open = longLog("open.bag")
        val other = longLog("other.bag")
        viewer.current.replace(open)
        viewer.compared.change { with(other.file).withLoaded(other) }
        viewer.board.replace(Board().withGraph(listOf("Topic 0", "Topic 1")).withGraph(listOf("Sum 0")).withGraph(listOf("Sum 4")))
        viewer.view.send(PlaceAction.Open(open.span))
        viewer.scope.launch { viewer.shown.run() }
    }, isReady)

    fun longest(choice: () -> Unit): Double {
        window.measure(choice, isReady)
        return window.longestBlock
    }
    val formulas = List(FORMULAS) { "Sum $it = mean(Topic $it, 50) + Topic ${it + 1} * ${it + 2}" }
    val rounds = List(ROUNDS + 1) {
        listOf(
            "five formulas" to longest { viewer.formulas.replaceAll(formulas) },
            "drawn over the time" to longest { viewer.axis.choose(true) },
            "drawn over row numbers" to longest { viewer.axis.choose(false) },
            "no formulas" to longest { viewer.formulas.replaceAll(emptyList()) },
        )
    }
    return rounds[0].indices.map { choice -> FrameTimes(rounds[0][choice].first, rounds.drop(1).map { it[choice].second }) }
}

private fun longLog(name: String): OpenRecording {
    val time = topic("Time", "s") { it * 0.02 }
    val topics = List(TOPICS) { number -> topic("Topic $number", "V") { 12 + sin(it * 0.001 * (number + 1)) } }
    val recording = Recording(RecordingFormat.BAG, null, emptyList(), listOf(time) + topics, SAMPLES, emptyList())
    return OpenRecording(Path.of(name).toAbsolutePath(), LogView.of(recording))
}

private const val TOPICS = 8
private const val FORMULAS = 5
private const val ROUNDS = 5
