package badlog.report

import badlog.analysis.LogView
import badlog.file.LogFile
import badlog.file.UnreadableFileException
import badlog.file.readRecording
import badlog.formats.LOG_FORMATS
import badlog.recording.NumberSinks
import badlog.recording.ProblemKind
import badlog.recording.Recording
import badlog.rules.signal.SignalVocabulary
import badlog.rules.withSignals
import badlog.rules.withVirtualTopics

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

    /**
     * Nothing to ask.
     *
     * @property message why, as a sentence.
     * @property isNoLog whether the file is something else than a log, which stays so as long as it is the same.
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
                    if (xTopic ==
                        null
                    ) {
                        recording
                    } else {
                        recording.withX(xTopic, file.path)
                    },
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
         * What [work] makes of [file], read on [cores] cores with the topics of [definitions], which may name [signals], and with [xTopic]
         * as x axis if it is not null; [sinks] says which numbers are needed, and [beside] puts another log beside its view.
         * Whatever fails, fails for this file alone: [work] is then given a [None] that says so.
         *
         * @throws InterruptedException when the thread was interrupted.
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
