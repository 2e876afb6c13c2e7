package badlog.cli.plugin

import badlog.core.analysis.LogView
import badlog.files.LogFile
import badlog.files.LogMaker
import badlog.rules.RuleSet
import badlog.signals.vocabulary.SignalVocabulary
import kotlinx.serialization.json.JsonElement
import java.nio.file.Path

/**
 * Folders of logs as tables, for `badlog lake`, `badlog sql`, `badlog convert --to parquet` and the assistant's tool `sql`. Each function
 * throws [SeasonException] if it fails.
 */
public interface SeasonService {
    /** The version of the file layout of lakes, the folders that hold logs as tables. */
    public val layoutVersion: Int

    /** Returns whether [folder] is a lake. */
    public fun isLake(folder: Path): Boolean

    /**
     * Updates the lake [lake] to [logs], each with its name there. Other logs below [roots] are removed from it.
     *
     * @param matches makes one log from a file with the logs of a match; null if such files are not read.
     * @param isBusy called from time to time while another badlog writes to that lake; returns whether to wait until it has finished.
     * @param progress called with the number of changed logs that are done. An exception from it stops the work and is passed on.
     */
    public fun refresh(
        lake: Path,
        logs: List<Pair<LogFile, String>>,
        roots: List<Path>,
        rules: RuleSet,
        matches: LogMaker?,
        isBusy: () -> Boolean,
        progress: (done: Int, total: Int) -> Unit,
    ): LakeReport

    /**
     * Opens [lake] for queries. Answers can also be written to the Parquet file [output], if it is not null.
     *
     * @param isConfined whether queries may read nothing but the tables, so that they do not reveal where files are.
     */
    public fun open(lake: Path, output: Path?, isConfined: Boolean = false): SqlSession

    /** Begins to write logs as Parquet files. */
    public fun parquet(): ParquetSession
}

/** Writes logs as Parquet files, see [SeasonService.parquet]. */
public interface ParquetSession : AutoCloseable {
    /**
     * Writes the samples of [view] to [target]. If some topics share rows and others have times of their own, the latter go to a second file
     * beside it.
     *
     * @param log the content of the column `log`.
     * @param file the name of the log's file.
     * @param signals the names of topics, such as those that identify match and time.
     * @return each file and its number of rows; empty if the log has no samples.
     */
    public fun write(view: LogView, log: String, file: String, signals: SignalVocabulary, target: Path): List<Pair<Path, Long>>
}

/** Thrown if something cannot be done with a lake. The message is for the user. */
public open class SeasonException(override val message: String) : Exception(message)

/** Thrown if a query is wrong. */
public class WrongQueryException(message: String) : SeasonException(message)

/**
 * The result of updating a lake.
 *
 * @property logs the result for each log, in order.
 * @property removed the number of logs that were removed because their files are gone.
 */
public class LakeReport(public val logs: List<LakeState>, public val removed: Int)

/**
 * The result for a log in a lake.
 *
 * @property message the reason why it was not added, as a sentence; null if it was.
 * @property isNoLog whether it is something other than a log.
 * @property isSalvaged whether some of its data is lost.
 * @property isWritten whether it was written; otherwise it was already in the lake.
 */
public class LakeState(
    public val message: String?,
    public val isNoLog: Boolean,
    public val isSalvaged: Boolean,
    public val isWritten: Boolean,
)

/** A lake that answers queries, see [SeasonService.open]. */
public interface SqlSession : AutoCloseable {
    /** Answers [sql]: passes its columns to [columns], then each row to [row], until that returns false. */
    public fun query(sql: String, columns: (List<SqlColumn>) -> Unit, row: (List<JsonElement>) -> Boolean)

    /** Writes the answer to [sql] to the file given to [SeasonService.open]. Returns the number of rows. */
    public fun write(sql: String): Long

    /** Returns the tables that queries can use. */
    public fun tables(): List<SqlTable>

    /** Cancels the query that is running on another thread; the query then fails. */
    public fun cancel()
}

/**
 * A column of an answer.
 *
 * @property type its SQL type.
 * @property isNumber whether it has numbers.
 */
public class SqlColumn(public val name: String, public val type: String, public val isNumber: Boolean)

/**
 * A table that queries can use.
 *
 * @property meaning the meaning of a row.
 */
public class SqlTable(public val name: String, public val meaning: String, public val columns: List<SqlColumn>)
