package badlog.season.lake

import badlog.core.text.freeName
import java.io.Serializable

/**
 * A log that a lake does not have as it is now.
 *
 * @property log what the lake calls it.
 * @property former what the lake has of it; null for nothing.
 */
class PlannedLog internal constructor(val source: LogSource, val log: String, val former: RegisteredLog?) : Serializable {
    private companion object {
        const val serialVersionUID = 1L
    }
}

/**
 * What has to be done to make a lake have logs as they are now.
 *
 * @property changed what is to be written, in the order of the logs.
 * @property gone what is to be removed: logs whose files are gone.
 * @property ignored the files that are known not to be logs, and why.
 */
class LakePlan internal constructor(val changed: List<PlannedLog>, val gone: List<RegisteredLog>, val ignored: Map<LogSource, String>)

/** What is known of a lake before a run. */
class LakeInventory internal constructor(private val mark: LakeMark, registered: List<RegisteredLog>) {
    private val registered = registered.associateBy { it.path }

    /**
     * Returns what has to be done to make the lake have [logs], as a badlog called [maker] makes them.
     *
     * @param isWanted of the path of a log that the lake has, whether its folder was looked at, so that it is gone unless it is among [logs].
     * @param isThere whether the lake has the file that is called so, seen from its folder.
     */
    fun plan(logs: List<LogSource>, maker: String, isWanted: (String) -> Boolean, isThere: (String) -> Boolean): LakePlan {
        val marked = mark.ignored.associateBy { it.path }
        val ignored = LinkedHashMap<LogSource, String>()
        val changed = logs.filter { log ->
            val former = registered[log.path]
            val other = marked[log.path]?.takeIf { it.isOf(log) }
            if (former?.isOf(log, maker) == true && former.files.all(isThere)) return@filter false
            if (other != null) ignored[log] = other.message
            other == null
        }
        val here = logs.mapTo(HashSet()) { it.path }
        return LakePlan(named(changed), registered.values.filter { it.path !in here && isWanted(it.path) }, ignored)
    }

    private fun named(logs: List<LogSource>): List<PlannedLog> {
        val taken = registered.values.mapTo(HashSet()) { it.log.lowercase() }
        return logs.map { log ->
            val former = registered[log.path]
            PlannedLog(log, former?.log ?: freeName(log.name) { taken.add(it.lowercase()) }, former)
        }
    }

    /** Returns what the lake's [mark][LakeLayout.MARK] says after a run over [logs], of which [ignored] are not logs, and why. */
    fun markAfter(logs: List<LogSource>, ignored: Map<LogSource, String>): String = mark.after(logs, ignored).text

    companion object {
        /**
         * That of the lake [folder], which has [registered] and says [mark] of itself; null for a lake to be.
         *
         * @throws LakeException when another version of badlog wrote it, or [mark] cannot be understood.
         */
        fun of(folder: String, mark: String?, registered: List<RegisteredLog>): LakeInventory =
            LakeInventory(mark?.let { LakeMark.of(it, folder) } ?: LakeMark(), registered)
    }
}
