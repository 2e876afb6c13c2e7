package badlog.terminal

import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** Shows [page] in the default browser. False when the system's program for that is missing or fails at once. */
public fun openInBrowser(page: Path): Boolean = startProgram(browserCommand() + page.toAbsolutePath().toUri().toString())

/** The system's own command that shows an address in the default browser; the address comes behind it. */
public fun browserCommand(system: String = System.getProperty("os.name")): List<String> = when {
    system.startsWith("Windows") -> listOf("rundll32", "url.dll,FileProtocolHandler")
    system.startsWith("Mac") || system.startsWith("Darwin") -> listOf("open")
    else -> listOf("xdg-open")
}

/** Starts [command], whose window stays when this program ends. False when it is missing or fails at once. */
public fun startProgram(command: List<String>): Boolean = try {
    val process = ProcessBuilder(command)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start()
    // Some run as long as their window is open; that one has started is all there is to know.
    !process.waitFor(1, TimeUnit.SECONDS) || process.exitValue() == 0
} catch (_: IOException) {
    false
}
