package badlog.season.lake

import badlog.file.FolderRun
import badlog.file.LogFile
import badlog.rules.RuleSet
import badlog.season.engine.Engine
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.sql.SQLException
import java.util.concurrent.CancellationException
import java.util.concurrent.locks.ReentrantReadWriteLock
import kotlin.concurrent.read
import kotlin.concurrent.write

/** A lake cannot be made or read. The message is one sentence for a person: what, where, and what to do. */
public class LakeException(override val message: String, cause: Throwable? = null) : Exception(message, cause)

/**
 * A log for a lake.
 *
 * @property file its file.
 * @property name what the lake calls it, with slashes, mostly its path below the folder of logs; where another file has that name in the
 *   lake, it gets a number.
 */
public class LakeLog(public val file: LogFile, public val name: String) {
    internal val source: LogSource get() = LogSource(pathOf(file.path), file.name, name, file.size, file.modified)
}

/**
 * What became of a file that was to be in a lake.
 *
 * @property message why it is not there, as a sentence; null when it is.
 * @property isNoLog whether it is something else than a log.
 * @property isSalvaged whether the log lost something; known of those that were written.
 * @property isWritten whether it was written; else the lake had it already.
 */
public class LakeOutcome internal constructor(
    public val log: LakeLog,
    public val message: String?,
    public val isNoLog: Boolean,
    public val isSalvaged: Boolean,
    public val isWritten: Boolean,
)

/**
 * What became of a folder of logs.
 *
 * @property outcomes of each file, in the order of the files.
 * @property removed how many logs the lake had whose files are gone.
 */
public class LakeResult internal constructor(public val outcomes: List<LakeOutcome>, public val removed: Int) {
    /** How many logs were written. */
    public val written: Int get() = outcomes.count { it.isWritten }

    /** How many the lake had already. */
    public val unchanged: Int get() = outcomes.count { it.message == null && !it.isWritten }
}

/**
 * A folder of Parquet files, in which logs are tables; `docs/season.md` specifies it. Its files are open: any engine reads them.
 *
 * @property folder where it is.
 */
public class Lake(public val folder: Path) {
    /**
     * Makes the lake have [logs] as they are now. Only those that changed are read and written. Of those that it has below [roots], it
     * forgets the ones that are not among [logs]. Each file is there whole or as it was, so an interrupted run leaves a lake that can be
     * read, and the next run goes on.
     *
     * Besides the logs that are read at the moment, it holds a group of rows of each, and what DuckDB gathers of their tables, 256 MB at
     * most.
     *
     * @param rules what findings are looked for, and what topics are called.
     * @param batch after how many logs the tables are written, at least.
     * @param progress hears on this thread how many of the changed logs are done. What it throws stops the work and is passed on; what is
     *   done then is in the lake.
     * @throws LakeException when [folder] is something else, is being written to, or cannot be written to.
     * @throws InterruptedException when the thread was interrupted.
     */
    public fun refresh(
        logs: List<LakeLog>,
        roots: List<Path>,
        rules: RuleSet,
        batch: Int = DEFAULT_BATCH,
        progress: (done: Int, total: Int) -> Unit = { _, _ -> },
    ): LakeResult = locked {
        writing(folder) {
            val mark = LakeMark.of(folder) ?: LakeMark().also { it.write(folder) }
            Engine(Engine.WRITING_MEGABYTES, threads = 1).use { engine ->
                LakeRefresh(folder, engine, rules, mark).run(logs, roots, batch, progress)
            }
        }
    }

    private fun <R> locked(work: () -> R): R {
        val channel = try {
            requireOwn()
            Files.createDirectories(folder)
            FileChannel.open(folder.resolve(LakeLayout.LOCK), CREATE, WRITE)
        } catch (e: IOException) {
            throw LakeException("The lake $folder cannot be written (${e.message}); make it in another folder.", e)
        }
        return channel.use {
            val lock = try {
                it.tryLock()
            } catch (_: OverlappingFileLockException) {
                null
            }
            if (lock == null) throw LakeException("Another badlog is writing to the lake $folder; wait until it has finished.")
            work()
        }
    }

    /** Nobody's files are to be among those of a lake. */
    private fun requireOwn() {
        if (!Files.isDirectory(folder) || isLake(folder)) return
        val isEmpty = Files.list(folder).use { files -> files.allMatch { it.fileName.toString() == LakeLayout.LOCK } }
        if (!isEmpty) throw LakeException("$folder has other files in it; name an empty folder, or a new one.")
    }

