package badlog.cli.export

import badlog.cli.command.LogCommand
import badlog.cli.command.Task
import badlog.cli.command.VirtualTopicOption
import badlog.cli.merge.MatchOptions
import badlog.cli.output.OutputOptions
import badlog.cli.search.HookOptions
import badlog.cli.search.SearchOptions
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.path

internal class ExportCommand :
    LogCommand(
        "export",
        "Makes a web page of each log.",
        "A page opens from disk and needs nothing else. Without --out, the page of match.bag is match.bag.html beside it. The page " +
            "runs rules: those of --rules, else of badlog-rules.toml beside the log, else the built-in ones.",
    ) {
    private val output by OutputOptions()
    private val attachments by option("-a", "--attach", metavar = "FILE").path().multiple()
        .help("Include this file in each page; may be repeated.")
    private val compared by option("--compare", metavar = "LOG").path().multiple()
        .help("Draw this log over the page's own; may be repeated.")
    private val field by option("--field", metavar = "FILE").path()
        .help("WPILib's field file; default: field.json beside the log.")
    private val video by option("--video", metavar = "FILE").path()
        .help("Show this video, which must be beside the page.")
    private val search by SearchOptions()
    private val hooks by HookOptions()
    private val virtual by VirtualTopicOption()
    private val match by MatchOptions()

    override val examples: List<String> = listOf(
        "export match.bag",
        "export logs --out pages/",
        "export match.bag --with-ds=ds-logs",
        "export match.bag --compare other.bag",
        "export match.bag --rules my-rules.toml --attach notes.txt",
    )

    override fun makeTask(): Task = ExportTask(
        paths,
        output.plan(paths, match.isOne, match.station),
        attachments,
        compared,
        video,
        search.search(hooks, virtual.definitions),
        isJson,
        field,
        match.choice(paths, isJson),
    )
}
