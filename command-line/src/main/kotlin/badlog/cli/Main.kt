package badlog.cli

import badlog.cli.command.ExitCode
import badlog.cli.console.Console
import badlog.cli.console.ResultStream
import badlog.cli.console.TerminalColors
import badlog.cli.text.LINE_WIDTH
import java.io.FileDescriptor
import java.io.FileOutputStream
import java.io.PrintStream
import java.nio.charset.Charset
import kotlin.system.exitProcess

fun main(arguments: Array<String>) {
    // The start script can find this out; Java cannot before version 22.
    val isTerminal = System.getProperty("badlog.terminal")?.toBoolean() ?: (System.console() != null)
    val results = ResultStream(FileOutputStream(FileDescriptor.out))
    val charset = charsetOf("stdout")
    val width = width()
    val console = Console(
        PrintStream(results, false, charset),
        System.err,
        isTerminal,
        charset,
        charsetOf("stderr"),
        width,
        TerminalColors.of(isTerminal = width != Console.UNLIMITED),
        TerminalColors.of(isTerminal),
    )
    val code = Badlog(console).run(arguments.toList())
    exitProcess(if (console.isOutClosed) afterLoss(console, results).code else code.code)
}

// The start script knows the width of the terminal, and passes 0 if there is none.
private fun width(): Int = when (val columns = System.getProperty("badlog.columns")?.toIntOrNull()) {
    null -> if (System.console() != null) LINE_WIDTH else Console.UNLIMITED
    0 -> Console.UNLIMITED
    else -> maxOf(columns, MIN_WIDTH)
}

/** In less, tables would show nothing. */
private const val MIN_WIDTH = 60

private fun afterLoss(console: Console, results: ResultStream): ExitCode {
    // A reader that only wanted the first line needs no message.
    if (!results.isReaderGone) console.warn("The results cannot be written (${results.failure?.message}); check whether the disk is full.")
    return ExitCode.NOTHING
}

/** Returns the character set of the system's stream [name]; Java used another property until version 19. */
private fun charsetOf(name: String): Charset {
    val encoding = System.getProperty("$name.encoding") ?: System.getProperty("sun.$name.encoding") ?: System.getProperty("native.encoding")
    val charset = if (encoding != null && Charset.isSupported(encoding)) Charset.forName(encoding) else Charset.defaultCharset()
    return if (charset.canEncode()) charset else Charsets.US_ASCII
}
