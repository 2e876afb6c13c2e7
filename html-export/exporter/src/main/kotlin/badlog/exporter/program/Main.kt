package badlog.exporter.program

import badlog.files.terminal.openInBrowser
import kotlin.system.exitProcess

fun main(arguments: Array<String>) {
    // The start script knows this; Java does not before version 22.
    val isTerminal = System.getProperty("badlog.terminal")?.toBoolean() ?: (System.console() != null)
    val program = BadlogHtml(System.out, System.err, isTerminal, open = { openInBrowser(it) })
    exitProcess(program.run(arguments.toList()).code)
}
