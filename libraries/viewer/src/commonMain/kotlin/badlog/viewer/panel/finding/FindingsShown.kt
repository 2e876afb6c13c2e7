package badlog.viewer.panel.finding

import badlog.rules.Finding
import badlog.viewer.choices.board.EvidenceOffer
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.panel.LogTimes
import badlog.viewer.panel.PanelRoom
import badlog.viewer.panel.TodoOfLog
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.state.FindingsState

/**
 * The content of the panel of findings.
 *
 * @property found the findings of the rules; null until they have run.
 * @property isRunning whether rules are running.
 * @property state the search.
 * @property visited the place of the finding that a person went to; null if there is none.
 * @property times the times of the log.
 * @property differences the differences between the log and the matches before it.
 * @property topics the topics that can be a signal.
 * @property assigned the topics that a person assigned to signals, by the signal's name.
 * @property todo the team's list; null if there is none.
 * @property details the content below the visited finding; null if the shell shows it elsewhere.
 * @property isComparing whether other logs are drawn, too.
 * @property room the available room.
 * @property unfolded the parts that a person has unfolded, see [ViewerState][badlog.viewer.state.ViewerState].
 */
class FindingsShown(
    val found: RuleResults?,
    val isRunning: Boolean,
    val state: FindingsState,
    val visited: FindingPlace<Finding>?,
    val times: LogTimes,
    val differences: List<Finding> = emptyList(),
    val topics: List<String> = emptyList(),
    val assigned: Map<String, String> = emptyMap(),
    val todo: TodoOfLog? = null,
    val details: FindingDetails? = null,
    val isComparing: Boolean = false,
    val room: PanelRoom = PanelRoom.WHOLE,
    val unfolded: Map<String, Boolean> = emptyMap(),
)

/**
 * The content below the visited finding.
 *
 * @property hasGraphs whether the finding's graphs are shown, and can be kept.
 * @property offers other graphs to show beside it.
 */
class FindingDetails(val hasGraphs: Boolean, val offers: List<EvidenceOffer>)

/**
 * Returns whether a list above graphs has a fixed height, in which it scrolls. The graphs thus stay where they are when the rules have run.
 * A log in which the robot was enabled usually has findings. For a person who [isInside] the list, it is shown in full.
 */
fun PanelRoom.isFixed(hasRules: Boolean, wasEnabled: Boolean, isInside: Boolean): Boolean =
    this == PanelRoom.SHARED && hasRules && wasEnabled && !isInside
