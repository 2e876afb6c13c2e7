package badlog.cli.open

import badlog.cli.command.LogCommand
import badlog.cli.command.Task
import badlog.cli.computer.Computer
import badlog.exporter.EmptyPage
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option

internal class OpenCommand(private val computer: Computer) :
    LogCommand(
        "open",
        "Opens a log or a folder of logs in the window.",
        "If the window is not installed, opens the page of the log, or of the newest log in the folder, in the browser. The page is kept " +
            "in the cache until the next one of the same name. Of the standard input (-), the page opens in any case. ${Computer.WINDOW} " +
            "names the window's program if it is not where the installer puts it.",
        logHelp = "A log, or a folder of logs.",
        needsLog = false,
    ) {
    private val isPage by option("--page").flag().help("Open the page, even if the window is installed.")

    private val isBrowser by option("--browser").flag()
        .help("Open ${EmptyPage.NAME}, a page that opens any logs and folders.")

    private val isPit by option(
        "--pit",
    ).flag().help("Open the pit view: the last logs in large letters.")

    override val examples: List<String> =
        listOf("open match.bag", "open logs", "open match.bag --page", "open --browser", "open logs --pit")

    override fun makeTask(): Task {
        if (isPit && isBrowser) throw UsageError("--browser and --pit cannot be used together, since the pit view is a part of the window")
        if (isBrowser && paths.size < 2) return OpenBrowserTask(paths.singleOrNull(), computer, isJson)
        val path = paths.singleOrNull() ?: throw UsageError("name one log or one folder to open")
        if (isPit && isPage) throw UsageError("--page and --pit cannot be used together, since the pit view is a part of the window")
        return OpenTask(path, isPage, isPit, computer, isJson)
    }
}
