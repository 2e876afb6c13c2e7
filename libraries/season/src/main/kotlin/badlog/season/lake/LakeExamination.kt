package badlog.season.lake

import badlog.core.analysis.LogView
import badlog.files.LogMaker
import badlog.files.ReadOptions
import badlog.files.ReadResult
import badlog.files.orNotRead
import badlog.files.readLog
import badlog.formats.LOG_FORMATS
import badlog.rules.Finding
import badlog.rules.RuleProgram
import badlog.rules.RuleSet
import badlog.rules.toJson
import badlog.season.engine.Engine
import badlog.signals.ShapeCache
import badlog.signals.withSignals
import java.nio.file.Path
import java.sql.SQLException
import java.util.zip.CRC32

/** The result of examining a file for a lake. */
sealed interface ExaminedLog {
    /** A log with its files written to the folder; [entry] is for the tables. */
    class Written internal constructor(val entry: LakeEntry) : ExaminedLog

    /** Something other than a log, or a log that cannot be read; [message] says why. */
    class None internal constructor(val message: String, val isNoLog: Boolean) : ExaminedLog
}

/**
 * Reads logs, runs [rules] over them, and writes the files of single logs with [engine] if [hasSamples]. Thread-safe.
 *
 * @param matches makes one log from a file with the logs of a match; null if such files are not read.
 */
internal class LakeExamination(
    private val rules: RuleSet,
    private val engine: Engine,
    private val hasSamples: Boolean = true,
    private val matches: LogMaker? = null,
) {
    private val programs = ShapeCache(MAX_PROGRAMS) { RuleProgram(rules, it) }

    /** Identifies everything that affects the records of a log, besides its file. */
    val maker: String = "${LakeLayout.VERSION}-${CRC32().apply { update(rules.toJson().encodeToByteArray()) }.value.toString(HEX)}" +
        if (hasSamples) "" else WITHOUT_SAMPLES

    /**
     * Reads [file] on [cores] cores, and writes its files into [folder] under the name [log]. [file] is the log [source] or a copy of it. A
     * failure concerns only this log, unless the disk is full.
     */
    fun write(file: Path, cores: Int, source: LogSource, log: String, folder: Path): ExaminedLog =
        orNotRead(file, { Result.success(ExaminedLog.None(it.message, it.isLasting)) }) {
            when (val read = readLog(file, LOG_FORMATS, ReadOptions(cores = cores, name = source.file, maker = matches))) {
                is ReadResult.NotRead -> Result.success(ExaminedLog.None(read.message, read.isLasting))

                is ReadResult.Read -> {
                    val view = LogView.of(read.recording).withSignals(rules.signals, source.file)
                    val findings = programs[view].run(view, source.file).flatMap { it.findings }.toList()
                    unlessDiskIsFull { ExaminedLog.Written(write(view, findings, source, log, folder)) }
                }
            }
        }.getOrThrow()

    /** Runs [write]; a full disk concerns all logs, so its exception is passed on. */
    private fun unlessDiskIsFull(write: () -> ExaminedLog): Result<ExaminedLog> = try {
        Result.success(write())
    } catch (e: SQLException) {
        if (IO_ERROR in e.message.orEmpty()) Result.failure(e) else throw e
    }

    private fun write(view: LogView, findings: List<Finding>, source: LogSource, log: String, folder: Path): LakeEntry {
        val identity = LogIdentity.of(source.file, view.recording, rules.signals)
        val tables = if (hasSamples) LogTables(view, log, identity) else null
        val targets = listOfNotNull(
            tables?.samples?.let { LakeLayout.logFile(LakeLayout.SAMPLES, identity.partition, log) to it },
            tables?.series?.let { LakeLayout.logFile(LakeLayout.SERIES, identity.partition, log) to it },
        )
        for ((target, table) in targets) tables?.write(table, folder.resolve(target), engine)
        val files = targets.map { it.first }
        val records = LogRecords(log, source, view, findings, identity, tables?.columnOf.orEmpty(), files, maker)
        return LakeEntry(log, identity.partition, files, view.recording.isSalvaged, records.all)
    }
}

private const val MAX_PROGRAMS = 64
private const val IO_ERROR = "IO Error"
private const val HEX = 16
private const val WITHOUT_SAMPLES = "-without-samples"
