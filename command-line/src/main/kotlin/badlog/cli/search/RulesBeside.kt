package badlog.cli.search

import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.rules.folder.FolderRules
import badlog.signals.vocabulary.SignalVocabulary
import java.nio.file.Files
import java.nio.file.Path

/**
 * Returns the rules beside the logs at [paths], if they are the same for all; otherwise the built-in ones. Mistakes in them are reported.
 */
internal fun rulesBeside(paths: List<Path>, warn: (String) -> Unit): RuleSet {
    val folders = paths.map { it.toAbsolutePath().normalize() }.map { if (Files.isDirectory(it)) it else it.parent }.distinct()
    val beside = folders.map { FolderRules.of(it.resolve(RulesFile.NAME)) }
    val rules = beside.distinctBy { Triple(it.file, it.packs, it.rules.signals) }.singleOrNull() ?: return RuleSet.BUILT_IN
    rules.problem?.let(warn)
    return rules.rules
}

/** Returns the names of topics in [log], including those from a file beside it. */
internal fun signalsBeside(log: Path): SignalVocabulary = FolderRules.of(log).rules.signals
