package badlog.season.lake

import badlog.core.text.freeName
import java.io.Serializable

/**
 * A new or changed log that has to be written to a lake.
 *
 * @property log its name in the lake.
 * @property former its former state in the lake; null if it is new.
 */
class PlannedLog internal constructor(val source: LogSource, val log: String, val former: RegisteredLog?) : Serializable

/**
 * The changes that bring a lake up to date.
 *
 * @property changed the logs to write, in their given order.
 * @property gone the logs to remove because their files are gone.
 * @property ignored the files that are known not to be logs, with the reasons.
 */
class LakePlan internal constructor(val changed: List<PlannedLog>, val gone: List<RegisteredLog>, val ignored: Map<LogSource, String>)

/** The known state of a lake before a run. */
class LakeInventory internal constructor(private val mark: LakeMark, registered: List<RegisteredLog>) {
    private val registered = registered.associateBy { it.path }

    /**
     * Returns the changes that bring the lake up to date with [logs], for the [LakePieces.maker] [maker].
     *
     * @param isInScope returns whether the folder of a path was searched; a known log there is gone unless it is among [logs].
     * @param exists returns whether the lake has a file, by its path relative to the lake.
     */
    fun plan(logs: List<LogSource>, maker: String, isInScope: (String) -> Boolean, exists: (String) -> Boolean): LakePlan {
        val marked = mark.ignored.associateBy { it.path }
        val ignored = LinkedHashMap<LogSource, String>()
        val changed = logs.filter { log ->
            val former = registered[log.path]
            val other = marked[log.path]?.takeIf { it.isOf(log) }
            if (former?.isOf(log, maker) == true && former.files.all(exists)) return@filter false
            if (other != null) ignored[log] = other.message
            other == null
        }
        val here = logs.mapTo(HashSet()) { it.path }
        return LakePlan(named(changed), registered.values.filter { it.path !in here && isInScope(it.path) }, ignored)
    }

    private fun named(logs: List<LogSource>): List<PlannedLog> {
        val taken = registered.values.mapTo(HashSet()) { it.log.lowercase() }
        return logs.map { log ->
            val former = registered[log.path]
            PlannedLog(log, former?.log ?: freeName(log.name) { taken.add(it.lowercase()) }, former)
        }
    }

    /**
     * Returns the text of the lake's [mark][LakeLayout.MARK] after a run over [logs]. [ignored] holds the files that are not logs, with the
     * reasons.
     */
    fun markAfter(logs: List<LogSource>, ignored: Map<LogSource, String>): String = mark.after(logs, ignored).text

    companion object {
        /**
         * Returns the state of the lake [folder] with the logs [registered].
         *
         * @param mark the content of its [mark][LakeLayout.MARK]; null for a new lake.
         *
         * @throws LakeException if another version of badlog wrote it, or [mark] cannot be parsed.
         */
        fun of(folder: String, mark: String?, registered: List<RegisteredLog>): LakeInventory =
            LakeInventory(mark?.let { LakeMark.of(it, folder) } ?: LakeMark(), registered)
    }
}

private const val serialVersionUID = 1L
