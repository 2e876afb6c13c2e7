package badlog.report

import badlog.analysis.LogView
import badlog.file.LogFile
import badlog.file.UnreadableFileException
import badlog.file.readRecording
import badlog.recording.PathName
import badlog.recording.ProblemKind
import badlog.recording.Value

/** What a file turned out to hold. */
internal sealed interface LogContent {
    class Log(val view: LogView) : LogContent

    /** @property isOfFile whether that stays so as long as the file is the same. */
    class None(val message: String, val isOfFile: Boolean) : LogContent

    companion object {
        /** Reads [file]. Never throws for anything about the file. */
        fun of(file: LogFile): LogContent = try {
            val recording = readRecording(file.path)
            val problem = recording.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }
            if (problem != null) None(problem.message, isOfFile = true) else Log(LogView.of(recording))
        } catch (e: UnreadableFileException) {
            None(e.message, isOfFile = false)
        } catch (_: OutOfMemoryError) {
            tooLarge()
        }

        /** That of a file which does not fit into memory. */
        fun tooLarge() = None("There is not enough memory for it; give the program more, or cut the file.", isOfFile = false)
    }
}

/** The type of the match that [values] tell of, such as `Qualification`. */
internal fun matchType(values: List<Value>): String? = values
    .firstOrNull { PathName.baseNameOf(it.name).replace('_', ' ').lowercase() == "match type" && it.text.isNotBlank() }
    ?.text?.trim()
