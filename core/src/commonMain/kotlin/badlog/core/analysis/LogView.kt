package badlog.core.analysis

import badlog.core.recording.Problem
import badlog.core.recording.Recording
import badlog.core.recording.Severity
import badlog.core.recording.Topic
import badlog.core.recording.Value

/**
 * A recording after its attributes were applied: values, event logs and graphs in the order in which they are shown.
 *
 * @property recording the recording that the view shows.
 * @property title the match, such as `OHCL Qualification 42`, from the event and match values; null if there are
 * none.
 * @property xAxis the common x of its graphs.
 * @property folders the root folder, if it has any content, then the others, sorted regardless of case.
 * @property problems the recording's problems, then the problems of its attributes.
 * @property modes the topics that show when the robot was enabled.
 */
public class LogView internal constructor(
    public val recording: Recording,
    public val title: String?,
    public val xAxis: XAxis,
    public val folders: List<Folder>,
    public val problems: List<Problem>,
    public val modes: ModeTopics = ModeTopics.NONE,
) {
    /** Returns this view with another match [title] and other [modes], the topics that show when the robot was enabled. */
    public fun identified(title: String?, modes: ModeTopics): LogView = LogView(recording, title, xAxis, folders, problems, modes)

    /** Returns [topic], a topic of the recording, as a line of its own, even if no graph shows it. */
    public fun seriesOf(topic: Topic): GraphSeries = seriesOf(topic, xAxis)

    /** Returns the texts of [topic], a topic of the recording, as events, even if they are not shown as a list. */
    public fun eventsOf(topic: Topic): EventLog = EventLog(topic, xAxis)

    /** Returns the number of [problems] with [severity]. */
    public fun count(severity: Severity): Int = problems.count { it.severity == severity }

    public companion object {
        /** Returns the view of [recording] after [registry] has applied its attributes. */
        public fun of(recording: Recording, registry: AttributeRegistry = AttributeRegistry.STANDARD): LogView =
            LogViewBuilder(recording, registry).build()
    }
}

/**
 * The values, event logs and graphs with the same path at the start of their names. They keep the order of the file.
 *
 * @property name the path, without slashes at its ends; empty for the root folder.
 */
public class Folder(
    public val name: String,
    public val values: List<Value>,
    public val eventLogs: List<EventLog>,
    public val graphs: List<Graph>,
)
