package badlog.cli.pack

import badlog.cli.command.LogLoop
import badlog.cli.input.Failure
import badlog.cli.input.readLog
import badlog.core.analysis.LogView
import badlog.files.NotReadException
import badlog.files.safeName
import badlog.rules.LogFindings
import badlog.rules.over
import badlog.rules.pack.PackException
import badlog.rules.pack.RulePack
import badlog.signals.overItsTime
import java.nio.file.Files

/**
 * The result of a rule in a slice.
 *
 * @property rule the name of the rule; null if there is none for the slice.
 * @property text the result and its reason, as a sentence or more.
 * @property passes whether the slice demands this result.
 * @property isMistake whether the rule itself is wrong.
 */
internal class SliceVerdict(
    val slice: RulePack.Slice,
    val rule: String?,
    val text: String,
    val passes: Boolean,
    val isMistake: Boolean = false,
)

/** Runs the rules of [pack], together with the built-in ones, over its slices. */
internal class SliceCheck(private val pack: RulePack) {
    private val rules = pack.withBuiltIn
    private val ruleOfFolder = rules.rules.associate { folderOf(it.name).lowercase() to it.name }

    /** Returns whether [slice] is for the rule [rule]. */
    fun isFor(slice: RulePack.Slice, rule: String): Boolean = ruleOfFolder[slice.folder.lowercase()] == rule

    /** Returns the verdict on [slice]. */
    fun verdict(slice: RulePack.Slice): SliceVerdict {
        val rule = ruleOfFolder[slice.folder.lowercase()]
            ?: return SliceVerdict(
                slice,
                null,
                "There is no rule “${slice.folder}”; give the folder the name of a rule.",
                passes = false,
            )
        return try {
            verdict(slice, rule, found(slice))
        } catch (e: Failure) {
            SliceVerdict(slice, rule, e.message, passes = false)
        }
    }

    private fun verdict(slice: RulePack.Slice, rule: String, found: LogFindings): SliceVerdict {
        val skipped = found.skipped.find { it.rule == rule }
        val texts = found.findings.filter { it.rule == rule }.map { it.text }
        return when {
            skipped != null -> SliceVerdict(slice, rule, "The rule could not run: ${skipped.message}", passes = false, skipped.isMistake)
            texts.isEmpty() -> SliceVerdict(slice, rule, "It found nothing.", passes = !slice.isFiring)
            else -> SliceVerdict(slice, rule, texts.first() + moreThan(texts.size - 1), passes = slice.isFiring)
        }
    }

    private fun moreThan(more: Int) = if (more == 0) "" else " And $more more."

    /** A file of its own, since logs are read from files; its name comes from the kind of log alone. */
    private fun found(slice: RulePack.Slice): LogFindings {
        val name = slice.name.substringAfterLast('/')
        val file = Files.createTempFile("badlog-slice", "." + name.substringAfterLast('.').lowercase())
        try {
            Files.write(file, pack.bytesOf(slice))
            val recording = readLog(file, { _, _ -> })
            return rules.over(LogView.of(recording.overItsTime()), name)
        } catch (e: NotReadException) {
            if (e.why.isLasting) throw Failure("“${slice.name}” is not a log; cut a new slice from one.")
            throw Failure(e.why.sentence.replace("$file", slice.name))
        } catch (e: PackException) {
            throw Failure(e.message)
        } catch (e: Exception) {
            throw Failure(LogLoop.sentenceOf(e, file).replace("$file", slice.name))
        } finally {
            Files.deleteIfExists(file)
        }
    }

    companion object {
        /** Returns the name of the folder with the slices of [rule]. */
        fun folderOf(rule: String): String = safeName(rule)
    }
}
