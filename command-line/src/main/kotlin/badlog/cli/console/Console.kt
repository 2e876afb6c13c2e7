package badlog.cli.console

import badlog.cli.text.LINE_WIDTH
import badlog.cli.text.grouped
import badlog.terminal.ProgressBar
import badlog.terminal.StatusLine
import badlog.terminal.printable
import java.io.OutputStream
import java.io.PrintStream
import java.nio.charset.Charset
import java.nio.file.Files
import java.nio.file.Path

/**
 * Where a sub-command speaks to. Whatever it says, nothing of it moves a terminal's cursor, and what the encoding has no character for
 * is spelled out.
 *
 * @param out gets results, for people or programs, in [outCharset].
 * @param err gets what went wrong, and progress, in [errCharset].
 * @param isTerminal whether [err] is a terminal, which shows progress.
 * @param outColors the colors of results.
 * @param errColors the colors of what went wrong.
 * @property width how many columns a line of results has; [UNLIMITED] where no terminal shows them.
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

    /** Whether [file] only stands for the standard input or output, and is gone when the program ends. */
    fun isStandIn(file: Path): Boolean = file.toString() in names

    /** Whether results come to nowhere, because nobody reads them any longer or the disk is full. */
    val isOutClosed: Boolean get() = out.checkError()

    /** Prints a result: [text], and the end of the line. */
    fun say(text: String) {
        out.println(outSpelling.of(cleaned(text)).lines(outColors::result))
        out.flush()
    }

    /** Prints what there is to know besides: [text], and the end of the line. */
    fun warn(text: String) = err.println(errSpelling.of(cleaned(text)))

    /** Prints what went wrong: [text], and the end of the line. */
    fun fail(text: String) = err.println(errSpelling.of(cleaned(text)).lines(errColors::failure))

    /** Shows how far the work on [label] is, when that takes long. To be closed. */
    fun progress(label: String): ProgressBar = ProgressBar(errSpelling.of(printable(label)), err, isTerminal)

    /** Shows how many files were looked at for logs, when that takes long. To be closed. */
    fun searching(): SearchCount = SearchCount(err, isTerminal)

    /**
     * The same, calling some files by other [names].
     *
     * @param isOutTaken whether results must not go where they go here, because that gets a file.
     */
    fun naming(names: Map<String, String>, isOutTaken: Boolean): Console {
        if (names.isEmpty()) return this
        val out = if (isOutTaken) err else out
        val charset = if (isOutTaken) errCharset else outCharset
        val colors = if (isOutTaken) TerminalColors.NONE else outColors
        return Console(out, err, isTerminal, charset, errCharset, width, colors, errColors).also { it.names = names }
    }

    /** Where results go as bytes, for a protocol that is spoken there: nothing else may be said meanwhile. */
    val bytes: OutputStream get() = out

    /** The same without results: of work whose result is only a step. */
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

    /** Lines may end as CSV has it. */
    private fun cleaned(text: String) = named(text).split('\n').joinToString("\n") { line ->
        if (line.endsWith('\r')) printable(line.dropLast(1)) + '\r' else printable(line)
    }

    private fun String.lines(color: (String) -> String) = split('\n').joinToString("\n", transform = color)

    private fun named(text: String) = names.entries.fold(text) { all, (file, name) -> all.replace(file, name) }

    companion object {
        /** The width of what another program reads. */
        const val UNLIMITED = Int.MAX_VALUE
    }
}

/**
 * Shows on a terminal how many files were looked at for logs, when that takes long enough to wonder. Closed, it leaves no trace.
 *
 * @param patience nanoseconds for which nothing is shown, and after which it is shown anew.
 */
internal class SearchCount(err: PrintStream, private val isShown: Boolean, private val patience: Long = 500_000_000L) : AutoCloseable {
    private var shown = System.nanoTime()
    private var files = 0L
    private val line = StatusLine(err)

    /** Another file was looked at. */
    fun next() {
        files++
        if (!isShown || System.nanoTime() - shown < patience) return
        shown = System.nanoTime()
        line.show("looking for logs: ${grouped(files)} files")
    }

    override fun close() = line.close()
}
