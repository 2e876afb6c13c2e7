package badlog.cli.merge

import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcomes
import badlog.cli.console.Console
import badlog.files.LogMaker
import java.nio.file.Path

/** Returns the result of [work] on what [match] makes of [paths]; if that fails, reports it as a failure of [command]. */
internal fun matched(
    command: String,
    paths: List<Path>,
    match: MatchChoice,
    console: Console,
    isJson: Boolean,
    work: (List<Path>, LogMaker, Console) -> ExitCode,
): ExitCode {
    val (read, maker) = try {
        match.of(paths, console)
    } catch (e: InterruptedException) {
        throw e
    } catch (e: Exception) {
        return Outcomes(command, console, isJson).run {
            failed(paths.first(), LogLoop.sentenceOf(e, paths.first()))
            end()
        }
    }
    return work(read, maker, console)
}
