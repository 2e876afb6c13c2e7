package badlog.season.lake

import badlog.core.analysis.LogView
import badlog.core.recording.Topic
import badlog.season.engine.Engine
import badlog.season.engine.Table
import java.nio.file.Path

/**
 * The tables of the log [log] of [identity], as [view] shows it, that stand in files of its own.
 *
 * @property samples the topics that share rows; null where none do.
 * @property series the topics that have times of their own; null where none have.
 * @property columnOf what the column of a topic is called in [samples].
 */
internal class LogTables(view: LogView, log: String, identity: LogIdentity) {
    private val rows = SamplesTable(view, log, identity)
    private val metadata = METADATA to topicsJson(view.recording.topics, rows.nameOf, identity)

    val samples: Table? = rows.table
    val series: Table? = seriesTable(view, log, identity)
    val columnOf: Map<Topic, String> = rows.nameOf

    /** Writes [table], one of these, to the Parquet file [target] by [engine]; returns how many rows it has. */
    fun write(table: Table, target: Path, engine: Engine): Long = engine.connected { connection ->
        engine.lend(table) { select -> writeParquet(connection, select, target, metadata, table.columns.size) }
    }

    private companion object {
        /** By which name such a file says what its topics are. */
        const val METADATA = "badlog"
    }
}
