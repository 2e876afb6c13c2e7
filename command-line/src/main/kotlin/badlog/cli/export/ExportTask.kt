package badlog.cli.export

import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcome
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.input.LogInput
import badlog.cli.merge.MatchChoice
import badlog.cli.merge.matched
import badlog.cli.output.OutputPlan
import badlog.cli.search.Search
import badlog.cli.search.SearchException
import badlog.cli.search.signalsBeside
import badlog.cli.text.counted
import badlog.cli.text.json
import badlog.cli.text.jsonOf
import badlog.cli.text.lossLines
import badlog.cli.text.undefinedLines
import badlog.cli.text.wrapped
import badlog.core.analysis.LogView
import badlog.exporter.ExportException
import badlog.exporter.HtmlExporter
import badlog.exporter.fieldFor
import badlog.exporter.layoutFor
import badlog.exporter.videoFor
import badlog.expression.undefinedTopics
import badlog.files.LogMaker
import badlog.files.NotReadException
import badlog.files.UnreadableFileException
import badlog.files.requireRegularFile
import badlog.files.terminal.Progress
import badlog.protocol.PageAdditions
import badlog.report.HookFailureJson
import badlog.report.SkippedJson
import badlog.report.UndefinedJson
import badlog.report.page.hookParts
import badlog.rules.SkippedRule
import badlog.rules.folder.FolderRules
import badlog.rules.skippedFor
import badlog.signals.namesWith
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Files
import java.nio.file.Path

/**
 * Makes a page of each log, one after the other, because each uses all cores.
 *
 * @param compared logs that each page draws over its own.
 * @param video a video of the match of the only log; null for none.
 * @param search the rules of the pages, and the hooks to run on the logs.
 * @param field the field of all pages; null for those beside the logs.
 * @param match the choice of logs that are read as one.
 */
