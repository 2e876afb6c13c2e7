package badlog.formats.driverstation

import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.formats.wpilog.Entry
import badlog.formats.wpilog.WpilogFormat

/**
 * Whether this is a log of the Driver Station. Until 2026 such a log has a format of its own; from 2027 on it is a WPILOG with nothing else
 * in it.
 */
public val Recording.isOfDriverStation: Boolean
    get() = format == DriverStationFormat ||
        (format == WpilogFormat && topics.any { it.name.startsWith(STATION_TOPIC) } && topics.all(::isOfStation))

private fun isOfStation(topic: Topic) =
    topic.name.startsWith(STATION_TOPIC) || Entry.SCHEMA_FOLDER in topic.name || topic.name == "systemTime" || topic.name == "messages"

/** The beginning of its topics' names from 2027 on; a robot's topics, such as `DS:controlWord`, have no slash. */
private const val STATION_TOPIC = "DS:/"
