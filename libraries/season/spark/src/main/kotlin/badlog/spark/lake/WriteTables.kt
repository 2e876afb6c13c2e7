package badlog.spark.lake

import badlog.season.lake.LakeChange
import badlog.season.lake.LakeLayout
import badlog.spark.storage.RemoteFolder
import org.apache.spark.api.java.function.FlatMapFunction
import scala.Tuple2
import java.nio.file.Files
import java.nio.file.Path

/**
 * The work on the tables of some partitions of [lake]. Fetches the tables, changes them, and writes them back, the table of matches last.
 * Its input is sorted by partition. A repeated or duplicate run writes the same files. It returns the outcomes for the logs.
 */
internal class WriteTables(private val lake: RemoteFolder, private val work: LakeWork) :
    FlatMapFunction<Iterator<Tuple2<String, LogPiece>>, LogOutcome> {
    override fun call(pieces: Iterator<Tuple2<String, LogPiece>>): Iterator<LogOutcome> {
        val outcomes = ArrayList<LogOutcome>()
        val partitions = PartitionChanges(pieces, outcomes)
        while (true) {
            val partitionPath = partitions.next() ?: return outcomes.iterator()
            if (partitionPath.isNotEmpty()) write(partitionPath, partitions.changes()) else partitions.changes().forEach { _ -> }
        }
    }

    private fun write(partitionPath: String, changes: Iterator<LakeChange>) = withScratchFolder { scratch ->
        val files = LakeLayout.TABLES.map { table -> "$table/$partitionPath/$table${LakeLayout.ENDING}" }
        for (file in files) lake.fetch(file, scratch.resolve(file))
        ExecutorPieces.of(work).merge(scratch, changes)
        for (file in files) putBack(scratch.resolve(file), file)
    }

    private fun putBack(local: Path, name: String) = if (Files.exists(local)) lake.put(local, name) else lake.delete(name)
}

/** The changes in [pieces], sorted by partition. The outcome for each log is added to [outcomes]. */
private class PartitionChanges(private val pieces: Iterator<Tuple2<String, LogPiece>>, private val outcomes: MutableList<LogOutcome>) {
    private var ahead: Tuple2<String, LogPiece>? = take()

    /** Returns the next partition; null after the last one. Call it after taking all changes of the previous partition. */
    fun next(): String? = ahead?._1()

    /** Returns the changes of the [next] partition, as a lazy sequence. */
    fun changes(): Iterator<LakeChange> {
        val partitionPath = next()
        return generateSequence { if (ahead?._1() == partitionPath) ahead?._2().also { ahead = take() } else null }
            .onEach { piece -> piece.outcome?.let(outcomes::add) }
            .mapNotNull { it.change }
            .iterator()
    }

    private fun take() = if (pieces.hasNext()) pieces.next() else null
}

private const val serialVersionUID = 1L