internal class ExportTask(
    private val paths: List<Path>,
    private val plan: OutputPlan,
    private val attachments: List<Path>,
    private val compared: List<Path>,
    private val video: Path?,
    private val search: Search,
    private val isJson: Boolean,
    private val field: Path? = null,
    private val match: MatchChoice = MatchChoice.AsTheyAre,
) : Task {
    override fun run(console: Console): ExitCode = matched("export", paths, match, console, isJson, ::run)

    private fun run(paths: List<Path>, maker: LogMaker, console: Console): ExitCode {
        try {
            (attachments + compared + listOfNotNull(video)).forEach(::requireRegularFile)
        } catch (e: UnreadableFileException) {
            console.warn(e.message)
            return ExitCode.NOTHING
        }
        field?.let { fieldFor(it, it).problem }?.let {
            console.warn(it)
            return ExitCode.USAGE
        }
        if (video != null && (paths.size > 1 || Files.isDirectory(paths[0]))) {
            console.warn("--video shows one match; name only its log.")
            return ExitCode.USAGE
        }
        val named = try {
            search.namedRules()
        } catch (e: SearchException) {
            console.warn(e.message)
            return ExitCode.USAGE
        }
        val hooks = search.hooksWith(named)
        val exporter = HtmlExporter(attachments, compared, maker = maker)
        val refused = ArrayList<List<SkippedRule>>()
        val code = LogLoop("export", console, isJson, opensMatches = true).run(paths) { input, progress ->
            val rules = if (named == null) rulesBeside(input.file, console) else null
            val all = rules?.rules ?: checkNotNull(named).rules.with(signalsBeside(input.file))
            val layout = layoutFor(input.file, all.signals)
            val ground = fieldFor(input.file, field)
            for (problem in listOfNotNull(layout.problem, ground.problem)) if (problemsBeside.add(problem)) console.warn(problem)
            val additions = PageAdditions(search.virtualTopics, all, rules?.problem, layout = layout.text, field = ground.json)
            // Without hooks, the log need not be read before it is embedded in a page.
            if (hooks.isEmpty()) return@run export(exporter, input, additions, rules, PageFindings.NONE, refused, progress)
            val found = PageFindings.of(input.file, hooks, maker) { done, total -> progress.advanced(done, total * 2) }
            export(exporter, input, additions, rules, found, refused) { done, total -> progress.advanced(total + done, total * 2) }
        }
        return if (search.skippedForAll(refused).any { it.isMistake }) ExitCode.USAGE else code
    }

    private val problemsBeside = HashSet<String>()
    private val rulesOfFolder = HashMap<Path, FolderRules>()

    private fun rulesBeside(log: Path, console: Console): FolderRules = rulesOfFolder.getOrPut(log.toAbsolutePath().normalize().parent) {
        FolderRules.of(log).also { rules -> rules.problem?.let(console::warn) }
    }

    private fun export(
        exporter: HtmlExporter,
        input: LogInput,
        own: PageAdditions,
        folder: FolderRules?,
        found: PageFindings,
        refused: MutableList<List<SkippedRule>>,
        progress: Progress,
    ): Outcome {
        val name = "${input.file.fileName}.html"
        val target = plan.place(input, name, name)
        val additions = own.run {
            val hookParts = hookParts(found.hooks)
            PageAdditions(
                virtualTopics,
                rules,
                rulesProblem,
                hooks = hookParts,
                layout = layout,
                field = field,
                video = this@ExportTask.video?.let { videoFor(target, it) },
            )
        }
        val report = try {
            exporter.export(input.file, target, additions, progress)
        } catch (e: ExportException.NotARecording) {
            throw NotReadException(e.why)
        }
        val view = LogView.of(report.recording)
        val undefined = undefinedTopics(view.namesWith(own.rules.signals), search.virtualTopics)
        val skipped = own.rules.skippedFor(view, input.file.fileName.toString(), search.virtualTopics)
        refused += skipped
        val reported = search.reportedOf(skipped)
        val text = listOf("${input.file} -> $target") +
            (listOfNotNull(folder?.file) + folder?.packs.orEmpty()).map { wrapped("  ", "with the rules of $it") } +
            listOfNotNull(own.field?.let { "  with the picture of a field, ${it.length / BYTES} kB" }) +
            listOfNotNull(found.count?.let { "  " + counted(it.toLong(), "finding") + " of hooks" }) +
            listOfNotNull(found.unreadable?.let { wrapped("  ", "no hook was run: $it") }) +
            reported.flatMap { it.toString().lines() }.map { "  $it" } +
            undefinedLines(undefined) +
            found.failures.map { (hook, failure) -> wrapped("  ", "hook “$hook”: ${failure.message}") } +
            lossLines(report.recording.problems)
        val json = mapOf(
            "output" to JsonPrimitive(target.toString()),
            "rows" to JsonPrimitive(report.recording.rowCount),
            "rulesFile" to JsonPrimitive(folder?.file?.toString()),
            "rulePacks" to JsonArray(folder?.packs.orEmpty().map { JsonPrimitive("$it") }),
            "rulesProblem" to JsonPrimitive(folder?.problem),
            "findings" to JsonPrimitive(found.count),
            "findingsError" to JsonPrimitive(found.unreadable),
            "notAsked" to JsonArray(skipped.map { jsonOf(SkippedJson(it)) }),
            "undefined" to JsonArray(undefined.map { jsonOf(UndefinedJson(it)) }),
            "hookFailures" to JsonArray(found.failures.map { (hook, failure) -> jsonOf(HookFailureJson(hook, failure.message)) }),
            "problems" to JsonArray(report.recording.problems.map { json(it) }),
        )
        val isIncomplete =
            found.failures.isNotEmpty() || found.unreadable != null || folder?.problem != null || reported.isNotEmpty() ||
                problemsBeside.isNotEmpty()
        return Outcome(report.recording.isSalvaged || isIncomplete, text.joinToString("\n"), json)
    }
}

/** Bytes per kB. */
private const val BYTES = 1000
