package badlog.core.conformance

import badlog.core.recording.TopicKind

/*
 * The small robot log that most cases damage: a time, a mode that is a text, and a voltage. Line 3 is its first row.
 */
internal const val DRIVE_TITLES = "Time,Mode,Volts\n"
internal const val DRIVE_JSON =
    """{"topics":[{"name":"Time","unit":"s","attrs":[]},{"name":"Mode","unit":"ul","attrs":[]},""" +
        """{"name":"Volts","unit":"V","attrs":[]}],"values":[]}"""
internal const val DRIVE = "$DRIVE_JSON\n$DRIVE_TITLES"

internal fun time(vararg cells: Any?) = topic("Time", "s", cells = cells.asList())

internal fun mode(vararg cells: Any?) = topic("Mode", kind = TopicKind.STATE, cells = cells.asList())

internal fun volts(vararg cells: Any?) = topic("Volts", "V", cells = cells.asList())

/** Two numeric topics. Line 3 is the first row. */
internal const val POWER =
    """{"topics":[{"name":"Time","unit":"s","attrs":[]},{"name":"Volts","unit":"V","attrs":[]}],"values":[]}""" +
        "\nTime,Volts\n"

/** [count] NUL bytes. */
internal fun nuls(count: Int): String = "\u0000".repeat(count)
