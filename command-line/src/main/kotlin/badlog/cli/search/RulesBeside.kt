package badlog.cli.search

import badlog.rules.BUILT_IN
import badlog.rules.FolderRules
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.signals.vocabulary.SignalVocabulary
import java.nio.file.Files
import java.nio.file.Path

/**
 * Returns the rules beside the logs at [paths], if they are the same for all; otherwise the built-in ones. Mistakes in them are reported.
 */
internal fun rulesBeside(paths: List<Path>, warn: (String) -> Unit): RuleSet {
    val beside = paths.map { FolderRules.of(if (Files.isDirectory(it)) it.resolve(RulesFile.NAME) else it) }
    val rules = beside.distinctBy { it.file to it.rules.signals }.singleOrNull() ?: return RuleSet.BUILT_IN
    rules.problem?.let(warn)
    return rules.rules
}

/** Returns the names of topics in [log], including those from a file beside it. */
internal fun signalsBeside(log: Path): SignalVocabulary = FolderRules.of(log).rules.signals
