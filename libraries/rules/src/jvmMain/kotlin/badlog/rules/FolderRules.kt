package badlog.rules

import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/**
 * The rules for the logs of a folder.
 *
 * @property file where they come from; null for the built-in ones.
 * @property problem why the file that lies there is not used, as a sentence, perhaps with the line of the mistake below it; null
 *   when all is well.
 */
public class FolderRules private constructor(public val rules: RuleSet, public val file: Path?, public val problem: String?) {
    public companion object {
        /**
         * The rules for [log]: those of the nearest file called [RulesFile.NAME] in its folder, or in one above it up to [top], which
         * is null for its folder alone; else the built-in ones, also where that file has a mistake. The hooks that it names are
         * never run: it may have come with the logs.
         */
        public fun of(log: Path, top: Path? = null): FolderRules {
            val file = foldersOf(log.toAbsolutePath().normalize(), top?.toAbsolutePath()?.normalize())
                .map { it.resolve(RulesFile.NAME) }.firstOrNull(Files::isRegularFile)
                ?: return FolderRules(RuleSet.BUILT_IN, null, null)
            val problem = try {
                if (Files.size(file) <= MAX_BYTES) return FolderRules(RulesFile.parse(Files.readString(file)).rules, file, null)
                "It is larger than 1 MB; take out what is not a rule."
            } catch (e: RulesException) {
                e.message
            } catch (_: CharacterCodingException) {
                "It is not in UTF-8; save it so in your editor."
            } catch (_: IOException) {
                "It cannot be read; check its permissions."
            }
            return FolderRules(RuleSet.BUILT_IN, null, "The built-in rules are used instead of $file: $problem")
        }

        private fun foldersOf(log: Path, top: Path?): Sequence<Path> {
            val own = log.parent ?: return emptySequence()
            if (top == null || !own.startsWith(top)) return sequenceOf(own)
            return generateSequence(own) { if (it == top) null else it.parent }
        }

        private const val MAX_BYTES = 1L shl 20
    }
}
