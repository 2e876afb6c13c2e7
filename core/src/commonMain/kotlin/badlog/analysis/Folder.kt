package badlog.analysis

import badlog.recording.Value

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
