package badlog.season.lake

import badlog.core.analysis.LogView
import badlog.core.recording.Topic
import badlog.season.engine.Engine
import badlog.season.engine.Table
import java.nio.file.Path

/**
 * The tables of the log [log] that have files of their own; [view] is its content, [identity] its match and time.
 *
 * @property samples the topics that share rows; null if there are none.
 * @property series the topics with times of their own; null if there are none.
 * @property columnOf the name of each topic's column in [samples].
 */
internal class LogTables(view: LogView, log: String, identity: LogIdentity) {
    private val rows = SamplesTable(view, log, identity)
    private val metadata = METADATA to topicsJson(view.recording.topics, rows.nameOf, identity)

    val samples: Table? = rows.table
    val series: Table? = seriesTable(view, log, identity)
    val columnOf: Map<Topic, String> = rows.nameOf

    /** Writes [table], one of these, to the Parquet file [target] by [engine]. Returns the number of its rows. */
    fun write(table: Table, target: Path, engine: Engine): Long = engine.connected { connection ->
        engine.lend(table) { select -> writeParquet(connection, select, target, metadata, table.columns.size) }
    }
}

/** The key of the description of the topics in the file's metadata. */
private const val METADATA = "badlog"
