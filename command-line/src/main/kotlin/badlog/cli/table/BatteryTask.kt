package badlog.cli.table

import badlog.cli.command.ExitCode
import badlog.cli.command.LogFiles
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.ResultForm
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.console.Spelling
import badlog.report.BatteryJson
import badlog.report.SeasonOfLogs
import badlog.report.batteryCsv
import badlog.report.batteryText
import badlog.viewer.catalog.Content
import badlog.viewer.shown.battery.BatteryAdvice
import kotlinx.serialization.json.Json
import java.nio.file.Path

/** Makes a table of all logs below [paths], with a row for each battery. The folder [cache] keeps results; null for none. */
internal class BatteryTask(private val paths: List<Path>, private val cache: Path?, private val form: ResultForm) : Task {
    override fun run(console: Console): ExitCode {
        val logs = LogFiles(paths, console)
        val season = console.progress("table").use { bar ->
            SeasonOfLogs.over(logs.files, paths, cache) { done, total -> bar.advanced(done.toLong(), total.toLong()) }
        }
        if (season.seasons.isNotEmpty()) say(season, console)
        season.problems.forEach(console::warn)
        if (logs.files.isNotEmpty() && !season.hasNames) console.warn(if (season.seasons.isEmpty()) NO_BATTERY else NO_NAME)
        val outcomes = Outcomes("table", console, isJson = false, isSummed = true)
        val summaryOf = season.entries.associate { it.source to it.summary }
        logs.report(outcomes) { input, file ->
            val summary = summaryOf.getValue(file)
            val trouble = summary.trouble
            if (trouble == null) {
                outcomes.done(input.file, Outcome(isSalvaged = summary.problems.errors > 0, "", emptyMap()))
            } else {
                outcomes.unreadable(input, trouble, isNoLog = summary.content == Content.NO_LOG)
            }
        }
        return outcomes.end()
    }

    private fun say(season: SeasonOfLogs, console: Console) {
        when (form) {
            ResultForm.TEXT -> console.say(batteryText(season.seasons, console.width))

            ResultForm.CSV -> console.say(batteryCsv(season.seasons).trimEnd())

            ResultForm.JSON -> {
                val advice = BatteryAdvice.of(season.seasons)
                for (each in season.seasons) {
                    console.say(
                        Spelling.ascii(Json.encodeToString(BatteryJson.serializer(), BatteryJson(each, advice.of(each)))),
                    )
                }
            }
        }
    }
}

private const val NO_BATTERY = "No log shows its battery; “badlog info --signals” says which topics badlog looks for."
private const val NO_NAME =
    "No log says which battery was in the robot: let it log a value “Battery Name”, or write it into batteries.toml beside the logs."
