package badlog.page.browser

import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** Returns the path of the program [name] in PATH; null if there is none. */
internal fun onPath(name: String): Path? = System.getenv("PATH").orEmpty().split(File.pathSeparator).filter { it.isNotEmpty() }.map { Path.of(it, name) }.firstOrNull(Files::isExecutable)

/** Returns a builder that starts a program of the PATH. */
internal fun program(name: String, vararg arguments: String): ProcessBuilder {
    val file = checkNotNull(onPath(name)) { "BADLOG_BROWSER=required, but $name is not on the PATH." }
    return ProcessBuilder("$file", *arguments).redirectOutput(ProcessBuilder.Redirect.DISCARD)
}

/** Ends this process with all processes that it started. */
internal fun Process.end() {
    descendants().forEach(ProcessHandle::destroy)
    destroy()
    if (!waitFor(SECONDS_TO_END, TimeUnit.SECONDS)) destroyForcibly()
}

private const val SECONDS_TO_END = 10L
