package badlog.season.lake

import badlog.files.FolderRun
import badlog.files.LogFile
import badlog.files.LogMaker
import badlog.files.unwritable
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

/** Thrown if a lake cannot be made or read. The message is one sentence for the user: what, where, and what to do. */
class LakeException(override val message: String, cause: Throwable? = null) : Exception(message, cause)

/**
 * A log to be added to a lake.
 *
 * @property file its file.
 * @property name its name in the lake, with slashes, usually its path below the folder of logs; if another file has that name in the
 *   lake, a number is added.
 */
class LakeLog(val file: LogFile, val name: String) {
    internal val source: LogSource get() = LogSource(pathOf(file.path), file.name, name, file.size, file.modified)
}

/**
 * The outcome for a file that was to be added to a lake.
 *
 * @property message the reason why it was not added, as a sentence; null if it was.
 * @property isNoLog whether it is something other than a log.
 * @property isSalvaged whether data of the log is lost.
 * @property isWritten whether it was written; otherwise it was already in the lake.
 */
class LakeOutcome internal constructor(
    val log: LakeLog,
    val message: String?,
    val isNoLog: Boolean,
    val isSalvaged: Boolean,
    val isWritten: Boolean,
)

/**
 * The outcome for a folder of logs.
 *
 * @property outcomes the outcome for each file, in the order of the files.
 * @property removed the number of logs removed from the lake because their files are gone.
 */
class LakeResult internal constructor(val outcomes: List<LakeOutcome>, val removed: Int) {
    /** The number of logs written. */
    val written: Int get() = outcomes.count { it.isWritten }

    /** The number of logs that were already in the lake. */
    val unchanged: Int get() = outcomes.count { it.message == null && !it.isWritten }
}

/**
 * A folder of Parquet files with logs as tables; `docs/season.md` specifies it. Any engine can read its files.
 *
 * @property folder its folder.
 */
class Lake(val folder: Path) {
    /**
     * Updates the lake to the current state of [logs]. Only changed logs are read and written. Logs below [roots] that are not among
     * [logs] are removed. Each file is written atomically, so an interrupted run leaves a readable lake, and the next run continues.
     *
     * Besides the logs being read, it holds a group of rows of each in memory, and the data that DuckDB collects for their tables, at
     * most 256 MB.
     *
     * @param rules the rules for findings, and the names of topics.
     * @param matches makes one log from a file with the logs of a match; null if such files are not read.
     * @param isBusy called from time to time while another badlog writes to the lake; returns whether to wait until it has finished. An
     *   exception from it is passed on.
     * @param batch the maximum number of logs collected before the tables of a small lake are written.
     * @param progress called on this thread with the number of changed logs that are done. An exception from it stops the work and is
     *   passed on; completed work stays in the lake.
     * @throws LakeException if [folder] has other files in it, is being written to, or cannot be written to.
     * @throws InterruptedException if the thread was interrupted.
     */
    fun refresh(
        logs: List<LakeLog>,
        roots: List<Path>,
        rules: RuleSet,
        batch: Int = DEFAULT_BATCH,
        matches: LogMaker? = null,
        isBusy: () -> Boolean = { false },
        progress: (done: Int, total: Int) -> Unit = { _, _ -> },
    ): LakeResult = locked(isBusy) {
        writing(folder) {
            val mark = LakeMark.of(folder) ?: LakeMark().also { it.write(folder) }
            Engine(Engine.WRITING_MEGABYTES, threads = 1).use { engine ->
                LakeRefresh(folder, engine, LakeExamination(rules, engine, matches = matches), mark).run(logs, roots, batch, progress)
            }
        }
    }

    private fun <R> locked(isBusy: () -> Boolean, work: () -> R): R {
        val channel = try {
            requireLakeOrEmpty()
            Files.createDirectories(folder)
            FileChannel.open(folder.resolve(LakeLayout.LOCK), CREATE, WRITE)
        } catch (e: IOException) {
            throw LakeException("The lake ${unwritable(folder, e).message}", e)
        }
        return channel.use {
            while (!it.acquireLock()) {
                if (!isBusy()) throw LakeException("Another badlog is writing to the lake $folder; wait until it has finished.")
                Thread.sleep(PATIENCE)
            }
            work()
        }
    }

    /** Takes the lock, unless another thread or process has it. */
    private fun FileChannel.acquireLock(): Boolean = try {
        tryLock() != null
    } catch (_: OverlappingFileLockException) {
        false
    }

