package badlog.spark.lake

import badlog.season.lake.ExaminedLog
import badlog.season.lake.LakeChange
import badlog.season.lake.PlannedLog
import badlog.spark.storage.RemoteFolder
import badlog.spark.storage.RemoteLog
import org.apache.spark.api.java.function.PairFlatMapFunction
import org.apache.spark.util.SerializableConfiguration
import scala.Tuple2
import java.io.FileNotFoundException
import java.io.IOException
import java.io.Serializable
import java.nio.file.Files
import java.nio.file.Path

/** A log to be written, with its plan and its files. */
internal class RemotePlan(val planned: PlannedLog, val log: RemoteLog) : Serializable {
    private companion object {
        const val serialVersionUID = 1L
    }
}

/**
 * The work on one log: fetches it, reads it, runs the rules, and writes its files into [lake]. Its pieces of the tables are passed on by
 * partition. A repeated or duplicate run writes the same files.
 */
internal class WriteLog(private val lake: RemoteFolder, private val work: LakeWork, private val configuration: SerializableConfiguration) :
    PairFlatMapFunction<RemotePlan, String, LogPiece> {
    override fun call(plan: RemotePlan): Iterator<Tuple2<String, LogPiece>> = withScratchFolder { scratch ->
        val path = plan.planned.source.path
        val pieces = try {
            piecesOf(plan.planned, fetched(plan.log, scratch), scratch)
        } catch (e: UnfetchedLogException) {
            listOf(LogPiece(null, LogOutcome(path, e.message)))
        }
        pieces.map { Tuple2(it.partitionPath, it) }.iterator()
    }

    private fun piecesOf(log: PlannedLog, file: Path, scratch: Path): List<LogPiece> {
        val made = Files.createDirectory(scratch.resolve(MADE))
        return when (val examined = ExecutorPieces.of(work).write(file, log, made)) {
            is ExaminedLog.None -> listOf(LogPiece(null, LogOutcome(log.source.path, examined.message, examined.isNoLog)))

            is ExaminedLog.Written -> {
                val entry = examined.entry
                for (name in entry.files) lake.put(made.resolve(name), name)
                val former = log.former
                val outcome = LogOutcome(
                    log.source.path,
                    isSalvaged = entry.isSalvaged,
                    obsolete = former?.files.orEmpty() - entry.files.toSet(),
                )
                listOfNotNull(
                    LogPiece(LakeChange.Put(entry), outcome),
                    former?.takeIf { it.partitionPath != entry.partitionPath }?.let { LogPiece(LakeChange.Remove(it), null) },
                )
            }
        }
    }

    /** Copies the files of [log] to [scratch], with retries, because networks fail now and then. */
    private fun fetched(log: RemoteLog, scratch: Path): Path {
        var attempt = 1
        while (true) {
            try {
                return log.fetch(Files.createDirectories(scratch.resolve("$FETCHED$attempt")), configuration.value())
            } catch (e: IOException) {
                if (e is FileNotFoundException || attempt++ == ATTEMPTS) throw UnfetchedLogException(log.source.path, e)
            }
        }
    }

    private class UnfetchedLogException(path: String, cause: IOException) :
        Exception("$path cannot be read (${cause.message}); see that all machines of the cluster may read it.", cause) {
        override val message: String get() = super.message!!
    }

    private companion object {
        const val serialVersionUID = 1L
        const val ATTEMPTS = 3
        const val FETCHED = "log"
        const val MADE = "made"
    }
}
