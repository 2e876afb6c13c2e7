package badlog.cli.part

import badlog.file.LogFile
import badlog.rules.RuleSet
import kotlinx.serialization.json.JsonElement
import java.nio.file.Path

/** What `badlog lake` and `badlog sql` call: folders of logs as tables. Each function throws [SeasonException] where it cannot do what it says. */
public interface SeasonService {
    /** Whether [folder] is a lake. */
    public fun isLake(folder: Path): Boolean

    /**
     * Makes the lake [lake] have [logs], each with what it is called there. Of those that it has below [roots] it forgets the others.
     *
     * @param progress hears how many of the changed logs are done. What it throws stops the work and is passed on.
     */
    public fun refresh(
        lake: Path,
        logs: List<Pair<LogFile, String>>,
        roots: List<Path>,
        rules: RuleSet,
        progress: (done: Int, total: Int) -> Unit,
    ): LakeReport

    /** Opens [lake] for queries, whose answers may also be written to the Parquet file [output], if it is not null. */
    public fun open(lake: Path, output: Path?): SqlSession
}

/** Why something cannot be done with a lake. The message is for a person. */
public class SeasonException(override val message: String) : Exception(message)

/**
 * What became of a lake.
 *
 * @property logs what became of each log, in their order.
 * @property removed how many logs it forgot, whose files are gone.
 */
public class LakeReport(public val logs: List<LakeState>, public val removed: Int)

/**
 * What became of a log in a lake.
 *
 * @property message why it is not there, as a sentence; null when it is.
 * @property isNoLog whether it is something else than a log.
 * @property isSalvaged whether it was written and something of it is lost.
 * @property isWritten whether it was written; else the lake had it already.
 */
public class LakeState(
    public val message: String?,
    public val isNoLog: Boolean,
    public val isSalvaged: Boolean,
    public val isWritten: Boolean,
)

/** A lake that answers queries, see [SeasonService.open]. */
public interface SqlSession : AutoCloseable {
    /** Answers [sql]: gives its columns to [columns], then each row to [row], until that says false. */
    public fun query(sql: String, columns: (List<SqlColumn>) -> Unit, row: (List<JsonElement>) -> Boolean)

    /** Writes the answer to [sql] to the file that was named; returns how many rows it has. */
    public fun write(sql: String): Long

    /** What queries may name. */
    public fun tables(): List<SqlTable>
}

/**
 * A column of an answer.
 *
 * @property type what SQL calls its type.
 * @property isNumber whether it has numbers.
 */
public class SqlColumn(public val name: String, public val type: String, public val isNumber: Boolean)

/**
 * A table that queries may name.
 *
 * @property meaning what a row of it is.
 */
public class SqlTable(public val name: String, public val meaning: String, public val columns: List<SqlColumn>)
