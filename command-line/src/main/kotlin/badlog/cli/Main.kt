package badlog.cli

import kotlin.system.exitProcess

/** The program `badlog`. */
fun main(arguments: Array<String>) {
    // The start script can ask for it; Java could not until version 22.
    val isTerminal = System.getProperty("badlog.terminal")?.toBoolean() ?: (System.console() != null)
    val code = Badlog(Console(System.out, System.err, isTerminal)).run(arguments.toList()).code
    System.out.flush()
    exitProcess(code)
}
