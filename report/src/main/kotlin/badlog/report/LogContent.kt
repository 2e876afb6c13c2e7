package badlog.report

import badlog.analysis.LogView
import badlog.expression.withVirtualTopics
import badlog.file.LogFile
import badlog.file.UnreadableFileException
import badlog.file.readRecording
import badlog.recording.PathName
import badlog.recording.ProblemKind
import badlog.recording.Recording
import badlog.recording.Value

/** What a file turned out to hold. */
internal sealed interface LogContent {
    /**
     * A log.
     *
     * @property recording what the file holds.
     * @property view what there is to ask, virtual topics too.
     * @property undefined the virtual topics that it cannot be given.
     */
    class Log(val recording: Recording, val view: LogView, val undefined: List<UndefinedTopic>) : LogContent

    /** @property isOfFile whether that stays so as long as the file is the same. */
    class None(val message: String, val isOfFile: Boolean) : LogContent

    companion object {
        /** Reads [file], and adds the topics of [definitions]. Never throws for anything about the file. */
        fun of(file: LogFile, definitions: List<String>): LogContent = try {
            val recording = readRecording(file.path)
            val problem = recording.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }
            if (problem != null) None(problem.message, isOfFile = true) else withVirtualTopics(recording, definitions)
        } catch (e: UnreadableFileException) {
            None(e.message, isOfFile = false)
        } catch (_: OutOfMemoryError) {
            tooLarge()
        }

        /** That of a file which does not fit into memory. */
        fun tooLarge() = None("There is not enough memory for it; give the program more, or cut the file.", isOfFile = false)

        private fun withVirtualTopics(recording: Recording, definitions: List<String>): Log {
            val with = LogView.of(recording).withVirtualTopics(definitions)
            return Log(recording, with.view, with.errors.map { UndefinedTopic(it) })
        }
    }
}

/** The type of the match that [values] tell of, such as `Qualification`. */
internal fun matchType(values: List<Value>): String? = values
    .firstOrNull { PathName.baseNameOf(it.name).replace('_', ' ').lowercase() == "match type" && it.text.isNotBlank() }
    ?.text?.trim()
