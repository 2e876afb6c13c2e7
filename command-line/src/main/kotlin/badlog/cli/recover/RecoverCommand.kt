package badlog.cli.recover

import badlog.cli.SubCommand
import badlog.cli.Task
import badlog.cli.output.OutputOptions
import com.github.ajalt.clikt.parameters.groups.provideDelegate

/** `badlog recover`. */
internal class RecoverCommand :
    SubCommand(
        "recover",
        "Writes a clean log from a damaged one, and says what was lost.",
        "Without --out, the clean log of match.bag is match.recovered.bag, and whole logs are left alone; with it, whole logs " +
            "get their copy, too. Each result is read again to see that it is whole.",
    ) {
    private val output by OutputOptions()

    override fun makeTask(): Task = RecoverTask(paths, output.plan(paths), isJson)
}
