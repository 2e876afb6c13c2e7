package badlog.cli.search

import badlog.report.hook.HookRunner
import badlog.rules.commandWords
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.validate
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.path
import kotlin.time.Duration.Companion.seconds

/** Options of everything that looks for something in logs by rules and programs. */
internal class SearchOptions : OptionGroup() {
    private val rules by option("--rules", metavar = "FILE").path()
        .help("Rules in TOML, or “${Search.DEFAULT_RULES}” for the built-in ones.")
    private val isWithoutRules by option("--no-rules").flag().help("No rules at all.")
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

    /** What they ask for, where logs also have the topics of [virtualTopics]. */
    fun search(virtualTopics: List<String>): Search {
        val limit = hookSeconds?.seconds ?: HookRunner.DEFAULT_TIME_LIMIT
        if (isWithoutRules && rules != null) throw UsageError("--rules and --no-rules exclude each other")
        return Search(rules, isWithoutRules, hooks.map { HookRunner(it, limit) }, virtualTopics)
    }
}
