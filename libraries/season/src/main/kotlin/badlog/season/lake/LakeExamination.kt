package badlog.season.lake

import badlog.analysis.LogView
import badlog.file.LogFile
import badlog.file.UnreadableFileException
import badlog.file.readRecording
import badlog.formats.LOG_FORMATS
import badlog.recording.ProblemKind
import badlog.rules.Finding
import badlog.rules.LogShape
import badlog.rules.RuleProgram
import badlog.rules.RuleSet
import badlog.rules.withSignals
import java.sql.SQLException
import java.util.concurrent.ConcurrentHashMap

/** What a file turned out to be, when a lake wanted it. */
internal sealed interface ExaminedLog {
    /** A log, which is in the lake now. */
    class Written(val isSalvaged: Boolean) : ExaminedLog

    /** Something else than a log, or one that cannot be read; [message] says why. */
    class None(val message: String, val isNoLog: Boolean) : ExaminedLog
}

/** Reads logs and runs [rules] over them. Safe for several threads. */
internal class LakeExamination(private val rules: RuleSet) {
    private val programs = ConcurrentHashMap<LogShape, RuleProgram>()

    /** Gives [file], read on [cores] cores, with what the rules find in it, to [write]; whatever fails, fails for this file alone. */
    fun of(file: LogFile, cores: Int, write: (LogView, List<Finding>) -> Unit): ExaminedLog = try {
        val recording = readRecording(file.path, LOG_FORMATS, cores = cores)
        val problem = recording.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }
        if (problem != null) {
            ExaminedLog.None(problem.message, isNoLog = true)
        } else {
            val view = LogView.of(recording).withSignals(rules.signals)
            write(view, programFor(view).run(view, file.name).flatMap { it.findings }.toList())
            ExaminedLog.Written(recording.isSalvaged)
        }
    } catch (e: UnreadableFileException) {
        ExaminedLog.None(e.message, isNoLog = false)
    } catch (e: SQLException) {
        // A full disk concerns all logs.
        if (IO_ERROR in e.message.orEmpty()) throw e
        ExaminedLog.None("This is a bug in badlog (${e.message}); report it, with the file if you may share it.", isNoLog = false)
    } catch (_: OutOfMemoryError) {
        ExaminedLog.None("It is too large for the available memory; give the program more memory, or cut the file.", isNoLog = false)
    }

    private fun programFor(view: LogView): RuleProgram {
        if (programs.size > MAX_PROGRAMS) programs.clear()
        return programs.computeIfAbsent(LogShape.of(view)) { RuleProgram(rules, it) }
    }

    private companion object {
        const val MAX_PROGRAMS = 64
        const val IO_ERROR = "IO Error"
    }
}