    public companion object {
        /** Whether [folder] is a lake, of any version. */
        public fun isLake(folder: Path): Boolean = Files.isRegularFile(folder.resolve(LakeLayout.MARK))

        private const val DEFAULT_BATCH = 500
    }
}

/** Does [work], which writes to [folder]; whatever it cannot write becomes a [LakeException]. */
internal inline fun <R> writing(folder: Path, work: () -> R): R = try {
    work()
} catch (e: SQLException) {
    throw LakeException("The lake $folder cannot be written (${e.message}); make room on the disk, or make the lake in another folder.", e)
} catch (e: IOException) {
    throw LakeException("The lake $folder cannot be written (${e.message}); make it in another folder.", e)
}

/** One run of [Lake.refresh], by [engine], over the lake [folder], which is locked and says [mark] of itself. */
internal class LakeRefresh(private val folder: Path, private val engine: Engine, rules: RuleSet, private val mark: LakeMark) {
    private val registered = registeredIn(folder, engine)
    private val stage = LakeStage(folder, engine)
    private val examination = LakeExamination(rules, engine)
    private val underWay = ReentrantReadWriteLock()
    private var isStopped = false

    fun run(logs: List<LakeLog>, roots: List<Path>, batch: Int, progress: (done: Int, total: Int) -> Unit): LakeResult {
        val sources = logs.map { it.source }
        val tops = roots.map { Path.of(pathOf(it)) }
        val isBelow = { path: String -> tops.any { Path.of(path).startsWith(it) } }
        val plan = LakeInventory(mark, registered).plan(sources, examination.maker, isBelow) { Files.exists(folder.resolve(it)) }
        val examined = HashMap<String, ExaminedLog>()
        if (plan.changed.isNotEmpty() || plan.gone.isNotEmpty()) {
            dropDrafts()
            val byPath = plan.changed.associateBy { it.source.path }
            val changed = logs.map { it.file }.filter { pathOf(it.path) in byPath }
            try {
                plan.gone.forEach(stage::remove)
                val work = { file: LogFile, cores: Int -> writeUnlessStopped(file.path, byPath.getValue(pathOf(file.path)), cores) }
                FolderRun().forEach(changed, work) { file, found ->
                    examined[pathOf(file.path)] = found
                    // Tables are written anew each time, so the larger they are, the more has to come together.
                    if (stage.size >= maxOf(batch, (registered.size + examined.size) / GROWTH)) stage.flush()
                    progress(examined.size, changed.size)
                }
            } finally {
                // What is being written when the work is stopped comes into the tables, too, and nothing is written after the lock is gone.
                underWay.write {
                    isStopped = true
                    stage.flush()
                }
            }
        }
        val outcomes = logs.zip(sources) { log, source -> outcomeOf(log, examined[source.path], plan.ignored[source]) }
        if (examined.isNotEmpty()) noteIgnored(outcomes)
        return LakeResult(outcomes, plan.gone.size)
    }

    /** What killed runs have left. */
    private fun dropDrafts() {
        Files.walk(folder).use { files ->
            files.filter { it.fileName.toString().startsWith(LakeLayout.DRAFT) }.toList().forEach(Files::deleteIfExists)
        }
    }

    private fun writeUnlessStopped(file: Path, log: PlannedLog, cores: Int): ExaminedLog = underWay.read {
        if (isStopped) throw CancellationException()
        examination.write(file, cores, log.source, log.log, folder).also { if (it is ExaminedLog.Written) stage.add(it.entry, log.former) }
    }

    private fun outcomeOf(log: LakeLog, examined: ExaminedLog?, ignored: String?): LakeOutcome = when (examined) {
        is ExaminedLog.Written -> LakeOutcome(log, null, isNoLog = false, isSalvaged = examined.entry.isSalvaged, isWritten = true)
        is ExaminedLog.None -> LakeOutcome(log, examined.message, examined.isNoLog, isSalvaged = false, isWritten = false)
        null -> LakeOutcome(log, ignored, isNoLog = ignored != null, isSalvaged = false, isWritten = false)
    }

    private fun noteIgnored(outcomes: List<LakeOutcome>) {
        val ignored = outcomes.filter { it.isNoLog }.associate { it.log.source to it.message.orEmpty() }
        mark.after(outcomes.map { it.log.source }, ignored).write(folder)
    }

    private companion object {
        const val GROWTH = 4
    }
}
