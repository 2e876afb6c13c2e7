package badlog.cli.open

import badlog.cli.command.ExitCode
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.computer.Computer
import badlog.cli.console.Console
import badlog.cli.export.ExportTask
import badlog.cli.input.LogSearch
import badlog.cli.output.OutputPlan
import badlog.cli.search.Search
import badlog.files.ResultPlace
import badlog.files.missingSentence
import badlog.files.terminal.browserCommand
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.div

/**
 * Opens [path] in the window of [computer], or the page of its newest log in the browser.
 *
 * @param isPage whether to always open the page.
 * @param isPit whether to open the window's pit view.
 */
internal class OpenTask(
    private val path: Path,
    private val isPage: Boolean,
    private val isPit: Boolean,
    private val computer: Computer,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val outcomes = Outcomes("open", console, isJson)
        if (Files.exists(path)) open(outcomes, console) else outcomes.failed(path, missingSentence("$path"))
        return outcomes.end()
    }

    private fun open(outcomes: Outcomes, console: Console) {
        // The window would read the standard input's file when that is gone; a page has it inside.
        val window = if (isPage || console.isStandIn(path)) null else computer.window()
        if (window != null) {
            val program = listOf(window.toString(), path.toAbsolutePath().normalize().toString())
            if (computer.start(if (isPit) program + "--pit" else program)) {
                return outcomes.opened(path, "window", "Opened $path in the window.")
            }
            if (!isPit) console.warn("The window, $window, cannot be started; opening the page instead.")
        }
        if (isPit) {
            val isInput = console.isStandIn(path)
            val why = if (isInput) {
                "has no standard input; name a folder of logs"
            } else {
                "cannot be started; “badlog doctor” says whether it is installed"
            }
            return outcomes.failed(path, "The pit view is a part of the window, which $why.")
        }
        openPage(outcomes, console)
    }

    private fun openPage(outcomes: Outcomes, console: Console) {
        val log = newest(outcomes) ?: return
        val page = computer.folders.cache / "pages" / "${log.fileName}.html"
        val plan = OutputPlan(ResultPlace.of("$page"), listOf(log), isForced = true)
        val search = Search(null, isWithoutRules = false, emptyList(), emptyList())
        val code = ExportTask(listOf(log), plan, emptyList(), emptyList(), null, search, isJson = false).run(console.withoutResults())
        // The page itself reports lost data.
        if (code == ExitCode.NOTHING || code == ExitCode.USAGE) {
            return outcomes.failed(log, "The page of $log was not made, so it cannot be opened.")
        }
        val address = page.toAbsolutePath().toUri().toString()
        if (!computer.start(browserCommand(computer.system) + address)) {
            return outcomes.failed(log, "No browser can be started; open $page yourself.")
        }
        outcomes.opened(log, "page", "Opened the page of $log in the browser.", code == ExitCode.SALVAGED)
    }

    /** Returns the log that was written last; null if there is none, which is reported. */
    private fun newest(outcomes: Outcomes): Path? {
        val found = LogSearch().find(listOf(path))
        for (failure in found.failures) outcomes.failed(failure.file, failure.message)
        return found.inputs.maxByOrNull { it.seen?.modified ?: 0 }?.file
    }

    private fun Outcomes.opened(what: Path, where: String, sentence: String, isSalvaged: Boolean = false) =
        done(what, Outcome(isSalvaged, sentence, mapOf("opened" to JsonPrimitive(where))))
}
