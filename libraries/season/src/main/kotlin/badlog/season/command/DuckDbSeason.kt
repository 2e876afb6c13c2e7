package badlog.season.command

import badlog.cli.plugin.LakeReport
import badlog.cli.plugin.LakeState
import badlog.cli.plugin.ParquetSession
import badlog.cli.plugin.SeasonException
import badlog.cli.plugin.SeasonService
import badlog.cli.plugin.SqlColumn
import badlog.cli.plugin.SqlSession
import badlog.cli.plugin.SqlTable
import badlog.cli.plugin.WrongQueryException
import badlog.core.analysis.LogView
import badlog.files.LogFile
import badlog.files.LogMaker
import badlog.rules.RuleSet
import badlog.season.engine.NoEngineException
import badlog.season.lake.Lake
import badlog.season.lake.LakeException
import badlog.season.lake.LakeLog
import badlog.season.lake.ParquetWriter
import badlog.season.sql.LakeDatabase
import badlog.season.sql.SqlException
import badlog.signals.vocabulary.SignalVocabulary
import kotlinx.serialization.json.JsonElement
import java.nio.file.Path

/** Provides the program with lakes, through DuckDB. */
public class DuckDbSeason : SeasonService {
    override val layoutVersion: Int get() = Lake.LAYOUT_VERSION

    override fun isLake(folder: Path): Boolean = Lake.isLake(folder)

    override fun refresh(
        lake: Path,
        logs: List<Pair<LogFile, String>>,
        roots: List<Path>,
        rules: RuleSet,
        matches: LogMaker?,
        isBusy: () -> Boolean,
        progress: (done: Int, total: Int) -> Unit,
    ): LakeReport = failing {
        val result = Lake(lake).refresh(
            logs.map { (file, name) ->
                LakeLog(file, name)
            },
            roots,
            rules,
            matches = matches,
            isBusy = isBusy,
            progress = progress,
        )
        LakeReport(result.outcomes.map { LakeState(it.message, it.isNoLog, it.isSalvaged, it.isWritten) }, result.removed)
    }

    override fun open(lake: Path, output: Path?, isConfined: Boolean): SqlSession =
        failing { DuckDbSession(LakeDatabase.open(Lake(lake), output, isConfined)) }

    override fun parquet(): ParquetSession = failing { DuckDbParquet(ParquetWriter()) }
}

private class DuckDbParquet(private val writer: ParquetWriter) : ParquetSession {
    override fun write(view: LogView, log: String, file: String, signals: SignalVocabulary, target: Path): List<Pair<Path, Long>> =
        failing { writer.write(view, log, file, signals, target).map { it.path to it.rows } }

    override fun close() = writer.close()
}

private class DuckDbSession(private val database: LakeDatabase) : SqlSession {
    override fun query(sql: String, columns: (List<SqlColumn>) -> Unit, row: (List<JsonElement>) -> Boolean) =
        failing { database.query(sql, { columns(it.map(::columnOf)) }, row) }

    override fun write(sql: String): Long = failing { database.writeParquet(sql) }

    override fun tables(): List<SqlTable> = failing { database.tables().map { SqlTable(it.name, it.meaning, it.columns.map(::columnOf)) } }

    override fun cancel() = database.cancel()

    override fun close() = database.close()
}

private fun columnOf(column: badlog.season.sql.SqlColumn) = SqlColumn(column.name, column.type, column.isNumeric)

private fun <R> failing(work: () -> R): R = try {
    work()
} catch (e: LakeException) {
    throw SeasonException(e.message)
} catch (e: SqlException) {
    throw if (e.isMistake) WrongQueryException(e.message) else SeasonException(e.message)
} catch (e: NoEngineException) {
    throw SeasonException(e.message)
}
