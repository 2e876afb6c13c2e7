package badlog.cli.input

import badlog.file.LogFile
import java.io.IOException
import java.io.PrintStream
import java.nio.file.Path

/** The logs below [paths], as they are now; says on [err] what cannot be looked at. */
internal fun logFiles(paths: List<Path>, err: PrintStream): List<LogFile> {
    val found = LogSearch().find(paths)
    for (failure in found.failures) err.println(failure.message)
    return found.inputs.mapNotNull { input ->
        try {
            LogFile.of(input.file)
        } catch (_: IOException) {
            err.println("There is no file ${input.file}; look for a typing error in its name.")
            null
        }
    }
}
