package badlog.cli

import badlog.html.cli.ProgressBar
import java.io.PrintStream

/**
 * Where a sub-command speaks to.
 *
 * @property out gets results, for people or programs.
 * @property err gets what went wrong, and progress.
 * @property isTerminal whether [err] is a terminal, which shows progress.
 */
internal class Console(val out: PrintStream, val err: PrintStream, val isTerminal: Boolean) {
    /** Shows how far the work on [label] is, when that takes long. To be closed. */
    fun progress(label: String): ProgressBar = ProgressBar(label, err, isTerminal)
}
