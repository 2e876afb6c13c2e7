package badlog.cli.lake

import badlog.catalog.match.MatchMaker
import badlog.cli.command.ExitCode
import badlog.cli.command.LogFiles
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.plugin.LakeReport
import badlog.cli.plugin.LakeState
import badlog.cli.plugin.PluginLoader
import badlog.cli.plugin.SeasonException
import badlog.cli.plugin.SeasonService
import badlog.cli.search.rulesBeside
import badlog.cli.text.counted
import badlog.cli.text.jsonOf
import kotlinx.serialization.Serializable
import java.nio.file.Path

/** Makes the lake [out] from every log below [paths]. */
internal class LakeTask(
    private val paths: List<Path>,
    private val out: Path,
    private val parts: PluginLoader,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode = parts.call("lake", SeasonService::class.java, console) { service ->
        val logs = LogFiles(paths, console, opensMatches = true)
        try {
            report(logs, refreshed(service, out, paths, logs, console), console)
        } catch (e: SeasonException) {
            console.warn(e.message)
            ExitCode.NOTHING
        }
    }

    private fun report(logs: LogFiles, lake: LakeReport, console: Console): ExitCode {
        val outcomes = Outcomes("lake", console, isJson)
        val states = logs.files.zip(lake.logs).toMap()
        if (!isJson && lake.logs.any { it.message == null }) console.say(sentenceOf(lake))
        logs.report(outcomes) { input, file ->
            val state = states.getValue(file)
            val message = state.message
            if (message != null) {
                outcomes.unreadable(input, message, state.isNoLog)
            } else {
                outcomes.done(input.file, Outcome(state.isSalvaged, "", if (isJson) jsonOf(LakeJson(state)) else emptyMap()))
            }
        }
        return outcomes.end()
    }

    private fun sentenceOf(lake: LakeReport): String {
        val written = lake.logs.count { it.isWritten }
        val unchanged = lake.logs.count { it.message == null && !it.isWritten }
        val parts = listOfNotNull(
            "${counted(written.toLong(), "log")} written" + damage(lake, isWritten = true),
            if (unchanged > 0) "$unchanged unchanged" + damage(lake, isWritten = false) else null,
            if (lake.removed > 0) "${lake.removed} removed" else null,
        )
        return "$out: ${parts.joinToString()}"
    }

    private fun damage(lake: LakeReport, isWritten: Boolean): String {
        val salvaged = lake.logs.count { it.isSalvaged && it.isWritten == isWritten }
        return if (salvaged > 0) " ($salvaged with data missing)" else ""
    }
}

/**
 * Updates the lake [lake] to [logs], which were found below [paths].
 *
 * @param waits whether to wait while another badlog writes to that lake; otherwise, that is an error.
 */
internal fun refreshed(
    service: SeasonService,
    lake: Path,
    paths: List<Path>,
    logs: LogFiles,
    console: Console,
    waits: Boolean = false,
): LakeReport {
    val rules = rulesBeside(paths, console::warn)
    val named = logs.files.map { it to logs.nameOf(it) }
    var hasWarned = false
    val isBusy = {
        if (waits && !hasWarned) console.warn("Another badlog is making tables of the same logs; waiting until it has finished.")
        hasWarned = true
        waits
    }
    return console.progress("lake").use { bar ->
        service.refresh(lake, named, paths, rules, MatchMaker, isBusy) { done, total -> bar.advanced(done.toLong(), total.toLong()) }
    }
}

@Serializable
private class LakeJson(private val written: Boolean) {
    constructor(state: LakeState) : this(state.isWritten)
}
