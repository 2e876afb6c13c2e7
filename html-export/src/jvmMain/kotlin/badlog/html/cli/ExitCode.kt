package badlog.html.cli

/**
 * How `badlog-html` ended, as scripts see it.
 *
 * @property code what the process returns.
 */
internal enum class ExitCode(val code: Int) {
    /** Every input is whole and has its page. */
    WHOLE(0),

    /** There is not one page. */
    NOTHING(1),

    /** The arguments make no sense. */
    USAGE(2),

    /** There are pages, but something of the inputs is lost or has no page. */
    SALVAGED(3),
}
