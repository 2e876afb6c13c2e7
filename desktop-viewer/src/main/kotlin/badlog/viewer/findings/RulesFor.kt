package badlog.viewer.findings

import badlog.report.rules.RuleSet
import badlog.report.rules.RulesException
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/**
 * The rules to run over a log.
 *
 * @property file where they come from; null for those that badlog brings along.
 * @property trouble why a file of rules is not used, as a sentence; null when all is well.
 */
internal class RulesFor private constructor(val set: RuleSet, val file: Path?, val trouble: String?) {
    companion object {
        /** What a file of rules is called. */
        const val NAME = "badlog-rules.toml"

        /**
         * The rules for [log]: those of the nearest file in its folder, or in one above it up to [library], the folder of logs; else
         * badlog's own. The hooks of such a file are never run: it may have come with the logs.
         */
        fun of(log: Path, library: Path?): RulesFor {
            val file = foldersOf(log, library).map { it.resolve(NAME) }.firstOrNull(Files::isRegularFile)
                ?: return RulesFor(RuleSet.DEFAULT, null, null)
            val trouble = try {
                if (Files.size(file) <= LARGEST) return RulesFor(RuleSet.parse(Files.readString(file)), file, null)
                "it is too large."
            } catch (e: RulesException) {
                e.message
            } catch (_: CharacterCodingException) {
                "it is no text in UTF-8."
            } catch (_: IOException) {
                "it cannot be read."
            }
            return RulesFor(RuleSet.DEFAULT, null, "The default rules were run instead of $NAME: $trouble")
        }

        private fun foldersOf(log: Path, library: Path?): Sequence<Path> {
            val top = library?.toAbsolutePath()?.normalize()
            val own = log.parent ?: return emptySequence()
            if (top == null || !own.startsWith(top)) return sequenceOf(own)
            return generateSequence(own) { if (it == top) null else it.parent }
        }

        private const val LARGEST = 1L shl 20
    }
}
