package badlog.viewer.panel.finding

import badlog.rules.Finding
import badlog.viewer.choices.board.EvidenceOffer
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.panel.LogTimes
import badlog.viewer.shown.finding.FoundInLog
import badlog.viewer.state.FindingsState
import badlog.viewer.todo.TodoList

/**
 * What the panel of findings is made of.
 *
 * @property found what rules found; null before they have run.
 * @property isRunning whether rules are running.
 * @property state what is searched and unfolded.
 * @property visited the place of the finding that a person went to; null for none.
 * @property times the times of the log.
 * @property differences how the log differs from the matches before.
 * @property topics the topics that can be a signal.
 * @property assigned the signals that a person assigned to topics of the log, by name.
 * @property todo the team's list; null where there is none.
 * @property details what is shown below the finding that was gone to; null where the shell shows it elsewhere.
 * @property isComparing whether other logs are drawn, too.
 * @property room how much room there is.
 */
class FindingsShown(
    val found: FoundInLog?,
    val isRunning: Boolean,
    val state: FindingsState,
    val visited: FindingPlace<Finding>?,
    val times: LogTimes,
    val differences: List<Finding> = emptyList(),
    val topics: List<String> = emptyList(),
    val assigned: Map<String, String> = emptyMap(),
    val todo: TodoList? = null,
    val details: FindingDetails? = null,
    val isComparing: Boolean = false,
    val room: FindingsRoom = FindingsRoom.WHOLE,
)

/**
 * What can be shown below the finding that was gone to.
 *
 * @property hasGraphs whether graphs are shown for it that can be kept.
 * @property offers other graphs to show beside it.
 */
class FindingDetails(val hasGraphs: Boolean, val offers: List<EvidenceOffer>)

/** How much room a list of findings has. */
enum class FindingsRoom {
    /** It scrolls by itself, with a search of its own. */
    WHOLE,

    /** It stands above graphs, which should stay in sight. */
    SHARED,

    /** It stands above graphs on a phone. */
    NARROW,
}
