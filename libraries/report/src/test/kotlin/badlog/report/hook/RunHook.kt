package badlog.report.hook

import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import java.nio.file.Path

/** A program of its own that runs a hook, so that a test can end it. Its arguments: a log, and the hook's command. */
fun main(arguments: Array<String>) {
    HookRunner(arguments.drop(1)).run(readRecording(Path.of(arguments[0]), LOG_FORMATS))
}
