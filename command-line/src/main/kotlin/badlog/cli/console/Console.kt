package badlog.cli.console

import badlog.cli.text.LINE_WIDTH
import badlog.cli.text.grouped
import badlog.files.terminal.ProgressBar
import badlog.files.terminal.StatusLine
import badlog.files.terminal.printable
import java.io.OutputStream
import java.io.PrintStream
import java.nio.charset.Charset
import java.nio.file.Files
import java.nio.file.Path

/**
 * The output of a subcommand. No text can move a terminal's cursor, characters that the encoding lacks are spelled out, and all lines end
 * alike on all systems. `println` would not change the lines within a text.
 *
 * @param out receives results, for people or programs, in [outCharset].
 * @param err receives errors and progress, in [errCharset].
 * @param isTerminal whether [err] is a terminal, which shows progress.
 * @param outColors the colors of results.
 * @param errColors the colors of errors.
 * @property width the number of columns in a line of results; [UNLIMITED] if no terminal shows them.
 */
internal class Console(
    private val out: PrintStream,
    private val err: PrintStream,
    private val isTerminal: Boolean,
    private val outCharset: Charset = Charsets.UTF_8,
    private val errCharset: Charset = Charsets.UTF_8,
    val width: Int = LINE_WIDTH,
    private val outColors: TerminalColors = TerminalColors.NONE,
    private val errColors: TerminalColors = TerminalColors.NONE,
) {
    private var names = emptyMap<String, String>()
    private val outSpelling = Spelling(outCharset)
    private val errSpelling = Spelling(errCharset)

    /** Returns whether [file] only stands for the standard input or output, and is gone when the program ends. */
    fun isStandIn(file: Path): Boolean = file.toString() in names

    /** Whether results are lost, because their reader has ended or the disk is full. */
    val isOutClosed: Boolean get() = out.checkError()

    /** Prints a result: [text] and a line end. */
    fun say(text: String) {
        out.print(outSpelling.of(cleaned(text)).lines(outColors::result) + LINE_END)
        out.flush()
    }

    /** Prints a remark: [text] and a line end. */
    fun warn(text: String) = err.print(errSpelling.of(cleaned(text)) + LINE_END)

    /** Prints an error: [text] and a line end. */
    fun fail(text: String) = err.print(errSpelling.of(cleaned(text)).lines(errColors::failure) + LINE_END)

    /** Shows the progress of the work on [label], if that takes long. Must be closed. */
    fun progress(label: String): ProgressBar = ProgressBar(errSpelling.of(printable(label)), err, isTerminal)

    /** Returns a line for the state of endless work; null if no terminal would show it. Must be closed. */
    fun status(): StatusLine? = if (isTerminal) StatusLine(err) else null

    /** Shows the number of files searched for logs, if that takes long. Must be closed. */
    fun searching(): SearchCount = SearchCount(err, isTerminal)

    /**
     * Returns the same console with other [names] for some files.
     *
     * @param isOutTaken whether results must not go to the usual output, because that receives a file.
     */
    fun naming(names: Map<String, String>, isOutTaken: Boolean): Console {
        if (names.isEmpty()) return this
        val out = if (isOutTaken) err else out
        val charset = if (isOutTaken) errCharset else outCharset
        val colors = if (isOutTaken) TerminalColors.NONE else outColors
        return Console(out, err, isTerminal, charset, errCharset, width, colors, errColors).also { it.names = names }
    }

    /** The output for bytes of a protocol; nothing else may be printed meanwhile. */
    val bytes: OutputStream get() = out

    /** Returns the same console without results, for intermediate steps. */
    fun withoutResults(): Console = Console(
        PrintStream(OutputStream.nullOutputStream()),
        err,
        isTerminal,
        outCharset,
        errCharset,
        width,
        errColors = errColors,
    ).also { it.names = names }

    /** Writes the bytes of [file] as a result. */
    fun give(file: Path) {
        Files.copy(file, out)
        out.flush()
    }

    /** Lines may end as in CSV. */
    private fun cleaned(text: String) = named(text).split('\n').joinToString("\n") { line ->
        if (line.endsWith('\r')) printable(line.dropLast(1)) + '\r' else printable(line)
    }

    private fun String.lines(color: (String) -> String) = split('\n').joinToString("\n", transform = color)

    /** In JSON, a file has the name that was typed. */
    private fun named(text: String) = names.entries.fold(text) { all, (file, name) ->
        all.replace("\"$file\"", "\"$STAND_IN\"").replace(file, name)
    }

    companion object {
        /** The width of output for other programs. */
        const val UNLIMITED = Int.MAX_VALUE
        private const val LINE_END = "\n"

        /** The argument for the standard input or output. */
        private const val STAND_IN = "-"
    }
}

/**
 * Shows on a terminal the number of files searched for logs, if that takes noticeably long. Closing it leaves no trace.
 *
 * @param patience nanoseconds before it is first shown, and between updates.
 */
internal class SearchCount(err: PrintStream, private val isShown: Boolean, private val patience: Long = 500_000_000L) : AutoCloseable {
    private var shown = System.nanoTime()
    private var files = 0L
    private val line = StatusLine(err)

    fun next() {
        files++
        if (!isShown || System.nanoTime() - shown < patience) return
        shown = System.nanoTime()
        line.show("looking for logs: ${grouped(files)} files")
    }

    override fun close() = line.close()
}
