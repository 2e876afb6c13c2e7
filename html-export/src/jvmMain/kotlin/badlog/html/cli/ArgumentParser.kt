package badlog.html.cli

import badlog.html.BADLOG_VERSION
import picocli.CommandLine
import picocli.CommandLine.Help
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Model.OptionSpec
import picocli.CommandLine.Model.PositionalParamSpec
import picocli.CommandLine.ParameterException
import java.nio.file.Path

/** Reads the command line. Built without annotations: looking those up would take longer than most exports. */
internal class ArgumentParser {
    /** What the command line asks for: to do something, or to say something and end. */
    sealed interface Result {
        /** Make pages. */
        class Run(val arguments: Arguments) : Result

        /** Print [text], which was asked for. */
        class Say(val text: String) : Result

        /** Print why the arguments make no sense. */
        class Refuse(val text: String) : Result
    }

    /** Reads [arguments]. */
    fun parse(arguments: List<String>): Result {
        val command = CommandLine(spec()).setUsageHelpAutoWidth(false).setUsageHelpWidth(WIDTH)
        return try {
            val parsed = command.parseArgs(*arguments.toTypedArray())
            when {
                parsed.isUsageHelpRequested -> Result.Say(command.getUsageMessage(Help.Ansi.OFF).trimEnd())
                parsed.isVersionHelpRequested -> Result.Say("badlog-html $BADLOG_VERSION")
                else -> Result.Run(
                    Arguments(
                        paths = parsed.matchedPositionalValue(0, emptyArray<Path>()).toList(),
                        outFolder = parsed.matchedOptionValue<Path?>("--out", null),
                        attachments = parsed.matchedOptionValue("--attach", emptyArray<Path>()).toList(),
                        opensPage = parsed.hasMatchedOption("--open"),
                    ),
                )
            }
        } catch (e: ParameterException) {
            Result.Refuse("${e.message}\nTry: badlog-html --help")
        }
    }

    private fun spec(): CommandSpec {
        val spec = CommandSpec.create().name("badlog-html").addPositional(paths())
        spec.usageMessage()
            .customSynopsis(
                "badlog-html [OPTION]... INPUT [OUTPUT]",
                "   or: badlog-html [OPTION]... [--out=DIR] INPUT...",
            )
            .description("%nMakes a web page of each log: a page that opens from disk and needs nothing else.%n")
            .footer(
                "",
                "Exit code: 0 all is whole, 3 something was salvaged or left out, 1 there is no page, 2 wrong usage.",
            )
        OPTIONS.forEach { (names, text) -> spec.addOption(flag(names, text).build()) }
        spec.addOption(flag(listOf("-h", "--help"), "Print this text.").usageHelp(true).build())
        spec.addOption(flag(listOf("-V", "--version"), "Print the version.").versionHelp(true).build())
        spec.addOption(
            flag(listOf("-a", "--attach"), "Include this file in the results; may be given again.")
                .arity("1").type(Array<Path>::class.java).paramLabel("FILE").build(),
        )
        spec.addOption(
            flag(listOf("--out"), "Put the pages into this folder, which is made if need be.")
                .arity("1").type(Path::class.java).paramLabel("DIR").build(),
        )
        return spec
    }

    private fun flag(names: List<String>, text: String): OptionSpec.Builder =
        OptionSpec.builder(names.toTypedArray()).description(text)

    private fun paths() = PositionalParamSpec.builder()
        .arity("1..*").type(Array<Path>::class.java).paramLabel("INPUT")
        .description(
            "A bag or a CSV file, also gzipped: its content decides, not its name. Of a folder, every log that is right in " +
                "it. The page is INPUT.html beside it; or OUTPUT, when that ends in .html or does not exist yet.",
        )
        .build()

    private companion object {
        const val WIDTH = 100

        val OPTIONS = listOf(
            listOf("-t", "--trim-doubles") to "Retry parsing doubles without whitespace. Now always so.",
            listOf("-c", "--csv") to "Input is CSV file. Now found out from its content.",
            listOf("-g", "--gzip") to "Compress embedded CSV file. Now always so.",
            listOf("-o", "--open") to "Open resulting HTML in default browser; of several, that of the newest input.",
        )
    }
}
