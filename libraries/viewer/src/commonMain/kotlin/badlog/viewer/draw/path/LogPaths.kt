package badlog.viewer.draw.path

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.signals.clock.secondsPerX
import badlog.signals.pose.Pose
import badlog.signals.pose.posesOf
import badlog.signals.swerve.swerveModulesOf
import badlog.viewer.choices.board.FieldOrigin

/**
 * What graphs of y over x can draw of a log.
 *
 * @param field the field on which its paths are.
 * @param line finds a line of it by its name.
 */
class LogPaths(internal val view: LogView, private val field: Field, private val line: (String) -> GraphSeries?) {
    /** The poses in its topics. */
    val poses: List<Pose> = posesOf(view.recording.topics)

    private val modules = swerveModulesOf(view.recording.topics)

    /** Returns the plot of y over x for a graph of [lines] whose poses are measured from [origin]; null if it has none of them. */
    fun plotOf(lines: List<String>, origin: FieldOrigin = FieldOrigin.BLUE): XyPlot? =
        xyPlotOf(lines, poses, modules, origin.flipIn(view, field), field, view.secondsPerX, line)
}
