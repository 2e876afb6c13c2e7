package badlog.cli.report

import badlog.catalog.match.MatchMaker
import badlog.cli.command.ExitCode
import badlog.cli.command.LogFiles
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.ResultForm
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.merge.LeftOutLogs
import badlog.cli.merge.MatchChoice
import badlog.cli.merge.matched
import badlog.cli.plugin.ChartService
import badlog.cli.plugin.PluginLoader
import badlog.cli.search.Search
import badlog.cli.search.SearchException
import badlog.cli.search.rulesBeside
import badlog.cli.station.StationLogFinder
import badlog.cli.text.jsonOf
import badlog.exporter.ExportException
import badlog.exporter.HtmlExporter
import badlog.exporter.fieldFor
import badlog.files.LogMaker
import badlog.report.LogReport
import badlog.report.Report
import badlog.report.ReportJson
import badlog.report.ReportResult
import badlog.report.notesOf
import badlog.report.page.PageCharts
import badlog.report.page.ReportFolder
import badlog.report.reportCsv
import badlog.report.reportText
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.match.files.MatchManifest
import java.nio.file.Path
import kotlin.io.path.name

/**
 * Runs rules and hooks over every log below [paths].
 *
 * @param search the rules and hooks to run.
 * @param pagesPlan the requested pages and their index; null for none.
 * @param cache the folder for cached findings; null for none.
 * @param xTopic the topic to use as x axis, or null.
 * @param station the folder to search for Driver Station logs of the same matches, which add to the robot's logs; empty for
 *   the folder of each log, null for none.
 * @param parts finds the service that draws charts.
 * @param match the choice of logs that are read as one.
 */
internal class ReportTask(
    private val paths: List<Path>,
    private val search: Search,
    private val form: ResultForm,
    private val pagesPlan: PagesPlan?,
    private val cache: Path?,
    private val xTopic: String?,
    private val station: Path?,
    private val parts: PluginLoader,
    private val match: MatchChoice = MatchChoice.AsTheyAre,
) : Task {
    override fun run(console: Console): ExitCode = matched("report", paths, match, console, form == ResultForm.JSON, ::run)

    private fun run(paths: List<Path>, maker: LogMaker, console: Console): ExitCode {
        if (pagesPlan?.hasCharts != true) return run(paths, maker, console, charts = null)
        // Whoever lacks the part learns it before all logs are read.
        return parts.call("report --charts", ChartService::class.java, console) { run(paths, maker, console, it) }
    }

    private fun run(paths: List<Path>, maker: LogMaker, console: Console, charts: ChartService?): ExitCode {
        pagesPlan?.field?.let { fieldFor(it, it).problem }?.let {
            console.warn(it)
            return ExitCode.USAGE
        }
        val rules: RuleSet
        val stations: StationLogFinder?
        val made: LeftOutLogs
        val report = try {
            val named = search.namedRules()
            val beside = rulesBeside(paths, console::warn)
            rules = named?.rules?.with(beside.signals) ?: beside
            stations = station?.let { StationLogFinder(it, rules.signals) }
            // Rules use the Driver Station's log only for signals that the robot's lacks.
            made = LeftOutLogs(if (stations == null) maker else MatchMaker)
            Report(
                rules,
                search.hooksWith(named),
                search.virtualTopics,
                // The files of a match may change while its match.json, or the first of them, does not.
                cache.takeIf { maker == MatchMaker && paths.none(::isMatchFolder) },
                xTopic,
                stations?.let { it::over },
                measures = charts != null,
                maker = made,
            )
        } catch (e: SearchException) {
            console.warn(e.message)
            return ExitCode.USAGE
        }
        val logs = LogFiles(paths, console, opensMatches = true)
        val pages = try {
            pagesPlan?.let {
                val exporter = HtmlExporter(maker = maker)
                ReportPages(ReportFolder(it.folder, logs.files, rules, search.virtualTopics, it.isForced, it.field, exporter))
            }
        } catch (e: ExportException) {
            console.warn(e.message.orEmpty())
            return ExitCode.NOTHING
        }
        val result = console.progress("report").use { bar ->
            report.over(logs.files, { done, total -> bar.advanced(done.toLong(), total.toLong()) }, pages?.let { it::add })
        }
        if (result.logs.any { !it.isNoLog }) say(result, console)
        val outcomes = Outcomes("report", console, form == ResultForm.JSON)
        val reportOf = result.logs.associateBy { it.file }
        logs.report(outcomes) { input, file ->
            val log = reportOf.getValue(file)
            val unreadable = log.unreadable
            if (unreadable != null) {
                outcomes.unreadable(input, unreadable, log.isNoLog)
            } else {
                report(log, pages, stations, made, outcomes, console)
            }
        }
        pages?.finish(result, outcomes) { if (charts == null) PageCharts.NONE else drawn(it, charts, console) }
        val refused = result.logs.filter { it.unreadable == null }.map { it.skipped }
        if (search.skippedForAll(refused).isNotEmpty()) outcomes.leaveOut()
        val code = outcomes.end()
        if (form != ResultForm.JSON && pages?.index != null) console.warn("The index is ${pages.index}.")
        return if (result.skipped.any { it.isMistake }) ExitCode.USAGE else code
    }

    private fun isMatchFolder(path: Path) = path.name == MatchManifest.NAME || MatchMaker.manifestIn(path) != null

    private fun drawn(logs: List<LogReport>, charts: ChartService, console: Console): PageCharts {
        val drawn = console.progress("charts").use { bar ->
            charts.chartsOf(logs) { done, total -> bar.advanced(done.toLong(), total.toLong()) }
        }
        if (form != ResultForm.JSON) drawn.lacking.forEach(console::warn)
        return drawn
    }

    private fun report(
        log: LogReport,
        pages: ReportPages?,
        stations: StationLogFinder?,
        made: LeftOutLogs,
        outcomes: Outcomes,
        console: Console,
    ) {
        val failure = pages?.failureOf(log)
        val json = if (form == ResultForm.JSON) {
            jsonOf(ReportJson(log)) + pages?.let { jsonOf(it.json(log)) }.orEmpty() + stations?.jsonOf(log.file).orEmpty() +
                made.jsonOf(log.file.path)
        } else {
            emptyMap()
        }
        if (form != ResultForm.JSON) {
            stations?.sentenceOf(log.file)?.let(console::warn)
            made.of(log.file.path).forEach { console.warn("${log.file.path}: $it") }
        }
        outcomes.done(log.file.path, Outcome(log.isSalvaged || log.hookFailures.isNotEmpty() || failure != null, "", json))
        if (failure != null && form != ResultForm.JSON) console.warn(failure)
    }

    private fun say(result: ReportResult, console: Console) = when (form) {
        ResultForm.TEXT -> console.say(reportText(result, console.width))

        ResultForm.CSV -> {
            console.say(reportCsv(result).trimEnd())
            // They are in no line of CSV.
            notesOf(result).forEach(console::warn)
        }

        ResultForm.JSON -> Unit
    }
}
