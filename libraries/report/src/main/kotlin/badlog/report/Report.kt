package badlog.report

import badlog.catalog.examine.ExaminedLog
import badlog.catalog.examine.LogContent
import badlog.catalog.examine.RuleExamination
import badlog.catalog.examine.UndefinedTopic
import badlog.catalog.store.CachedResult
import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.exporter.BADLOG_VERSION
import badlog.files.FolderRun
import badlog.files.LogFile
import badlog.files.LogMaker
import badlog.files.ReadOptions
import badlog.report.hook.HookOutcome
import badlog.report.hook.HookRunner
import badlog.rules.BUILT_IN
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.SkippedRule
import badlog.rules.comparison.LogDifferences
import badlog.rules.comparison.LogOfFolder
import badlog.rules.comparison.compared
import badlog.rules.comparison.restartsIn
import badlog.rules.incident.incidentsIn
import badlog.rules.number.LogNumbers
import badlog.rules.number.LogNumbersReader
import badlog.rules.worstFirst
import badlog.signals.overItsTime
import java.nio.file.Path

/**
 * Runs rules, and hooks of the user, over many logs.
 *
 * @param rules the rules to run.
 * @param hooks programs to run for each log; their findings join the rules' findings.
 * @param virtualTopics definitions of topics that the rules may use beside a log's own, such as `Power = Voltage * Current`.
 * @param cache a folder for cached results, so that an unchanged file is not read again; null for none. Results of hooks are not
 *   cached, because their dependencies are unknown.
 * @param xTopic the topic to use as x axis, which plain CSV does not name; null for the log's own, or its column of time.
 * @param beside returns the view on which rules run: usually the given one, or the given one with another log added. Called on many
 *   threads; the findings are then not cached.
 * @param maker makes one log from a file that contains several; null if such files are not read.
 * @param measures whether the numbers of each log are needed even if no rule compares logs.
 */
class Report(
    private val rules: RuleSet = RuleSet.BUILT_IN,
    private val hooks: List<HookRunner> = emptyList(),
    private val virtualTopics: List<String> = emptyList(),
    private val cache: Path? = null,
    private val xTopic: String? = null,
    private val beside: ((LogFile, LogView) -> LogView)? = null,
    measures: Boolean = false,
    private val maker: LogMaker? = null,
) {
    private val examination = RuleExamination(
        rules,
        (virtualTopics + listOfNotNull(xTopic?.let { "x $it" })).joinToString("\n"),
        measures || rules.comparisons.isNotEmpty(),
    )

    /**
     * Runs the rules over each of [files], on all cores. Then compares the logs with each other, and runs the hooks.
     *
     * @param progress called on this thread with the number of files done, several times a second. With hooks or [each], which are the
     *   second half of the work, each file counts twice.
     * @param each receives each result and the outcomes of its hooks on this thread, once all logs were compared; null for nothing. The
     *   outcomes are not kept in memory afterwards. An exception from it or from [progress] stops the work and is passed on.
     * @throws InterruptedException if the thread was interrupted.
     */
    fun over(
        files: List<LogFile>,
        progress: (done: Int, total: Int) -> Unit = { _, _ -> },
        each: ((LogReport, List<HookOutcome>) -> Unit)? = null,
    ): ReportResult {
        val examined = ArrayList<ExaminedLog>(files.size)
        val total = if (hooks.isEmpty() && each == null) files.size else files.size * 2
        val known = cache?.takeIf { beside == null }?.let { examination.storedIn(it, BADLOG_VERSION) }
        runCached(files, known, ::examine, { progress(examined.size, total) }) { _, stored ->
            examined += stored
            progress(examined.size, total)
        }
        val reader = LogNumbersReader()
        val numbers = examined.map { it.numbers(reader) }
        val skipped = SkippedRules(rules)
        val differences = rules.compared(
            numbers.mapIndexed { i, own -> if (skipped.of(examined[i].asked).any { it.simulated != null }) LogNumbers.NONE else own },
        )
        val restarts = rules.restartsIn(examined.mapIndexed { i, log -> LogOfFolder(files[i].name, log.title, numbers[i], log.findings) })
        val logs = ArrayList<LogReport>(files.size)
        val advance = { if (total > files.size) progress(files.size + logs.size, total) }
        withHooks(files, examined, advance) { file, outcomes ->
            val place = logs.size
            val own = examined[place].findings + listOfNotNull(restarts[place])
            val log = reportOf(file, examined[place], own, skipped.of(examined[place].asked), numbers[place], differences[place], outcomes)
            logs += log
            each?.invoke(log, outcomes.map { it.first })
            advance()
        }
        return ReportResult(logs, skipped.ofAll(examined.map { it.asked }, logs.count { it.unreadable == null }))
    }

    /** Passes each of [files], which were [examined], to [each] with the results and findings of the hooks. */
    private fun withHooks(
        files: List<LogFile>,
        examined: List<ExaminedLog>,
        waiting: () -> Unit,
        each: (LogFile, List<Pair<HookOutcome, List<Finding>>>) -> Unit,
    ) {
        if (hooks.isEmpty()) return files.forEach { each(it, emptyList()) }
        val unreadable = files.zip(examined).filter { (_, stored) -> stored.unreadable != null }.mapTo(HashSet()) { (file, _) -> file }
        val run = { file: LogFile, cores: Int ->
            if (file in unreadable) {
                emptyList()
            } else {
                LogContent.examined(file, virtualTopics, rules.signals, {
                    it.overX(file)
                }, ReadOptions(cores = cores, maker = maker)) { content ->
                    if (content !is LogContent.Log) return@examined emptyList()
                    hooks.map { hook -> HookOutcome.of(hook, content.recording).let { it to it.findings(content.view.xAxis.unit) } }
                }
            }
        }
        FolderRun().forEach(files, run, waiting, each)
    }

    private fun reportOf(
        file: LogFile,
        stored: ExaminedLog,
        own: List<Finding>,
        skipped: List<SkippedRule>,
        numbers: LogNumbers,
        differences: LogDifferences,
        outcomes: List<Pair<HookOutcome, List<Finding>>>,
    ): LogReport {
        val ofHooks = outcomes.flatMap { (_, findings) -> findings }
        return LogReport(
            file = file,
            title = stored.title,
            matchType = stored.matchType,
            match = stored.match,
            began = stored.began,
            findings = (own + differences.findings + ofHooks).worstFirst(),
            incidents = rules.incidentsIn(own, differences.differences),
            skipped = skipped,
            unreadable = stored.unreadable,
            isNoLog = stored.isNoLog,
            isSalvaged = stored.isSalvaged,
            undefined = stored.undefined,
            hookFailures = outcomes.mapNotNull { (hook, _) -> hook.failure?.let { HookFailure(hook.hook, it.message) } },
            numbers = numbers,
            differences = differences,
            battery = stored.battery,
            ran = stored.asked.size - skipped.size,
        )
    }

    private fun examine(file: LogFile, cores: Int): CachedResult<ExaminedLog> = LogContent.examined(
        file,
        virtualTopics,
        rules.signals,
        { it.overX(file) },
        ReadOptions(cores = cores, maker = maker),
        beside = beside ?: { _, view -> view },
    ) { examination.of(it, file.name) }

    private fun Recording.overX(file: LogFile) = if (xTopic == null) overItsTime() else withX(xTopic, file.path)
}