    /** A lake must not be mixed with other files. */
    private fun requireLakeOrEmpty() {
        if (!Files.isDirectory(folder) || isLake(folder)) return
        val isEmpty = Files.list(folder).use { files -> files.allMatch { it.fileName.toString() == LakeLayout.LOCK } }
        if (!isEmpty) throw LakeException("$folder has other files in it; name an empty folder, or a new one.")
    }

    companion object {
        /** Returns whether [folder] is a lake, of any version. */
        fun isLake(folder: Path): Boolean = Files.isRegularFile(folder.resolve(LakeLayout.MARK))

        /** The version of the layout that is written, see `docs/season.md`; other versions are not read. */
        const val LAYOUT_VERSION: Int = LakeLayout.VERSION

        private const val DEFAULT_BATCH = 500

        /** The time between checks whether another badlog has finished, in ms. */
        private const val PATIENCE = 200L
    }
}

/** Runs [work], which writes to [folder]; failures to write become a [LakeException]. */
internal inline fun <R> writing(folder: Path, work: () -> R): R = try {
    work()
} catch (e: SQLException) {
    throw LakeException("The lake $folder cannot be written (${e.message}); make room on the disk, or make the lake in another folder.", e)
} catch (e: IOException) {
    throw LakeException("The lake ${unwritable(folder, e).message}", e)
}

/** One run of [Lake.refresh] with [engine] on the lake [folder], which is locked and has the mark [mark]. */
internal class LakeRefresh(
    private val folder: Path,
    private val engine: Engine,
    private val examination: LakeExamination,
    private val mark: LakeMark,
) {
    private val registered = registeredIn(folder, engine)
    private val stage = LakeStage(folder, engine)
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
            val advance = { progress(examined.size, changed.size) }
            try {
                engine.finishing(::stop) {
                    plan.gone.forEach(stage::remove)
                    val work = { file: LogFile, cores: Int -> writeUnlessStopped(file.path, byPath.getValue(pathOf(file.path)), cores) }
                    FolderRun().forEach(changed, work, advance) { file, found ->
                        examined[pathOf(file.path)] = found
                        if (stage.size >= most(examined.size, batch)) stage.flush()
                        advance()
                    }
                }
            } finally {
                stop()
            }
        }
        val salvaged = registered.filter { it.isSalvaged }.mapTo(HashSet()) { it.path }
        val outcomes = logs.zip(sources) { log, source ->
            outcomeOf(log, examined[source.path], plan.ignored[source], wasSalvaged = source.path in salvaged)
        }
        if (examined.isNotEmpty()) noteIgnored(outcomes)
        return LakeResult(outcomes, plan.gone.size)
    }

    /**
     * Returns the number of logs after which the tables are written, when [examined] were examined. They are rewritten each time, so the
     * larger they are, the more logs are collected first. The first logs are in them soon, so that a program killed early keeps some.
     */
    private fun most(examined: Int, batch: Int) = maxOf(minOf(batch, maxOf(FIRST, examined / 2)), (registered.size + examined) / GROWTH)

    /**
     * Waits for the logs that are being written, and adds them to the tables. Nothing is written later: the lock is released, or the
     * program ends.
     */
    private fun stop() = underWay.write {
        isStopped = true
        stage.flush()
    }

    /** Removes the drafts that killed runs left behind. */
    private fun dropDrafts() {
        Files.walk(folder).use { files ->
            files.filter { it.fileName.toString().startsWith(LakeLayout.DRAFT) }.toList().forEach(Files::deleteIfExists)
        }
    }

    private fun writeUnlessStopped(file: Path, log: PlannedLog, cores: Int): ExaminedLog = underWay.read {
        if (isStopped) throw CancellationException()
        examination.write(file, cores, log.source, log.log, folder).also { if (it is ExaminedLog.Written) stage.add(it.entry, log.former) }
    }

    private fun outcomeOf(log: LakeLog, examined: ExaminedLog?, ignored: String?, wasSalvaged: Boolean): LakeOutcome = when (examined) {
        is ExaminedLog.Written -> LakeOutcome(log, null, isNoLog = false, isSalvaged = examined.entry.isSalvaged, isWritten = true)
        is ExaminedLog.None -> LakeOutcome(log, examined.message, examined.isNoLog, isSalvaged = false, isWritten = false)
        null -> LakeOutcome(log, ignored, isNoLog = ignored != null, isSalvaged = ignored == null && wasSalvaged, isWritten = false)
    }

    private fun noteIgnored(outcomes: List<LakeOutcome>) {
        val ignored = outcomes.filter { it.isNoLog }.associate { it.log.source to it.message.orEmpty() }
        mark.after(outcomes.map { it.log.source }, ignored).write(folder)
    }
}

private const val GROWTH = 4
private const val FIRST = 4
