package badlog.files.terminal

import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** Opens [page] in the default browser. Returns false if the system's program for that is missing or fails at once. */
public fun openInBrowser(page: Path): Boolean = startProgram(browserCommand() + page.toAbsolutePath().toUri().toString())

/** Returns the system's own command that shows an address in the default browser. Append the address to it. */
public fun browserCommand(system: String = System.getProperty("os.name")): List<String> = when {
    system.startsWith("Windows") -> listOf("rundll32", "url.dll,FileProtocolHandler")
    system.startsWith("Mac") || system.startsWith("Darwin") -> listOf("open")
    else -> listOf("xdg-open")
}

/** Starts [command]; its window stays open when this program ends. Returns false if it is missing or fails at once. */
public fun startProgram(command: List<String>): Boolean = try {
    val process = ProcessBuilder(command)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start()
    // Some run until their window is closed, so only their start can be checked.
    !process.waitFor(1, TimeUnit.SECONDS) || process.exitValue() == 0
} catch (_: IOException) {
    false
}
