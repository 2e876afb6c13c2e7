package badlog.rules.folder

import badlog.rules.BUILT_IN
import badlog.rules.NearestFile
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.rules.SignalsFile
import badlog.rules.pack.PackException
import badlog.rules.pack.RulePack
import badlog.rules.pack.and
import badlog.rules.pack.requireFree
import badlog.signals.vocabulary.SignalVocabulary
import java.nio.file.Files
import java.nio.file.Path

/**
 * The rules for the logs of a folder, and the names of topics and devices there.
 *
 * @property rules the rules, with the built-in vocabulary and the folder's additions.
 * @property file the file that they come from; null for the built-in ones.
 * @property packs the packs with rules that are added to them.
 * @property problem why an existing file or pack is not used, as a sentence, with the line of the mistake below it if there is one; null if all is
 *   well.
 */
class FolderRules private constructor(val rules: RuleSet, val file: Path?, val packs: List<Path>, val problem: String?) {
    companion object {
        /**
         * Returns the rules for [log]. They come from the nearest file called [RulesFile.NAME], in its folder or in one above it up to
         * [top]; only in its folder if [top] is null. Without such a file, or if it has a mistake, the built-in rules are used. The packs
         * in the nearest folder with packs add their rules. The nearest file called [SignalsFile.NAME] adds names of topics. Hooks in these
         * rules are never run, because they may have come with the logs.
         */
        fun of(log: Path, top: Path? = null): FolderRules {
            fun <T> nearest(name: String, parse: (String) -> T) =
                NearestFile.of(log, top, { it.resolve(name).takeIf(Files::isRegularFile) }, parse)
            val packs = ReadPacks(NearestFile.foldersOf(log, top).map(::packsIn).firstOrNull { it.isNotEmpty() }.orEmpty())
            val signals = nearest(SignalsFile.NAME) { SignalsFile.parse(it) }
            // The topics of the folder itself come first.
            val added = packs.read.map { it.signals }.filter { it !== SignalVocabulary.NONE } + listOfNotNull(signals.found)
            val vocabulary = added.fold(RuleSet.BUILT_IN.signals) { all, own -> all.with(own) }
            val rules = nearest(RulesFile.NAME) { RulesFile.parse(it, vocabulary).rules }
            val found = rules.found ?: if (added.isEmpty()) RuleSet.BUILT_IN else RuleSet.BUILT_IN.with(vocabulary)
            val used = packs.usableWith(found)
            val problems = listOfNotNull(
                rules.problem?.let { "The built-in rules are used instead of ${rules.file}: $it" },
                signals.problem?.let { "The built-in names of signals are used without ${signals.file}: $it" },
            ) + packs.problems
            return FolderRules(
                found.and(used),
                rules.file.takeIf { rules.found != null },
                used.map { it.path },
                problems.joinToString("\n").ifEmpty { null },
            )
        }
    }
}

/** The packs at [paths], without their slices. */
private class ReadPacks(paths: List<Path>) {
    val problems = ArrayList<String>()

    /** The packs that can be read. */
    val read: List<RulePack> = paths.mapNotNull { path -> attempt { RulePack.open(path).apply { close() } } }

    /** Returns the packs with names that contradict neither each other nor [rules]. */
    fun usableWith(rules: RuleSet): List<RulePack> = read.fold(emptyList()) { used, pack ->
        used + listOfNotNull(attempt { pack.also { rules.requireFree(it, used) } })
    }

    private fun <T> attempt(work: () -> T): T? = try {
        work()
    } catch (e: PackException) {
        problems += "A pack of rules is not used: ${e.message}"
        null
    }
}
