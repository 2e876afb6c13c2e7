package badlog.viewer.panels

import androidx.compose.ui.graphics.vector.ImageVector
import badlog.viewer.part.Part
import badlog.viewer.theme.Icons

/**
 * Which parts of the window are open.
 *
 * @property library whether the list of logs stands at the left.
 * @property topics whether the topics stand beside it.
 * @property inspector which panel stands at the right, or null for none.
 * @property main what fills the middle.
 * @property front which part is seen where the window is too narrow for more than one.
 * @property statistics of what the panel of statistics tells.
 * @property help whether the help sheet lies above everything.
 */
internal data class Panels(
    val library: Boolean = true,
    val topics: Boolean = true,
    val inspector: InspectorTab? = null,
    val main: MainView = MainView.GRAPHS,
    val front: FrontPart = FrontPart.GRAPHS,
    val statistics: StatisticsRange = StatisticsRange.SHOWN,
    val help: Boolean = false,
) {
    /** Fills the middle with [view], or with the graphs again when that is what fills it. */
    fun toggled(view: MainView): Panels = copy(main = if (main == view) MainView.GRAPHS else view)

    /** Opens [tab] at the right, or closes it when it is open. */
    fun toggled(tab: InspectorTab): Panels = if (inspector == tab) withoutInspector() else inspecting(tab)

    /** Shows [tab] at the right. */
    fun inspecting(tab: InspectorTab): Panels = copy(inspector = tab, front = FrontPart.DETAILS)

    /** Closes the panel at the right. */
    fun withoutInspector(): Panels = copy(inspector = null, front = FrontPart.GRAPHS)
}

/**
 * What the panel at the right shows.
 *
 * @property title what the window calls it.
 * @property icon what stands for it on a button.
 */
internal enum class InspectorTab(val title: String, val icon: ImageVector) {
    EVENTS("Events", Icons.Flag),
    VALUES("Metadata", Icons.Info),
    PROBLEMS("Problems", Icons.Warning),
    STATISTICS("Statistics", Icons.Sigma),
    FINDINGS("Findings", Icons.Diamond),
    NOTES("Notes", Icons.Note),
    CURSOR("Values", Icons.Table),
    VIDEO("Video", Icons.Video),
}

/** What statistics are of. */
internal enum class StatisticsRange {
    /** The selection, or else the visible range. */
    SHOWN,

    /** The time in which the robot was enabled. */
    ENABLED,

    /** All of the log. */
    ALL,
}

/** The parts of the window, of which a narrow one shows one at a time. */
internal enum class FrontPart { LOGS, TOPICS, GRAPHS, DETAILS }

/** What fills the middle of the window. */
internal enum class MainView {
    /** The graphs of the open recording. */
    GRAPHS,

    /** Every log of the folder with all its columns. */
    LOGS,

    /** A statistic of topics across recordings. */
    STATISTICS,
}

/** Which parts of this window are open. */
internal class WindowPanels : Part<Panels>(Panels())
