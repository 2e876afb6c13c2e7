package badlog.assistant.log

import badlog.assistant.call.ToolException
import badlog.cli.plugin.LakeCache
import badlog.cli.plugin.LakeReport
import badlog.cli.plugin.SeasonException
import badlog.cli.plugin.SeasonService
import badlog.cli.plugin.SqlSession
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import java.nio.file.Path
import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * The tables of [logs], as a lake in the cache. No other command uses this lake, since other lakes may contain linked logs.
 *
 * @param cache the folder for cached answers; lakes are beside it.
 * @param patience the maximum time in s that an assistant waits for the tables. They are made in any case.
 */
internal class LogLake(
    private val logs: LogFolder,
    private val cache: Path,
    private val service: SeasonService,
    private val patience: Long = PATIENCE,
) {
    private var update: LakeUpdate? = null

    /**
     * Lets [ask] query the current logs. [ask] also receives the number of logs that are missing because they cannot be read.
     *
     * @throws ToolException if the tables are not ready, cannot be made, or a query is wrong.
     */
    fun <R> asking(ask: (tables: SqlSession, missing: Int) -> R): R {
        val folder = LakeCache(cache, service.layoutVersion).lakeOf(logs.root, USER)
        try {
            val missing = refreshed(folder).logs.count { it.message != null && !it.isNoLog }
            return service.open(folder, null, isConfined = true).use { ask(it, missing) }
        } catch (e: SeasonException) {
            throw ToolException(e.message.replace("$folder", "of these logs"))
        }
    }

    private fun refreshed(folder: Path): LakeReport {
        val current = update ?: LakeUpdate(folder).also {
            update = it
            it.begin()
        }
        val report = current.await()
        update = null
        return report
    }

    /** An update of the tables to the logs' current state, on a thread of its own. */
    private inner class LakeUpdate(folder: Path) {
        private val all = logs.logs().map { (name, file) -> file to name }
        private val rules = logs.rules()?.rules ?: RuleSet.BUILT_IN

        @Volatile
        private var done = 0
        private val task = FutureTask {
            service.refresh(folder, all, listOf(logs.root), rules, matches = null, isBusy = { true }) { done, _ ->
                this.done =
                    done
            }
        }

        fun begin() = Thread(task, "badlog-lake").apply { isDaemon = true }.start()

        fun await(): LakeReport = try {
            task.get(patience, TimeUnit.SECONDS)
        } catch (_: TimeoutException) {
            throw ToolException("The tables of ${all.size} logs are being made; $done are done. Ask again in a minute.")
        } catch (e: ExecutionException) {
            update = null
            throw e.cause ?: e
        }
    }
}

/** The default of [patience], in s. Most assistants wait for a minute. */
private const val PATIENCE = 40L

/** The name of the user of this lake. */
private const val USER = "mcp"
