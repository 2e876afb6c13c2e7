package badlog.cli.command

import badlog.cli.console.Console

/** What a command line asks for, once it is understood. */
internal fun interface Task {
    /** Does it. Whatever goes wrong with the logs is reported and counted, never thrown. */
    fun run(console: Console): ExitCode
}

/**
 * How `badlog` ended, as scripts see it.
 *
 * @property code what the process returns.
 */
public enum class ExitCode(public val code: Int) {
    /** All was done, and every log is whole. */
    WHOLE(0),

    /** Nothing could be done. */
    NOTHING(1),

    /** The arguments make no sense. */
    USAGE(2),

    /** Something was done, but something of the logs is lost or was left out. */
    SALVAGED(3),
}
