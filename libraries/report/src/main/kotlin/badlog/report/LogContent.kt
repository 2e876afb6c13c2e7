package badlog.report

import badlog.core.analysis.LogView
import badlog.core.recording.NumberSinks
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.files.LogFile
import badlog.files.UnreadableFileException
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.withSignals
import badlog.signals.withVirtualTopics

/** The content of a file. */
internal sealed interface LogContent {
    /**
     * A log.
     *
     * @property recording the content of the file.
     * @property view what can be asked about, including virtual topics.
     * @property undefined the virtual topics that cannot be calculated.
     */
    class Log(val recording: Recording, val view: LogView, val undefined: List<UndefinedTopic>) : LogContent

    /**
     * No content to ask about.
     *
     * @property message why, as a sentence.
     * @property isNoLog whether the file is something other than a log, which stays so until it changes.
     */
    class None(val message: String, val isNoLog: Boolean) : LogContent

    companion object {
        private fun of(
            file: LogFile,
            definitions: List<String>,
            signals: SignalVocabulary,
            xTopic: String?,
            sinks: NumberSinks,
            cores: Int,
            beside: (LogFile, LogView) -> LogView,
        ): LogContent = try {
            val recording = readRecording(file.path, LOG_FORMATS, sinks = sinks, cores = cores)
            val problem = recording.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }
            if (problem != null) {
                None(problem.message, isNoLog = true)
            } else {
                withVirtualTopics(
                    if (xTopic == null) recording else recording.withX(xTopic, file.path),
                    definitions,
                    signals,
                ) { beside(file, it) }
            }
        } catch (e: UnreadableFileException) {
            None(e.message, isNoLog = false)
        } catch (e: TopicException) {
            None(e.message, isNoLog = false)
        }

        /**
         * Returns the result of [work] for [file], read on [cores] cores with the topics of [definitions], which may name [signals], and
         * with [xTopic] as x axis unless it is null. [sinks] decides which numbers are needed, and [beside] adds another log to its view.
         * A failure affects only this file: [work] then receives a [None] that describes it.
         *
         * @throws InterruptedException if the thread was interrupted.
         */
        fun <R> examined(
            file: LogFile,
            definitions: List<String>,
            signals: SignalVocabulary,
            xTopic: String? = null,
            sinks: NumberSinks = NumberSinks.RECORDING,
            cores: Int = 1,
            beside: (LogFile, LogView) -> LogView = { _, view -> view },
            work: (LogContent) -> R,
        ): R = try {
            work(of(file, definitions, signals, xTopic, sinks, cores, beside))
        } catch (_: OutOfMemoryError) {
            work(tooLarge())
        } catch (e: InterruptedException) {
            throw e
        } catch (e: Exception) {
            work(failed(e))
        } catch (e: StackOverflowError) {
            work(failed(e))
        }

        private fun failed(e: Throwable) =
            None("This is a bug in badlog ($e); report it, with the file if you may share it.", isNoLog = false)

        private fun tooLarge() =
            None("It is too large for the available memory; give the program more memory, or cut the file.", isNoLog = false)

        private fun withVirtualTopics(
            recording: Recording,
            definitions: List<String>,
            signals: SignalVocabulary,
            beside: (LogView) -> LogView,
        ): Log {
            val with = beside(LogView.of(recording).withSignals(signals)).withVirtualTopics(definitions, signals)
            return Log(recording, with.view, with.errors.map { UndefinedTopic(it) })
        }
    }
}
