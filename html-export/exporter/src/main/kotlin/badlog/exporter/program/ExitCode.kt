package badlog.exporter.program

/**
 * The exit codes of `badlog-html`, for scripts.
 *
 * @property code the exit code of the process.
 */
internal enum class ExitCode(val code: Int) {
    /** Every input is complete and has its page. */
    WHOLE(0),

    /** No page was made. */
    NOTHING(1),

    /** The arguments are invalid. */
    USAGE(2),

    /** Pages were made, but some inputs lost data or have no page. */
    SALVAGED(3),
}
