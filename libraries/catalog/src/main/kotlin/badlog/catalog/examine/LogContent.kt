package badlog.catalog.examine

import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.files.LogFile
import badlog.files.ReadOptions
import badlog.files.ReadResult
import badlog.files.orNotRead
import badlog.files.readLog
import badlog.formats.LOG_FORMATS
import badlog.signals.overItsTime
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.withSignals
import badlog.signals.withVirtualTopics

/** The content of a file. */
sealed interface LogContent {
    /**
     * A log.
     *
     * @property recording the content of the file.
     * @property view the content for rules and questions, including virtual topics.
     * @property undefined the virtual topics that cannot be calculated.
     */
    class Log(val recording: Recording, val view: LogView, val undefined: List<UndefinedTopic>) : LogContent

    /**
     * A file without readable content.
     *
     * @property why the reason why the log could not be read.
     */
    class None(val why: ReadResult.NotRead) : LogContent

    companion object {
        /**
         * Reads [file] with [options] and returns the result of [work] on its content. [definitions] defines virtual topics, and may name
         * [signals]. [withX] sets an x axis that the log may lack, and [beside] adds another log to its view. A failure affects only this
         * file: [work] then receives a [None] that describes it.
         *
         * @throws InterruptedException if the thread was interrupted.
         */
        fun <R> examined(
            file: LogFile,
            definitions: List<String>,
            signals: SignalVocabulary,
            withX: (Recording) -> Recording = { it.overItsTime() },
            options: ReadOptions = ReadOptions(cores = 1),
            beside: (LogFile, LogView) -> LogView = { _, view -> view },
            work: (LogContent) -> R,
        ): R = orNotRead(file.path, { work(None(it)) }) {
            work(
                when (val read = readLog(file.path, LOG_FORMATS, options)) {
                    is ReadResult.NotRead -> None(read)

                    is ReadResult.Read -> {
                        val view = LogView.of(withX(read.recording)).withSignals(signals, file.name)
                        val with = beside(file, view).withVirtualTopics(definitions, signals)
                        Log(read.recording, with.view, with.errors.map { UndefinedTopic(it) })
                    }
                },
            )
        }
    }
}
