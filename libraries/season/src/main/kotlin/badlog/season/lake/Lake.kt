package badlog.season.lake

import badlog.file.FolderRun
import badlog.file.LogFile
import badlog.rules.RuleSet
import badlog.rules.toJson
import badlog.season.engine.Engine
import badlog.text.freeName
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
import java.util.zip.CRC32
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
public class LakeLog(public val file: LogFile, public val name: String)

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
        try {
            val mark = LakeMark.of(folder) ?: LakeMark().also { it.write(folder) }
            Engine(MEMORY_MEGABYTES, threads = 1).use { engine ->
                LakeRefresh(folder, engine, rules, mark).run(logs, roots, batch, progress)
            }
        } catch (e: SQLException) {
            throw LakeException(
                "The lake $folder cannot be written (${e.message}); make room on the disk, or make the lake in another folder.",
                e,
            )
        } catch (e: IOException) {
            throw LakeException("The lake $folder cannot be written (${e.message}); make it in another folder.", e)
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

        private const val MEMORY_MEGABYTES = 256
        private const val DEFAULT_BATCH = 500
    }
}

/** One run of [Lake.refresh], by [engine], over the lake [folder], which is locked and says [mark] of itself. */
internal class LakeRefresh(private val folder: Path, private val engine: Engine, private val rules: RuleSet, private val mark: LakeMark) {
    private val registered = registeredIn(folder, engine)
    private val stage = LakeStage(folder, engine)
    private val examination = LakeExamination(rules)
    private val underWay = ReentrantReadWriteLock()
    private var isStopped = false
    private val maker = "${LakeLayout.VERSION}-${CRC32().apply { update(rules.toJson().encodeToByteArray()) }.value.toString(HEX)}"

    fun run(logs: List<LakeLog>, roots: List<Path>, batch: Int, progress: (done: Int, total: Int) -> Unit): LakeResult {
        val ignored = mark.ignored.associateBy { it.path }
        val known = logs.associateWith { log ->
            val former = registered[pathOf(log.file)]
            val other = ignored[pathOf(log.file)]?.takeIf { it.isOf(log.file) }
            when {
                former?.isOf(log.file, maker) == true && former.files.all { Files.exists(folder.resolve(it)) } ->
                    LakeOutcome(log, null, isNoLog = false, isSalvaged = false, isWritten = false)

                other != null -> LakeOutcome(log, other.message, isNoLog = true, isSalvaged = false, isWritten = false)

                else -> null
            }
        }
        val changed = logs.filter { known[it] == null }
        val gone = goneFrom(logs, roots)
        val outcomes = HashMap<LakeLog, LakeOutcome>()
        if (changed.isNotEmpty() || gone.isNotEmpty()) {
            dropDrafts()
            val byFile = changed.associateBy { it.file }
            val names = namesOf(changed)
            try {
                gone.forEach(stage::remove)
                val work = { file: LogFile, cores: Int -> writeUnlessStopped(byFile.getValue(file), names, cores) }
                FolderRun().forEach(changed.map { it.file }, work) { file, examined ->
                    val log = byFile.getValue(file)
                    outcomes[log] = outcomeOf(log, examined)
                    // Tables are written anew each time, so the larger they are, the more has to come together.
                    if (stage.size >= maxOf(batch, (registered.size + outcomes.size) / GROWTH)) stage.flush()
                    progress(outcomes.size, changed.size)
                }
            } finally {
                // What is being written when the work is stopped comes into the tables, too, and nothing is written after the lock is gone.
                underWay.write {
                    isStopped = true
                    stage.flush()
                }
            }
            noteIgnored(logs.map { outcomes[it] ?: known.getValue(it)!! })
        }
        return LakeResult(logs.map { outcomes[it] ?: known.getValue(it)!! }, gone.size)
    }

    private fun goneFrom(logs: List<LakeLog>, roots: List<Path>): List<RegisteredLog> {
        val here = logs.mapTo(HashSet()) { pathOf(it.file) }
        val tops = roots.map { Path.of(pathOf(it)) }
        return registered.values.filter { former -> former.path !in here && tops.any { Path.of(former.path).startsWith(it) } }
    }

    /** What killed runs have left. */
    private fun dropDrafts() {
        Files.walk(folder).use { files ->
            files.filter { it.fileName.toString().startsWith(LakeLayout.DRAFT) }.toList().forEach(Files::deleteIfExists)
        }
    }

    private fun namesOf(logs: List<LakeLog>): Map<LakeLog, String> {
        val taken = registered.values.mapTo(HashSet()) { it.log.lowercase() }
        return logs.associateWith { log -> registered[pathOf(log.file)]?.log ?: freeName(log.name) { taken.add(it.lowercase()) } }
    }

    private fun writeUnlessStopped(log: LakeLog, names: Map<LakeLog, String>, cores: Int): ExaminedLog = underWay.read {
        if (isStopped) throw CancellationException()
        write(log, names, cores)
    }

    private fun write(log: LakeLog, names: Map<LakeLog, String>, cores: Int): ExaminedLog = examination.of(log.file, cores) {
            view,
            findings,
        ->
        val name = names.getValue(log)
        val identity = LogIdentity.of(log.file.name, view.recording, rules.signals)
        val samples = SamplesTable(view, name, identity)
        val tables = listOfNotNull(
            samples.table?.let { LakeLayout.logFile(LakeLayout.SAMPLES, identity.partition, name) to it },
            seriesTable(view, name, identity)?.let { LakeLayout.logFile(LakeLayout.SERIES, identity.partition, name) to it },
        )
        val metadata = METADATA to topicsJson(view.recording.topics, samples.nameOf, identity)
        engine.connected { connection ->
            for ((file, table) in tables) {
                engine.lend(table) { select -> writeParquet(connection, select, folder.resolve(file), metadata, table.columns.size) }
            }
        }
        val files = tables.map { it.first }
        val records = LogRecords(name, log.file, view, findings, identity, samples.nameOf, files, maker)
        stage.add(name, identity.partition, records.all, files, registered[pathOf(log.file)])
    }

    private fun outcomeOf(log: LakeLog, examined: ExaminedLog): LakeOutcome = when (examined) {
        is ExaminedLog.Written -> LakeOutcome(log, null, isNoLog = false, isSalvaged = examined.isSalvaged, isWritten = true)
        is ExaminedLog.None -> LakeOutcome(log, examined.message, examined.isNoLog, isSalvaged = false, isWritten = false)
    }

    private fun noteIgnored(outcomes: List<LakeOutcome>) {
        val ignored = outcomes.filter { it.isNoLog }.map { outcome ->
            outcome.log.file.let { LakeMark.Ignored(pathOf(it), it.size, it.modified, outcome.message.orEmpty()) }
        }
        val here = outcomes.mapTo(HashSet()) { pathOf(it.log.file) }
        LakeMark(ignored = mark.ignored.filter { it.path !in here } + ignored).write(folder)
    }

    private companion object {
        const val HEX = 16
        const val GROWTH = 4

        /** By which name a file of samples says what its topics are. */
        const val METADATA = "badlog"
    }
}
