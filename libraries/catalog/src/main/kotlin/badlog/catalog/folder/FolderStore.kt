package badlog.catalog.folder

import badlog.catalog.examine.ExaminedLog
import badlog.catalog.examine.RuleExamination
import badlog.catalog.store.ResultCache
import badlog.catalog.store.SummarySerializer
import badlog.files.LogFile
import badlog.rules.RuleSet
import badlog.rules.folder.FolderRules
import badlog.rules.toJson
import badlog.signals.vocabulary.toJson
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.foundIn
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeMark
import kotlin.time.TimeSource

/**
 * The stored summaries of the logs of [folder], and the results of their rules. The rules of a log are in the nearest rules file.
 * Thread-safe.
 *
 * @param cache the folder for stored results; null for none.
 * @param version the version of the program, because another one may have other results.
 */
class FolderStore(private val folder: Path, private val cache: Path?, private val version: String) {
    private class CachedRules(val folderRules: RuleSet, val rules: RulesOfFolder, val since: TimeMark)

    private val byFolder = ConcurrentHashMap<Path, CachedRules>()
    private val summaries = ConcurrentHashMap<String, ResultCache<LogSummary>>()

    /** Returns a key that identifies the rules for [file]. */
    fun keyOf(file: Path): Int = rulesFor(file).key

    /** Returns the known results for [file] in its current state; null if there are none. */
    operator fun get(file: LogFile): LogEntry? {
        val rules = rulesFor(file.path)
        val summary = summariesOf(rules)?.get(file) ?: return null
        return LogEntry(file, summary, rules.found(file))
    }

    /** Stores the [summary] of [file]. */
    operator fun set(file: LogFile, summary: LogSummary) {
        summariesOf(rulesFor(file.path))?.set(file, summary)
    }

    /** Returns the results of the rules for [file] in its current state; null if they have not been run. */
    fun examined(file: LogFile): ExaminedLog? = rulesFor(file.path).results?.get(file)

    /** Writes all changes to the disk. */
    fun save() {
        for (cache in summaries.values) cache.save()
        for (known in byFolder.values) known.rules.results?.save()
    }

    /** Returns the rules for [file]; a changed file of rules may go unnoticed for [REST]. */
    internal fun rulesFor(file: Path): RulesOfFolder {
        val place = file.parent ?: file
        val before = byFolder[place]
        if (before != null && before.since.elapsedNow() < REST) return before.rules
        val rules = FolderRules.of(file, folder).rules
        val same = byFolder.values.firstOrNull { it.folderRules == rules }?.rules
        val now = CachedRules(rules, same ?: RulesOfFolder(rules, cache, version), TimeSource.Monotonic.markNow())
        byFolder[place] = now
        return now.rules
    }

    private fun summariesOf(rules: RulesOfFolder): ResultCache<LogSummary>? {
        val place = cache ?: return null
        return summaries.computeIfAbsent(rules.names) { names ->
            ResultCache(place, "$version\nsummary\n$folder\n$names", SummarySerializer)
        }
    }

    private companion object {
        val REST = 3.seconds
    }
}

/** The [rules] for logs, and their stored results. */
internal class RulesOfFolder(val rules: RuleSet, cache: Path?, version: String) {
    /** A key that identifies the rules. */
    val key: Int = rules.toJson().hashCode()

    /** The rules' vocabulary of signals as JSON; summaries depend on it. */
    val names: String = rules.signals.toJson()

    val examination = RuleExamination(rules, measures = true)
    val results: ResultCache<ExaminedLog>? = cache?.let { examination.storedIn(it, version) }

    /** Returns the findings in [file]; null if unknown. */
    fun found(file: LogFile): FindingSummary? = results?.get(file)?.let(::foundIn)

    /** Returns the findings in [log]. */
    fun foundIn(log: ExaminedLog): FindingSummary =
        if (log.unreadable == null) rules.foundIn(log.findings, key) else FindingSummary(key, null)
}
