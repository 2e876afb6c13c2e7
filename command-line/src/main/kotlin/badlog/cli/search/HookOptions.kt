package badlog.cli.search

import badlog.report.hook.HookRunner
import badlog.rules.commandWords
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.validate
import com.github.ajalt.clikt.parameters.types.double
import kotlin.time.Duration.Companion.seconds

/** The options of all commands that run hooks. */
internal class HookOptions : OptionGroup() {
    private val hooks by option("--hook", metavar = "COMMAND").convert { text ->
        try {
            commandWords(text)
        } catch (e: IllegalArgumentException) {
            fail(e.message.orEmpty())
        }
    }.multiple().help("Run this program for each log, see docs/hooks.md.")
    private val hookSeconds by option("--hook-seconds", metavar = "N").double()
        .help("Seconds a hook may take per log; default: ${HookRunner.DEFAULT_TIME_LIMIT.inWholeSeconds}.")
        .validate { if (!(it > 0)) fail("must be above 0") }

    /** The programs to run. */
    val runners: List<HookRunner> get() = hooks.map { HookRunner(it, hookSeconds?.seconds ?: HookRunner.DEFAULT_TIME_LIMIT) }
}
