package badlog.season.lake

import badlog.rules.RuleSet
import badlog.season.engine.Engine
import java.nio.file.Path

/**
 * Makes the pieces of a lake that is elsewhere, in folders of this machine, from where they can be moved to the lake: the files of single
 * logs, and the tables of single partitions. A [Lake] puts the same pieces together by itself. Safe for several threads.
 *
 * @param rules what findings are looked for, and what topics are called.
 * @param hasSamples false to leave out the files of single logs, so that the lake has the tables of all logs alone.
 */
class LakePieces(rules: RuleSet, hasSamples: Boolean = true) : AutoCloseable {
    private val engine = Engine(Engine.WRITING_MEGABYTES, threads = 1)
    private val examination = LakeExamination(rules, engine, hasSamples)

    /** What decides what becomes of a log besides its file: the version of the layout, the rules, and whether there are samples. */
    val maker: String get() = examination.maker

    /**
     * Reads [file], a copy of the log that is planned as [log], runs the rules over it, and writes the files of its samples into [folder],
     * under the paths that they have in a lake. Whatever fails, fails for this log alone.
     *
     * @throws LakeException when [folder] cannot be written to.
     */
    fun write(file: Path, log: PlannedLog, folder: Path): ExaminedLog =
        writing(folder) { examination.write(file, cores = 1, log.source, log.log, folder) }

    /**
     * Makes [changes], all of one place, to the tables in [folder], which has those of that place as the lake has them, or none. Holds a few
     * changes at a time. The same again gives the same.
     *
     * @throws LakeException when [folder] cannot be written to.
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

    /** Returns the logs that the tables in [folder] have. */
    fun registered(folder: Path): List<RegisteredLog> = writing(folder) { registeredIn(folder, engine) }

    override fun close(): Unit = engine.close()
}
