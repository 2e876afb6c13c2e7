package badlog.files.terminal

import java.io.PrintStream

/** One line of the terminal [err] that is rewritten repeatedly. Closing it removes it. */
public class StatusLine(private val err: PrintStream) : AutoCloseable {
    private var width = 0

    /** Replaces the line with [text], which must have no line break. */
    public fun show(text: String) {
        err.print("\r" + text.padEnd(width))
        err.flush()
        width = text.length
    }

    override fun close() {
        if (width > 0) err.print("\r" + " ".repeat(width) + "\r")
        err.flush()
    }
}
