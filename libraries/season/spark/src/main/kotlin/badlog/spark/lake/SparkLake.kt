package badlog.spark.lake

import badlog.rules.RuleSet
import badlog.rules.toJson
import badlog.season.lake.LakeChange
import badlog.season.lake.LakeException
import badlog.season.lake.LakeInventory
import badlog.season.lake.LakeLayout
import badlog.season.lake.LakePlan
import badlog.season.lake.LogSource
import badlog.season.lake.RegisteredLog
import badlog.spark.storage.RemoteFolder
import badlog.spark.storage.RemoteLog
import badlog.spark.storage.addressOf
import badlog.spark.storage.logsIn
import badlog.spark.storage.withoutChecksums
import org.apache.hadoop.fs.Path
import org.apache.spark.HashPartitioner
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.util.SerializableConfiguration
import scala.Tuple2
import java.io.IOException

/**
 * A file that is not in the lake.
 *
 * @property path its address.
 * @property message the reason, as a sentence.
 * @property isNoLog whether it is something other than a log.
 */
public class RefusedLog internal constructor(public val path: String, public val message: String, public val isNoLog: Boolean)

/**
 * The outcome for folders of logs.
 *
 * @property written the number of logs written.
 * @property salvaged the number of written logs with lost data.
 * @property unchanged the number of logs that were already in the lake.
 * @property removed the number of logs removed from the lake because their files are gone.
 * @property refused the files that are not in the lake, in no particular order.
 */
public class SparkLakeResult internal constructor(
    public val written: Int,
    public val salvaged: Int,
    public val unchanged: Int,
    public val removed: Int,
    public val refused: List<RefusedLog>,
)

/**
 * A lake made by a cluster, on any file system that Spark supports. `docs/season.md` specifies its files; they are the same as in
 * [badlog.season.lake.Lake]. Only one program at a time may write to it.
 *
 * @param address the address of its folder, accessible to all machines of the cluster.
 * @param hasSamples false to write only the tables of all logs: enough for findings of rules, and much less data.
 */
public class SparkLake(private val spark: JavaSparkContext, private val address: String, private val hasSamples: Boolean = true) {
    private val configuration = SerializableConfiguration(spark.hadoopConfiguration())
    private val lake = RemoteFolder(address, configuration, LakeLayout.DRAFT)

    /**
     * Updates the lake to the current state of the logs below [folders]. Only changed logs are read. Each log is a task of its own, up to
     * [MAX_TASKS] tasks. A lost task is repeated and leaves no partial files. The driver receives only names and counts, never samples.
     *
     * @param folders addresses of folders or files, on any file system; the address of a lake means the logs from which it was made.
     * @param rules the rules for findings, and the names of topics.
     * @param maxBytes the size of the largest file to read, in bytes; a log needs about 3 times as much memory, a compressed one 15 times.
     * @throws LakeException if the address is not a lake, or a folder cannot be listed.
     */
    public fun refresh(folders: List<String>, rules: RuleSet, maxBytes: Long = Long.MAX_VALUE): SparkLakeResult {
        try {
            requireLakeOrEmpty()
            val work = LakeWork(rules.toJson(), hasSamples)
            val files = dropDrafts(lake.files())
            val inventory = inventory(files, work)
            val logs = folders.flatMap(::logsOf).distinctBy { it.source.path }
            val (small, large) = logs.partition { it.source.size <= maxBytes }
            val isBelow = belowAny(folders)
            // A log that is too large now stays in the lake. It may have been read with a higher limit.
            val isGone = large.mapTo(HashSet()) { it.source.path }.let { kept -> { path: String -> path !in kept && isBelow(path) } }
            val plan = inventory.plan(small.map { it.source }, ExecutorPieces.of(work).maker, isGone) { it in files }
            val outcomes = if (plan.changed.isEmpty() && plan.gone.isEmpty()) emptyList() else run(plan, small, work)
            val all = outcomes.filter { it.message != null }.map { RefusedLog(it.path, it.message!!, it.isNoLog) } +
                plan.ignored.map { (log, why) -> RefusedLog(log.path, why, true) }
            if (outcomes.isNotEmpty() || LakeLayout.MARK !in files) mark(inventory, small.map { it.source }, all)
            val tooLarge = large.map { RefusedLog(it.source.path, tooLargeFor(maxBytes), false) }
            val written = outcomes.filter { it.message == null }
            return SparkLakeResult(
                written.size,
                written.count { it.isSalvaged },
                small.size - plan.changed.size - plan.ignored.size,
                plan.gone.size,
                all + tooLarge,
            )
        } catch (e: IOException) {
            throw LakeException(
                "The lake $address cannot be made (${e.message}); see that this program may read the logs and write there.",
                e,
            )
        }
    }

