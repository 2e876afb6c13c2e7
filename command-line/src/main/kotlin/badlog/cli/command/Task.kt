package badlog.cli.command

import badlog.cli.console.Console

/** The task requested by a command line. */
internal fun interface Task {
    /** Runs it. Problems with logs are reported and counted, never thrown. */
    fun run(console: Console): ExitCode
}

/**
 * The result of `badlog`, for scripts.
 *
 * @property code the exit code of the process.
 */
public enum class ExitCode(public val code: Int) {
    /** Everything was done, and every log is complete. */
    WHOLE(0),

    /** Nothing could be done. */
    NOTHING(1),

    /** The arguments are invalid. */
    USAGE(2),

    /** Something was done, but data of the logs is lost, or some of them were skipped. */
    SALVAGED(3),
}
