package badlog.season.lake

import badlog.rules.RuleSet
import badlog.season.engine.Engine
import java.nio.file.Path

/**
 * Makes pieces of a remote lake in local folders: the files of single logs, and the tables of single partitions. The caller moves them to
 * the lake. A local [Lake] consists of the same pieces. Thread-safe.
 *
 * @param rules the rules for findings, and the names of topics.
 * @param hasSamples false to leave out the files of single logs, so that the lake has only the tables of all logs.
 */
class LakePieces(rules: RuleSet, hasSamples: Boolean = true) : AutoCloseable {
    private val engine = Engine(Engine.WRITING_MEGABYTES, threads = 1)
    private val examination = LakeExamination(rules, engine, hasSamples)

    /**
     * Identifies everything that affects the records of a log, besides its file: the layout's version, the rules, and whether there are
     * samples.
     */
    val maker: String get() = examination.maker

    /**
     * Reads [file], a copy of the planned [log], and runs the rules over it. Writes the files of its samples into [folder], under their
     * paths in the lake. A failure concerns only this log.
     *
     * @throws LakeException if [folder] cannot be written to.
     */
    fun write(file: Path, log: PlannedLog, folder: Path): ExaminedLog =
        writing(folder) { examination.write(file, cores = 1, log.source, log.log, folder) }

    /**
     * Applies [changes] of one partition to the tables in [folder]. The folder has the partition's current tables, or none. Only a few
     * changes are in memory at a time. Repeating it has no effect.
     *
     * @throws LakeException if [folder] cannot be written to.
     */
    fun merge(folder: Path, changes: Iterator<LakeChange>): Unit = writing(folder) {
        Engine(Engine.WRITING_MEGABYTES, threads = 1).use { own ->
            val stage = LakeStage(folder, own)
            for (change in changes) {
                when (change) {
                    is LakeChange.Put -> stage.add(change.entry, former = null)
                    is LakeChange.Remove -> stage.remove(change.log)
                }
            }
            stage.flush()
        }
    }

    /** Returns the logs in the tables in [folder]. */
    fun registered(folder: Path): List<RegisteredLog> = writing(folder) { registeredIn(folder, engine) }

    override fun close(): Unit = engine.close()
}
