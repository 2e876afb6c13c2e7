package badlog.season.lake

import badlog.core.analysis.LogView
import badlog.files.unwritable
import badlog.season.engine.Engine
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.withSignals
import java.io.IOException
import java.nio.file.Path
import java.sql.SQLException
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * A written Parquet file.
 *
 * @property rows the number of its rows.
 */
class ParquetFile internal constructor(val path: Path, val rows: Long)

/** Writes single logs as Parquet files with the same columns as in a [Lake], specified in `docs/season.md`. Thread-safe. */
class ParquetWriter : AutoCloseable {
    private val engine = Engine(Engine.WRITING_MEGABYTES, threads = 1)
    private val turn = ReentrantLock()

    /**
     * Writes the samples of [view] to [target], atomically. If some topics share rows and others have times of their own, the latter are
     * written to a second file: `match.series.parquet` beside `match.parquet`.
     *
     * @param log the value of the column `log`.
     * @param file the name of the log's file, which may show its match and its time.
     * @param signals the names of topics in different logs.
     * @return the written files; empty if the log has no samples.
     * @throws LakeException if a file cannot be written.
     */
    fun write(view: LogView, log: String, file: String, signals: SignalVocabulary, target: Path): List<ParquetFile> = try {
        // Stopping DuckDB would leave a draft.
        engine.finishing({ turn.withLock {} }) { turn.withLock { written(view, log, file, signals, target) } }
    } catch (e: SQLException) {
        throw LakeException("$target cannot be written (${e.message}); make room on the disk, or name another file.", e)
    } catch (e: IOException) {
        throw LakeException(unwritable(target, e).message, e)
    }

    private fun written(view: LogView, log: String, file: String, signals: SignalVocabulary, target: Path): List<ParquetFile> {
        val tables = LogTables(view.withSignals(signals, file), log, LogIdentity.of(file, view.recording, signals))
        val samples = tables.samples
        val series = tables.series
        val path = target.toAbsolutePath()
        val ofSeries = if (samples == null) path else path.resolveSibling(path.fileName.toString().removeSuffix(LakeLayout.ENDING) + SERIES)
        return listOfNotNull(samples?.let { it to path }, series?.let { it to ofSeries })
            .map { (table, file) -> ParquetFile(file, tables.write(table, file, engine)) }
    }

    override fun close(): Unit = engine.close()
}

private const val SERIES = ".series.parquet"
