package badlog.rules

import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/**
 * The rules for the logs of a folder, and what topics are called there.
 *
 * @property rules the rules, with the built-in vocabulary and what the folder adds to it.
 * @property file where they come from; null for the built-in ones.
 * @property problem why a file that lies there is not used, as a sentence, perhaps with the line of the mistake below it; null
 *   when all is well.
 */
public class FolderRules private constructor(public val rules: RuleSet, public val file: Path?, public val problem: String?) {
    public companion object {
        /**
         * The rules for [log]: those of the nearest file called [RulesFile.NAME] in its folder, or in one above it up to [top], which
         * is null for its folder alone; else the built-in ones, also where that file has a mistake. The nearest file called
         * [SignalsFile.NAME] says what else topics are called. The hooks that rules name are never run: they may have come with the logs.
         */
        public fun of(log: Path, top: Path? = null): FolderRules {
            val folders = foldersOf(log.toAbsolutePath().normalize(), top?.toAbsolutePath()?.normalize())
            val signals = nearest(folders, SignalsFile.NAME) { SignalsFile.parse(it) }
            val vocabulary = signals.found?.let(RuleSet.BUILT_IN.signals::with) ?: RuleSet.BUILT_IN.signals
            val rules = nearest(folders, RulesFile.NAME) { RulesFile.parse(it, vocabulary).rules }
            val found = rules.found ?: if (signals.found == null) RuleSet.BUILT_IN else RuleSet.BUILT_IN.with(vocabulary)
            val problems = listOfNotNull(
                rules.problem?.let { "The built-in rules are used instead of ${rules.file}: $it" },
                signals.problem?.let { "The built-in names of signals are used without ${signals.file}: $it" },
            )
            return FolderRules(found, rules.file.takeIf { rules.found != null }, problems.joinToString("\n").ifEmpty { null })
        }

        private class Nearest<T>(val file: Path?, val found: T?, val problem: String?)

        private fun <T> nearest(folders: Sequence<Path>, name: String, parse: (String) -> T): Nearest<T> {
            val file = folders.map { it.resolve(name) }.firstOrNull(Files::isRegularFile) ?: return Nearest(null, null, null)
            val problem = try {
                if (Files.size(file) <= MAX_BYTES) return Nearest(file, parse(Files.readString(file)), null)
                "It is larger than 1 MB; take out what does not belong there."
            } catch (e: RulesException) {
                e.message
            } catch (_: CharacterCodingException) {
                "It is not in UTF-8; save it so in your editor."
            } catch (_: IOException) {
                "It cannot be read; check its permissions."
            }
            return Nearest(file, null, problem)
        }

        private fun foldersOf(log: Path, top: Path?): Sequence<Path> {
            val own = log.parent ?: return emptySequence()
            if (top == null || !own.startsWith(top)) return sequenceOf(own)
            return generateSequence(own) { if (it == top) null else it.parent }
        }

        private const val MAX_BYTES = 1L shl 20
    }
}
