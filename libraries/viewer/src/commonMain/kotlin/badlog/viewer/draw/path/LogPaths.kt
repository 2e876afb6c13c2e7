package badlog.viewer.draw.path

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.signals.clock.secondsPerX
import badlog.signals.pose.Pose
import badlog.signals.pose.posesOf
import badlog.signals.swerve.swerveModulesOf
import badlog.viewer.choices.board.FieldOrigin

/**
 * The content of a log that graphs of y over x can draw.
 *
 * @param field the field of its paths.
 * @param line finds a line of the log by its name.
 */
class LogPaths(internal val view: LogView, private val field: Field, private val line: (String) -> GraphSeries?) {
    /** The poses in the log's topics. */
    val poses: List<Pose> = posesOf(view.recording.topics)

    private val modules = swerveModulesOf(view.recording.topics)

    /** Returns the plot of y over x for a graph of [lines], with poses measured from [origin]. Null if there is nothing to draw. */
    fun plotOf(lines: List<String>, origin: FieldOrigin = FieldOrigin.BLUE): XyPlot? =
        xyPlotOf(lines, poses, modules, origin.flipIn(view, field), field, view.secondsPerX, line)
}
