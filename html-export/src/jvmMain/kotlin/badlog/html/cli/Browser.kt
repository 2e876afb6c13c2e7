package badlog.html.cli

import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** Shows [page] in the default browser. False when the system's program for that is missing or fails at once. */
internal fun openInBrowser(page: Path): Boolean {
    val system = System.getProperty("os.name").lowercase()
    val address = page.toAbsolutePath().toUri().toString()
    val command = when {
        "win" in system && "darwin" !in system -> listOf("rundll32", "url.dll,FileProtocolHandler", address)
        "mac" in system || "darwin" in system -> listOf("open", address)
        else -> listOf("xdg-open", address)
    }
    return try {
        val process = ProcessBuilder(command)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start()
        // Some run as long as the browser does; that one is there is all there is to know.
        !process.waitFor(1, TimeUnit.SECONDS) || process.exitValue() == 0
    } catch (_: IOException) {
        false
    }
}
