package badlog.analysis

import badlog.recording.Problem
import badlog.recording.Recording
import badlog.recording.Severity
import badlog.recording.Topic
import badlog.recording.Value

/**
 * A recording after its attributes were applied: what a front end shows, in the order in which it shows it.
 *
 * @property recording what it was made from.
 * @property title what match it is, from the event and match values, or null without any.
 * @property xAxis the common x of its graphs.
 * @property folders the root folder first, if it has anything, then the others, sorted regardless of case.
 * @property problems the recording's problems, then those of its attributes.
 * @property modes the topics that tell when the robot was enabled.
 */
public class LogView internal constructor(
    public val recording: Recording,
    public val title: String?,
    public val xAxis: XAxis,
    public val folders: List<Folder>,
    public val problems: List<Problem>,
    public val modes: ModeTopics = ModeTopics.NONE,
) {
    /** This view of the match [title], in which [modes] tell when the robot was enabled. */
    public fun identified(title: String?, modes: ModeTopics): LogView = LogView(recording, title, xAxis, folders, problems, modes)

    /** The line that [topic], one of the recording's, gives by itself, whether or not a graph shows it. */
    public fun seriesOf(topic: Topic): GraphSeries = seriesOf(topic, xAxis)

    /** The texts of [topic], one of the recording's, as events, whether or not they are shown as a list. */
    public fun eventsOf(topic: Topic): EventLog = EventLog(topic, xAxis)

    /** How many of [problems] are of each severity. */
    public fun count(severity: Severity): Int = problems.count { it.severity == severity }

    public companion object {
        /** Applies the attributes of [recording] as [registry] understands them. */
        public fun of(recording: Recording, registry: AttributeRegistry = AttributeRegistry.STANDARD): LogView =
            LogViewBuilder(recording, registry).build()
    }
}

/**
 * What belongs together: all whose names begin with the same path. Members keep the order of the file.
 *
 * @property name the path, without slashes at its ends; empty for the root folder.
 */
public class Folder(
    public val name: String,
    public val values: List<Value>,
    public val eventLogs: List<EventLog>,
    public val graphs: List<Graph>,
)
