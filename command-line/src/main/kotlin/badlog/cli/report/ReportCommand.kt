package badlog.cli.report

import badlog.cli.command.LogCommand
import badlog.cli.command.ResultForm
import badlog.cli.command.Task
import badlog.cli.command.VirtualTopicOption
import badlog.cli.merge.MatchOptions
import badlog.cli.plugin.PluginLoader
import badlog.cli.search.HookOptions
import badlog.cli.search.SearchOptions
import badlog.files.UserFolders
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.path
import java.nio.file.Path

internal class ReportCommand(private val parts: PluginLoader) :
    LogCommand(
        "report",
        "Runs rules over every log.",
        "Without --rules, the built-in rules: brownouts, slow loops, gaps, flat sensors and the like.",
    ) {
    private val search by SearchOptions()
    private val hooks by HookOptions()
    private val virtual by VirtualTopicOption()
    private val isCsv by option("--csv").flag().help("Print a line of CSV for each finding.")
    private val folder by option("--out", metavar = "DIR").path()
        .help("Also write a page per log and an index.html there.")
    private val hasCharts by option("--charts").flag().help("Also draw charts of all matches there: SVG, PNG.")
    private val field by option("--field", metavar = "FILE").path()
        .help("WPILib's field file; default: field.json beside the log.")
    private val isForced by option("--force").flag().help("Replace files that badlog did not make, but never a log.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Use this topic as x axis; CSV does not name one.")
    private val match by MatchOptions()
    private val isFresh by option("--no-cache").flag().help("Read every log again, and store no results.")

    override val examples: List<String> = listOf(
        "report logs",
        "report logs --out report/",
        "report logs --out report/ --charts",
        "report logs --rules my-rules.toml --csv",
    )

    override fun makeTask(): Task {
        val form = ResultForm.of(isCsv, isJson)
        if (xTopic != null && folder != null) {
            throw UsageError(
                "--x and --out cannot be used together, since pages show logs as they are; make bags of them with convert --x first",
            )
        }
        if (xTopic != null && match.isOne) throw UsageError("--x cannot be used together with --align or --offset; merge the logs first")
        if (field != null && folder == null) throw UsageError("--field needs --out, since only pages draw a field")
        if (hasCharts && folder == null) throw UsageError("--charts needs --out, since charts are files beside the index")
        return ReportTask(
            paths,
            search.search(hooks, virtual.definitions),
            form,
            folder?.let { PagesPlan(it, isForced, field, hasCharts) },
            if (isFresh) null else UserFolders.ofSystem().answers,
            xTopic,
            match.station.takeUnless { match.isOne },
            parts,
            match.choice(paths, isJson),
        )
    }
}
