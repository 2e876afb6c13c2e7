package badlog.cli.search

import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.path

/** The options of all commands that run rules. */
internal class SearchOptions : OptionGroup() {
    private val rules by option("--rules", metavar = "FILE").path()
        .help("Rules in TOML, or “${Search.DEFAULT_RULES}” for the built-in ones.")
    private val isWithoutRules by option("--no-rules").flag().help("No rules at all.")

    /** Returns the requested search, with [hooks] and the virtual topics [virtualTopics]. */
    fun search(hooks: HookOptions, virtualTopics: List<String>): Search {
        if (isWithoutRules && rules != null) throw UsageError("--rules and --no-rules cannot be used together")
        return Search(rules, isWithoutRules, hooks.runners, virtualTopics)
    }
}
