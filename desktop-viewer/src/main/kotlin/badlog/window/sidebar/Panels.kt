package badlog.window.sidebar

import androidx.compose.ui.graphics.vector.ImageVector
import badlog.viewer.state.Form
import badlog.window.state.StateHolder
import badlog.window.theme.Icons

/**
 * The open parts of the window. Immutable; each transition returns a new one.
 *
 * @property library whether the list of logs is open on the left.
 * @property topics whether the topics are open beside it, see [showsTopics].
 * @property keepsTopics whether they stay beside [inspector] even if both leave the graphs little room, because a person has opened them
 * there.
 * @property inspector the panel on the right, or null for none.
 * @property main the content of the middle.
 * @property front the visible part, if the window is too narrow for more than one.
 * @property help whether the help is open above everything.
 * @property form the form that is open above everything; null for none.
 * @property hidden the panels that were open beside the graphs before a key hid them; null if none are hidden.
 */
internal data class Panels(
    val library: Boolean = true,
    val topics: Boolean = true,
    val keepsTopics: Boolean = false,
    val inspector: InspectorTab? = null,
    val main: MainView = MainView.GRAPHS,
    val front: FrontPart = FrontPart.GRAPHS,
    val help: Boolean = false,
    val form: Form? = null,
    val hidden: Panels? = null,
) {
    /** Shows [view] in the middle, or the graphs if it is already shown. */
    fun toggled(view: MainView): Panels = copy(main = if (main == view) MainView.GRAPHS else view)

    /**
     * Returns whether the topics are visible beside the graphs. While a panel is open on the right, they are folded in a window that is not
     * [isRoomy], unless a person has opened them there.
     */
    fun showsTopics(isRoomy: Boolean): Boolean = topics && (isRoomy || inspector == null || keepsTopics)

    /** Shows the topics, also beside the panel on the right. */
    fun withTopics(): Panels = copy(topics = true, keepsTopics = inspector != null)

    /** Hides everything beside the graphs, or restores the hidden panels. */
    fun graphsAlone(): Panels = if (library || topics || inspector != null) {
        copy(
            library = false,
            topics = false,
            keepsTopics = false,
            inspector = null,
            main = MainView.GRAPHS,
            front = FrontPart.GRAPHS,
            hidden = if (library || topics || hidden == null) copy(hidden = null) else hidden,
        )
    } else {
        copy(
            library = hidden?.library ?: true,
            topics = hidden?.topics ?: true,
            keepsTopics = hidden?.keepsTopics == true,
            inspector = hidden?.inspector,
            hidden = null,
        )
    }

    /**
     * Shows the log that a person has opened in the list, instead of statistics across logs. The list is also visible beside the
     * statistics.
     */
    fun showingLog(): Panels = if (main == MainView.STATISTICS) copy(main = MainView.GRAPHS, front = FrontPart.GRAPHS) else this

    /** Opens [tab] on the right, or closes it if it is open. */
    fun toggled(tab: InspectorTab): Panels = if (inspector == tab) withoutInspector() else inspecting(tab)

    /** Shows [tab] on the right. */
    fun inspecting(tab: InspectorTab): Panels = copy(inspector = tab, front = FrontPart.DETAILS)

    /** Closes the panel on the right. */
    fun withoutInspector(): Panels = copy(inspector = null, keepsTopics = false, front = FrontPart.GRAPHS)
}

/**
 * The tabs of the panel on the right.
 *
 * @property title its label.
 * @property icon its icon on a button.
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
    MODULES("Modules", Icons.Wheels),
}

/** The parts of the window; a narrow window shows one at a time. */
internal enum class FrontPart { LOGS, TOPICS, GRAPHS, DETAILS }

/** The content of the middle of the window. */
internal enum class MainView {
    /** The graphs of the open recording. */
    GRAPHS,

    /** Every log of the folder with all its columns. */
    LOGS,

    /** A statistic of topics across recordings. */
    STATISTICS,

    /** Charts of the folder's logs. */
    CHARTS,

    /** The last log and the ones before it, in large letters. */
    PIT,

    /** The team's batteries over the folder's logs. */
    BATTERIES,

    /** The team's to-do list. */
    TODO,
}

/** The open parts of this window. */
internal class WindowPanels : StateHolder<Panels>(Panels())
