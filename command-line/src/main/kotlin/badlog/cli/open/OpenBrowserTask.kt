package badlog.cli.open

import badlog.cli.command.ExitCode
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.computer.Computer
import badlog.cli.console.Console
import badlog.exporter.EmptyPage
import badlog.exporter.ExportException
import badlog.files.terminal.browserCommand
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Path
import kotlin.io.path.div

/**
 * Opens the page without a log in the browser of [computer].
 *
 * @param folder the folder for the user to open there, since a browser lets only a person do that; null for none.
 */
internal class OpenBrowserTask(private val folder: Path?, private val computer: Computer, private val isJson: Boolean) : Task {
    override fun run(console: Console): ExitCode {
        val outcomes = Outcomes("open", console, isJson)
        val page = computer.folders.cache / "pages" / EmptyPage.NAME
        try {
            EmptyPage().write(page)
            open(page, outcomes)
        } catch (e: ExportException) {
            outcomes.failed(page, e.message.orEmpty())
        }
        return outcomes.end()
    }

    private fun open(page: Path, outcomes: Outcomes) {
        if (!computer.start(browserCommand(computer.system) + page.toAbsolutePath().toUri().toString())) {
            return outcomes.failed(page, "No browser can be started; open $page yourself.")
        }
        val next = folder?.let { " Choose or drop $it there." }.orEmpty()
        outcomes.done(page, Outcome(false, "Opened $page in the browser.$next", mapOf("opened" to JsonPrimitive("page"))))
    }
}
