package badlog.cli.merge

import badlog.catalog.match.MatchMaker
import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcomes
import badlog.cli.console.Console
import badlog.files.LogMaker
import badlog.files.inMadeFolder
import java.nio.file.Path

/** The choice of logs that a command reads as one. */
internal sealed interface MatchChoice {
    /**
     * Returns the result of [work] on the paths to read instead of [paths]. [work] also receives a maker of logs for them.
     *
     * @param outcomes reports logs that cannot be read.
     */
    fun over(paths: List<Path>, console: Console, outcomes: Outcomes, work: (List<Path>, LogMaker) -> ExitCode): ExitCode

    /** Each log is read by itself; a ZIP or a folder of a match is one log. */
    data object AsTheyAre : MatchChoice {
        override fun over(paths: List<Path>, console: Console, outcomes: Outcomes, work: (List<Path>, LogMaker) -> ExitCode): ExitCode =
            work(paths, MatchMaker)
    }

    /** All logs are read as one, with the name of the first. */
    class AllInOne(private val merging: Merging, private val isJson: Boolean) : MatchChoice {
        override fun over(paths: List<Path>, console: Console, outcomes: Outcomes, work: (List<Path>, LogMaker) -> ExitCode): ExitCode =
            inMadeFolder { folder ->
                val reader = PartReader(console, outcomes)
                val merged = try {
                    MergedLog.of(reader.partsOf(paths), merging, folder, console, isJson)
                } catch (e: InterruptedException) {
                    throw e
                } catch (e: Throwable) {
                    outcomes.failed(paths.first(), LogLoop.sentenceOf(e, paths.first()))
                    return@inMadeFolder outcomes.end()
                }
                outcomes.listSkipped()
                val code = work(listOf(merged.first), merged)
                if (reader.hasFailed && code == ExitCode.WHOLE) ExitCode.SALVAGED else code
            }
    }

    /** Each robot's log is read with the Driver Station log of its match, if that is found. */
    class EachBeside(private val merging: Merging, private val isJson: Boolean) : MatchChoice {
        override fun over(paths: List<Path>, console: Console, outcomes: Outcomes, work: (List<Path>, LogMaker) -> ExitCode): ExitCode =
            work(paths, LogBesideStation(merging, isJson, console::warn))
    }
}

/** Runs [work] on the paths that [match] selects in place of [paths], and returns its exit code. Reports failures as those of [command]. */
internal fun matched(
    command: String,
    paths: List<Path>,
    match: MatchChoice,
    console: Console,
    isJson: Boolean,
    work: (List<Path>, LogMaker, Console) -> ExitCode,
): ExitCode = match.over(paths, console, Outcomes(command, console, isJson)) { read, maker -> work(read, maker, console) }