    /** Requires a lake, or an empty folder for a new one: a lake must not be mixed with other files. */
    private fun requireLakeOrEmpty() {
        if (lake.has(LakeLayout.MARK)) return
        if (lake.entries().any { !it.startsWith(".") }) {
            throw LakeException("$address has other files in it; name an empty folder, or a new one.")
        }
        // The mark is written first, so that an interrupted run also leaves a lake.
        lake.put(LakeInventory.of(address, null, emptyList()).markAfter(emptyList(), emptyMap()), LakeLayout.MARK)
    }

    private fun inventory(files: Set<String>, work: LakeWork): LakeInventory =
        LakeInventory.of(address, lake.text(LakeLayout.MARK), registeredIn(lake, files, work))

    private fun registeredIn(lake: RemoteFolder, files: Set<String>, work: LakeWork): List<RegisteredLog> {
        val tables = files.filter(ReadRegister::isMatches).sorted()
        if (tables.isEmpty()) return emptyList()
        return spark.parallelize(tables, minOf(tables.size, MAX_TASKS)).flatMap(ReadRegister(lake, work)).collect()
    }

    /** Returns the logs in [folder]; if it is a lake, the logs that it was made of. */
    private fun logsOf(folder: String): List<RemoteLog> {
        val other = RemoteFolder(folder, configuration, LakeLayout.DRAFT)
        if (!other.has(LakeLayout.MARK)) return logsIn(folder, configuration.value())
        val work = LakeWork(RuleSet.NONE.toJson(), hasSamples)
        val named = registeredIn(other, other.files(), work).associateBy { it.path }
        return named.keys.mapTo(LinkedHashSet()) { it.substringBeforeLast('/') }
            .flatMap { logsIn(it, configuration.value(), isDeep = false) }
            .mapNotNull { log -> named[log.source.path]?.let { RemoteLog(log.source.copy(name = it.log), log.files) } }
    }

    private fun belowAny(folders: List<String>): (String) -> Boolean {
        val tops = folders.map { folder ->
            val path = Path(folder)
            addressOf(withoutChecksums(path.getFileSystem(configuration.value())).makeQualified(path)).removeSuffix("/")
        }
        return { path -> tops.any { path == it || path.startsWith("$it/") } }
    }

    private fun run(plan: LakePlan, logs: List<RemoteLog>, work: LakeWork): List<LogOutcome> {
        val byPath = logs.associateBy { it.source.path }
        // The largest first, so that no large log runs alone at the end.
        val plans = plan.changed.map { RemotePlan(it, byPath.getValue(it.source.path)) }.sortedByDescending { it.planned.source.size }
        val written = spark.parallelize(plans, plans.size.coerceIn(1, MAX_TASKS)).flatMapToPair(WriteLog(lake, work, configuration))
        val gone = plan.gone.map { Tuple2(it.partitionPath, LogPiece(LakeChange.Remove(it), null)) }
        val pieces = written.union(spark.parallelizePairs(gone, 1))
        val tables = (plans.size / LOGS_PER_TABLE_TASK).coerceIn(spark.defaultParallelism(), MAX_TABLE_TASKS)
        val outcomes = pieces.repartitionAndSortWithinPartitions(HashPartitioner(tables)).mapPartitions(WriteTables(lake, work)).collect()
        for (file in outcomes.flatMap { it.obsolete } + plan.gone.flatMap { it.files }) lake.delete(file)
        dropDrafts(lake.files())
        return outcomes
    }

    /** Deletes the drafts of killed tasks among [files]. Returns the other files. */
    private fun dropDrafts(files: Set<String>): Set<String> {
        val (drafts, whole) = files.partition { it.substringAfterLast('/').startsWith(LakeLayout.DRAFT) }
        drafts.forEach(lake::delete)
        return whole.toSet()
    }

    private fun mark(inventory: LakeInventory, logs: List<LogSource>, refused: List<RefusedLog>) {
        val reasons = refused.filter { it.isNoLog }.associate { it.path to it.message }
        val ignored = logs.filter { it.path in reasons }.associateWith { reasons.getValue(it.path) }
        lake.put(inventory.markAfter(logs, ignored), LakeLayout.MARK)
    }

    private fun tooLargeFor(bytes: Long) =
        "It is larger than the limit of ${bytes shr MEGA} MB; raise --max-size, and give executors the memory for it."

    public companion object {
        /** The number of tasks that Spark's driver can track in its default memory; with more logs, a task has several. */
        public const val MAX_TASKS: Int = 100_000

        private const val LOGS_PER_TABLE_TASK = 200
        private const val MAX_TABLE_TASKS = 2_000
        private const val MEGA = 20
    }
}
